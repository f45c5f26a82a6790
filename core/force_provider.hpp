// The plug-in interface: everything that pushes on a node. A provider adds to f, never assigns, never moves a
// node.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// Where arrays live.
enum class Space { host, device };

/// What a provider sees of a step: the state at time t, from which forces of time t are wanted.
template <class R>
struct StepView {
  const Vec4<R>* u = nullptr;  ///< displacement [m]                           [node_count]
  const Vec4<R>* v = nullptr;  ///< velocity at t - dt/2 [m/s]; w: 1/mass      [node_count]
  const Vec4<R>* u_predicted =
      nullptr;           ///< displacement at t + dt without this force [m]; only if needs_prediction()
  Vec4<R>* f = nullptr;  ///< force [N]: add                             [node_count]
  int node_count = 0;
  std::int64_t step = 0;
  double t = 0, dt = 0;  ///< [s]
  double t_next = 0;  ///< time of the displacement that these forces lead to: t + dt, or the pseudo time of a
                      ///< static run [s]
  R advance_per_force = R(0);  ///< u(t + dt) changes by advance_per_force * f / mass [s^2]
  bool advance = true;       ///< false: evaluate only; material history and accumulated work stay as they are
  bool monitor = false;      ///< true: accumulate work (energy())
  double strain_energy = 0;  ///< of time t if springs have a cap, else of the last energy account [J]
  void* stream = nullptr;
};

/// The same step in another precision, without its arrays, their length and the stream.
template <class To, class From>
StepView<To> without_arrays(const StepView<From>& step) {
  StepView<To> its;
  its.step = step.step;
  its.t = step.t;
  its.dt = step.dt;
  its.t_next = step.t_next;
  its.advance_per_force = To(step.advance_per_force);
  its.advance = step.advance;
  its.monitor = step.monitor;
  its.strain_energy = step.strain_energy;
  return its;
}

/// What a provider may read once, when it is added to a simulation.
struct Attachment {
  std::span<const Vec3<double>> X;        ///< rest position [m], in the provider's numbering  [node_count]
  std::span<const double> mass;           ///< lumped mass [kg]                                [node_count]
  std::span<const int> internal_of_user;  ///< node index in StepView of a user's node         [node_count]
};

/// Native providers are ForceProvider<R> of the simulation's own R and Space and see internal node numbers. A
/// provider of a user is a ForceProvider<double> on the host: the engine mirrors u, v and f for it in the
/// user's own node numbers, whatever device and precision the run has, and reports what that costs.
template <class R>
class ForceProvider {
 public:
  virtual ~ForceProvider() = default;
  virtual std::string_view name() const = 0;
  virtual Space space() const { return Space::host; }
  virtual void attach(const Attachment&) {}
  /// Largest stable step that this provider allows [s].
  virtual double stable_step() const { return std::numeric_limits<double>::infinity(); }
  virtual bool needs_prediction() const { return false; }
  /// Internal nodes whose prediction it looks at; empty: all. Others may not be predicted.
  virtual std::vector<int> nodes_to_predict() const { return {}; }
  /// Whether those after it need a prediction that has this force in it.
  virtual bool moves_prediction() const { return false; }
  /// Whether it needs a prediction that has the forces of those before it in it.
  virtual bool needs_forces_before() const { return false; }
  virtual void add_forces(const StepView<R>& step) = 0;
  /// Work done on the nodes since the start [J]; 0 for providers that do not say.
  virtual double work() const { return 0; }
  /// State that a restart must restore; load gets what save gave.
  virtual std::vector<std::byte> save() const { return {}; }
  virtual void load(std::span<const std::byte>) {}
};

}  // namespace glisson
