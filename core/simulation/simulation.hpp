// The time loop. Everything that exerts a force is in one list; the state lives in the backend's memory.
// Included only by the instantiation files in run/, one per backend and precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <glisson/core/any_simulation.hpp>
#include <glisson/core/constraints/constraints.hpp>
#include <glisson/core/materials/shell_law_table.hpp>
#include <glisson/core/simulation/energy_monitor.hpp>
#include <glisson/core/simulation/failure.hpp>
#include <glisson/core/simulation/node_state.hpp>
#include <glisson/core/simulation/parts.hpp>
#include <glisson/core/simulation/power_iteration.hpp>
#include <glisson/core/simulation/relaxation.hpp>
#include <glisson/core/simulation/step_plan.hpp>
#include <glisson/core/simulation/user_forces.hpp>
#include <glisson/core/solids/element_fields.hpp>
#include <glisson/core/solids/section_laws.hpp>
#include <glisson/core/steppers/steppers.hpp>

namespace glisson {

template <Backend B, class R>
class Simulation final : public AnySimulation {
 public:
  /// The model must outlive the simulation.
  Simulation(const Model& model, SimulationParts<B, R> parts);

  void step(std::int64_t count) override;
  bool finished() const override;
  std::int64_t step_count() const override { return step_; }
  double time() const override;
  StepReport report() const override;
  Energies energies() override { return monitor_.last(); }
  AccountReport last_account() const override {
    return {healthy_step_ - 1, monitor_.last_time(), largest_displacement_};
  }
  void watch_largest_displacement() override { watched_.emplace(backend_, nodes_.count()); }
  std::array<double, 2> residuals() const override;
  std::vector<Vec3<double>> displacement() const override;
  std::vector<Vec3<double>> velocity() const override;
  std::vector<Vec3<double>> internal_force() const override;
  ElementFieldSource element_field_source() const override;
  ShellFields shell_fields() const override;
  std::vector<NamedContact> contacts() const override;
  std::vector<Vec3<double>> contact_force() const override;
  void add(std::unique_ptr<ForceProvider<double>> provider) override;
  void save(std::ostream& out) const override;
  void load(std::istream& in) override;
  std::string device() const override { return parts_.device; }
  std::size_t memory_bytes() const override;

 private:
  // simulation_step.ipp
  void one_step();
  SharedForces<R> add_forces(StepView<R>& view, bool may_leave);
  void predict(const StepView<R>& view) const;
  void predict_and_touch(StepView<R>& view) const;
  bool sweeps() const;
  void sweep(const StepView<R>& view, const SharedForces<R>& left, bool energies);
  void react_and_advance(StepView<R>& view, bool energies);
  void advance(bool energies);
  template <class S, class Nodes>
  void advance_with_energies(const Nodes& nodes, bool all);
  template <class F>
  void with_stepper(F&& use) const;
  StepView<R> make_view() const;
  double load_time(std::int64_t step) const;
  // simulation_checks.ipp
  std::string limiter() const;
  void choose_step();
  double stable_step_now(int iterations);
  void review();
  void recheck_stable_step();
  std::int64_t recheck_interval() const;
  Energies read_energies() const;
  void account(double t);
  void keep_healthy();
  [[noreturn]] void fail(const Energies* unbalanced, double share);
  // simulation_state.ipp
  void set_initial_velocity();
  void list_predicted_nodes();
  std::vector<Vec3<double>> forces_for_user(bool with_loads) const;

  const Model& model_;
  SimulationParts<B, R> parts_;
  B& backend_;
  NodeState<B, R> nodes_;
  EnergyMonitor<B, R> monitor_;
  PowerIteration<B, R> power_;
  std::optional<DynamicRelaxation<B, R>> relaxation_;
  std::optional<LargestLength<B, R>> watched_;  ///< displacement of accounts
  std::vector<std::unique_ptr<UserForces<B, R>>> users_;
  Buffer<Vec4<R>> u_predicted_;  ///< only with contact
  Buffer<int> predicted_nodes_;  ///< nodes that contact looks at; all if there are none here
  int predicted_count_ = 0;
  Buffer<Vec4<R>> healthy_;  ///< u after the last check that passed, from the next step on [m]
  StepPlan plan_;
  std::int64_t step_ = 0;
  std::int64_t monitor_every_ = 1;  ///< steps between two energy accounts
  std::int64_t next_recheck_ = 0;   ///< step of the next estimate of the stable step
  std::int64_t healthy_step_ = 0;   ///< steps before that; 0: none
  Stepper stepper_ = Stepper::central_difference;
  bool prony_ = false;                               ///< some material has a memory
  bool capped_ = false;                              ///< some springs have a strain-energy cap
  bool one_sided_ = false;                           ///< some shell is stiffer in tension from rest on
  double strain_energy_ = 0;                         ///< of the last evaluation [J]
  PendingSum strain_sum_, hourglass_sum_;            ///< of the present account [J]
  double largest_displacement_ = 0;                  ///< of the last account, if it is watched [m]
  double stable_step_ = 0;                           ///< last estimate [s]
  double rounding_energy_ = 0;  ///< while no energy is larger, what balances is rounding [J]
  std::string limited_by_;
};

}  // namespace glisson

#include <glisson/core/simulation/simulation_checks.ipp>
#include <glisson/core/simulation/simulation_state.ipp>
#include <glisson/core/simulation/simulation_step.ipp>
