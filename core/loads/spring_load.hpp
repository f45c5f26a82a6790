// Springs that pull nodes to target displacements: penalty displacements of Johnsen 2016, eq. 3.14 and 3.15.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <glisson/core/loads/list_forces.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson {

/// f = k(t) (u_target(t) - u), Johnsen 2016, eq. 3.14.
template <class R>
struct SpringForce : LastForces<R> {
  const Vec4<R>*
      springs;       ///< xyz: target at amplitude 1 [m]; w: stiffness at amplitude 1 [N/m]  [entry_count]
  const Vec4<R>* u;  ///< displacement [m]  [node_count]
  R stiffness_amplitude, target_amplitude;

  GLISSON_HD Vec3<R> force(int i, int n) const {
    const Vec4<R> s = springs[i];
    return (stiffness_amplitude * s.w) * (target_amplitude * xyz(s) - xyz(u[n]));
  }
};

/// Two springs on one node act like one with the summed stiffness and the stiffness-weighted target.
template <Backend B, class R>
class SpringLoad final : public ForceProvider<R> {
 public:
  /// mass: inertial mass [kg] in internal order [node_count].
  SpringLoad(B& backend, const Springs& load, const Numbering& numbering, std::span<const double> mass)
      : SpringLoad(backend, load, entries_of(load, numbering), mass) {}

  std::string_view name() const override { return "springs"; }
  Space space() const override { return B::space; }
  double stable_step() const override { return stable_step_; }
  void add_forces(const StepView<R>& step) override {
    // eq. 3.15: the stiffness of the last step is kept while the strain energy is at or above the cap
    const bool frozen = cap_ && !(step.strain_energy < *cap_);
    const double amplitude = frozen ? amplitude_ : curve_(step.t);
    work_.run(step, nodes_.get(),
              SpringForce<R>{{last_.get()}, springs_.get(), step.u, R(amplitude), R(target_curve_(step.t))});
    if (step.advance) amplitude_ = amplitude;
  }
  /// Amplitude of the stiffness of the last step [-].
  double stiffness_amplitude() const { return amplitude_; }
  double work() const override { return work_.total(); }
  std::vector<std::byte> save() const override {
    detail::ByteWriter out;
    work_.save(out.value(amplitude_).buffer(backend_, last_, count_));
    return out.take();
  }
  void load(std::span<const std::byte> bytes) override {
    detail::ByteReader in(bytes, "springs");
    in.value(amplitude_);
    in.buffer(backend_, last_, count_);
    work_.load(in);
    in.end();
  }

 private:
  struct Spring {
    double stiffness;
    Vec3<double> pull;  ///< stiffness times target [N]
  };
  using Entries = std::map<int, Spring>;

  static Entries entries_of(const Springs& load, const Numbering& numbering) {
    const auto make = [&](std::size_t k) {
      const double stiffness = detail::value_of(load.stiffness, k, load.nodes.size(), "spring stiffnesses");
      return Spring{stiffness,
                    stiffness * detail::value_of(load.targets, k, load.nodes.size(), "spring targets")};
    };
    return detail::by_node<Spring>(numbering, load.nodes, make, [](Spring& sum, const Spring& more) {
      sum = {sum.stiffness + more.stiffness, sum.pull + more.pull};
    });
  }
  static std::vector<Vec4<R>> springs_of(const Entries& entries) {
    std::vector<Vec4<R>> result;
    for (const auto& [node, s] : entries) {
      Vec4<R> spring = detail::narrow<R>((s.stiffness > 0 ? 1 / s.stiffness : 0) * s.pull);
      spring.w = R(s.stiffness);
      result.push_back(spring);
    }
    return result;
  }
  /// 2 sqrt(m / k) for the stiffest spring; the frequency of the elements adds: 1/dt^2 >= 1/dt_el^2 +
  /// 1/dt_spring^2.
  static double stable_step_of(const LoadCurve& curve, const Entries& entries, std::span<const double> mass) {
    double amplitude = 1, ratio = 0;
    if (curve.shape == LoadShape::table) {
      amplitude = 0;
      for (const auto& [t, value] : curve.table) amplitude = std::max(amplitude, value);
    }
    for (const auto& [node, s] : entries)
      if (s.stiffness > 0) ratio = std::max(ratio, amplitude * s.stiffness / mass[std::size_t(node)]);
    return ratio > 0 ? 2 / std::sqrt(ratio) : std::numeric_limits<double>::infinity();
  }
  SpringLoad(B& backend, const Springs& load, const Entries& entries, std::span<const double> mass)
      : backend_(backend),
        curve_(load.curve),
        target_curve_(load.target_curve),
        cap_(load.strain_energy_cap),
        count_(entries.size()),
        nodes_(detail::upload(backend, detail::keys(entries))),
        springs_(detail::upload(backend, springs_of(entries))),
        last_(detail::zeros<Vec4<R>>(backend, count_)),
        work_(backend, static_cast<int>(count_)),
        stable_step_(stable_step_of(curve_, entries, mass)) {}

  B& backend_;
  LoadCurve curve_, target_curve_;
  std::optional<double> cap_;  ///< [J]
  std::size_t count_;
  Buffer<int> nodes_;
  Buffer<Vec4<R>> springs_, last_;
  ListWork<B, R> work_;
  double stable_step_;  ///< [s]
  double amplitude_ = 0;
};

}  // namespace glisson
