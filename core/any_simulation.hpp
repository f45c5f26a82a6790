// A simulation whose backend and precision were chosen at run time; what the library's users hold.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glisson/core/contact_report.hpp>
#include <glisson/core/force_provider.hpp>
#include <glisson/core/model.hpp>
#include <glisson/core/result_fields.hpp>

namespace glisson {

/// All in [J].
struct Energies {
  double kinetic = 0, strain = 0, hourglass = 0;
  double shell = 0;       ///< the part of `strain` in membranes and shells
  double viscous = 0;     ///< dissipated by Prony terms (internal work minus strain energy); 0 without them
  double damping = 0;     ///< dissipated by mass-proportional damping
  double external = 0;    ///< work of forces, pressure, gravity, springs, user providers
  double prescribed = 0;  ///< work of the reactions at prescribed nodes
  double contact = 0;     ///< work of contact, with rigid bodies and between deformable ones
  double initial = 0;     ///< kinetic energy at the start
  /// initial + external + prescribed + contact - kinetic - strain - hourglass - viscous - damping
  double imbalance() const {
    return initial + external + prescribed + contact - kinetic - strain - hourglass - viscous - damping;
  }
};

struct StepReport {
  double dt = 0;                   ///< step in use [s]
  double stable_step = 0;          ///< last estimate [s]
  std::string limited_by;          ///< "element 17 (T4, NH)" or a provider's name
  double added_mass = 0;           ///< by mass scaling, share of the mass [-]
  std::int64_t planned_steps = 0;  ///< to the end of the run; 0 in quasi-static mode
  std::string
      ending;  ///< quasi-static: "converged", "stalled: ...", "not converged: ..."; empty before the end
  std::int64_t energies_every = 1;  ///< steps between two energy accounts
  double user_seconds = 0;          ///< in providers of users, with carrying the state to them and back [s]
};

/// The last energy account, of the state at the start of its step.
struct AccountReport {
  std::int64_t step = -1;           ///< steps before it; -1: there was none
  double time = 0;                  ///< [s]
  double largest_displacement = 0;  ///< length, if somebody watches it [m]
};

/// Every array is in the user's node and element numbering.
class AnySimulation {
 public:
  virtual ~AnySimulation() = default;

  /// Advances `count` steps and returns when they are done. Throws Error(run) that names node, element, step
  /// and likely cause when the state is not finite or the energy balance is lost.
  virtual void step(std::int64_t count = 1) = 0;
  /// True at the end of the run: time reached, or converged in quasi-static mode.
  virtual bool finished() const = 0;
  virtual std::int64_t step_count() const = 0;
  virtual double time() const = 0;
  virtual StepReport report() const = 0;
  virtual Energies energies() = 0;
  virtual AccountReport last_account() const = 0;
  /// From now on accounts find the largest displacement too.
  virtual void watch_largest_displacement() = 0;
  /// Residuals of quasi-static mode: {force, displacement}; both 0 in a dynamic run.
  virtual std::array<double, 2> residuals() const = 0;

  virtual std::vector<Vec3<double>> displacement() const = 0;  ///< [m]    [node_count]
  virtual std::vector<Vec3<double>> velocity() const = 0;      ///< [m/s]  [node_count]
  virtual std::vector<Vec3<double>> internal_force()
      const = 0;  ///< of the elements on the nodes, F = -f_int [N]
  virtual ElementFieldSource element_field_source() const = 0;
  ElementFields element_fields() const {
    const ElementFieldSource source = element_field_source();
    return source.range(0, source.element_count);
  }
  virtual ShellFields shell_fields() const = 0;
  /// One for each rigid body, rigid surface and for the deformable bodies together, as of the last account.
  virtual std::vector<NamedContact> contacts() const = 0;
  /// Of all contact on the nodes in the step of the last energy account [N]  [node_count]; empty without any.
  virtual std::vector<Vec3<double>> contact_force() const = 0;

  /// Adds a user's provider; before the first step.
  virtual void add(std::unique_ptr<ForceProvider<double>> provider) = 0;
  /// Complete state; a run resumed from it ends with the same bits as one that was not interrupted.
  virtual void save(std::ostream& out) const = 0;
  virtual void load(std::istream& in) = 0;

  virtual std::string device() const = 0;        ///< "Serial double", "Threads float, 2 threads, AVX-512"
  virtual std::size_t memory_bytes() const = 0;  ///< of the simulation's own arrays
};

}  // namespace glisson
