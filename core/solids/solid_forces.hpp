// All solid elements of a model as one force provider; each backend brings its own implementation.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glisson/core/force_provider.hpp>
#include <glisson/core/kernels/shared_forces.hpp>
#include <glisson/core/model.hpp>
#include <glisson/core/numbering.hpp>
#include <glisson/core/pending_sum.hpp>
#include <glisson/core/result_fields.hpp>

namespace glisson {

template <class R>
class SolidForces : public ForceProvider<R> {
 public:
  std::string_view name() const override { return "solids"; }
  /// As add_forces(), but may leave parts to whoever visits the nodes next; says which.
  virtual SharedForces<R> add_all_but_shared(const StepView<R>& step) {
    this->add_forces(step);
    return {};
  }
  /// Energy of the laws (W itself) and of the hourglass control [J], for the displacement of `step`; sums in
  /// double. Both may be pending.
  virtual PendingSum strain_energy(const StepView<R>& step) = 0;
  virtual PendingSum hourglass_energy(const StepView<R>& step) = 0;
  /// The part of the last strain energy that is in membranes and shells [J]; waits for a device.
  virtual double shell_energy() const { return 0; }
  /// Prony history in the canonical order: for each section, each of its elements in order, each integration
  /// point, each term (isochoric, then volumetric), six components 11 22 33 12 23 13 [Pa]. Empty without
  /// Prony terms.
  virtual std::vector<double> history() const = 0;
  virtual void set_history(const std::vector<double>& history) = 0;
  virtual std::size_t memory_bytes() const = 0;
  /// For the displacement u [m] in the user's order [node_count]; dt [s] as in element_fields().
  virtual ShellFields shell_fields(const Model&, std::span<const Vec3<double>> /*u*/, double /*dt*/) const {
    return {};
  }
};

}  // namespace glisson
