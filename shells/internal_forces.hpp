// Membranes and shells together with the solids of a model, as the one provider of internal forces.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glisson/core/solids/solid_forces.hpp>
#include <glisson/shells/shell_fields.hpp>

namespace glisson::shells {

/// What every implementation of the shells shares: the solids come first, in forces, energy and history.
template <class R>
class InternalForces : public SolidForces<R> {
 public:
  /// solids: those of the same model; null when it has none.
  explicit InternalForces(std::unique_ptr<SolidForces<R>> solids) : solids_(std::move(solids)) {}

  void add_forces(const StepView<R>& step) override {
    if (solids_) solids_->add_forces(step);
    add_shell_forces(step);
  }
  SharedForces<R> add_all_but_shared(const StepView<R>& step) override {
    if (!solids_) return add_shells_but_shared(step);
    const SharedForces<R> left = solids_->add_all_but_shared(step);
    add_shell_forces(step);  // only one provider can leave something
    return left;
  }
  PendingSum strain_energy(const StepView<R>& step) override {
    shell_energy_ = energy_of_shells(step);
    if (solids_) solid_energy_ = solids_->strain_energy(step);
    return PendingSum([this] { return solid_energy_.read() + shell_energy_.read(); });
  }
  double shell_energy() const override { return shell_energy_.read(); }
  PendingSum hourglass_energy(const StepView<R>& step) override {
    return solids_ ? solids_->hourglass_energy(step) : PendingSum();
  }
  /// The solids' history, then [section][element][term][3] of the shells.
  std::vector<double> history() const override {
    std::vector<double> all = solids_ ? solids_->history() : std::vector<double>{};
    const std::size_t solid = all.size();
    all.resize(solid + shell_history_size());
    get_shell_history(all.data() + solid);
    return all;
  }
  void set_history(const std::vector<double>& history) override {
    const auto solid = static_cast<std::ptrdiff_t>(history.size() - shell_history_size());
    if (solids_) solids_->set_history({history.begin(), history.begin() + solid});
    set_shell_history(history.data() + solid);
  }
  ShellFields shell_fields(const Model& model, std::span<const Vec3<double>> u, double dt) const override {
    std::vector<double> own(shell_history_size());
    get_shell_history(own.data());
    return shells::shell_fields(model, u, own, dt);
  }
  std::size_t memory_bytes() const override {
    return shell_bytes() + (solids_ ? solids_->memory_bytes() : 0);
  }

 protected:
  virtual void add_shell_forces(const StepView<R>& step) = 0;
  /// As add_all_but_shared() of the shells alone.
  virtual SharedForces<R> add_shells_but_shared(const StepView<R>& step) {
    add_shell_forces(step);
    return {};
  }
  virtual PendingSum energy_of_shells(const StepView<R>& step) = 0;
  virtual std::size_t shell_history_size() const = 0;
  virtual void get_shell_history(double* values) const = 0;
  virtual void set_shell_history(const double* values) = 0;
  virtual std::size_t shell_bytes() const = 0;

 private:
  std::unique_ptr<SolidForces<R>> solids_;
  PendingSum solid_energy_, shell_energy_;  ///< of the last strain_energy() [J]
};

}  // namespace glisson::shells
