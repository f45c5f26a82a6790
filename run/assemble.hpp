// Puts a simulation together for one backend and precision. Included only by the instantiation files
// run/simulate_*.cpp, the only places that name both a backend and the providers.
#pragma once

#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include <glisson/contact/analytic/rigid_bodies.hpp>
#include <glisson/contact/deformable/body_contact.hpp>
#include <glisson/contact/surface/rigid_surfaces.hpp>
#include <glisson/contact/tied/tied_surfaces.hpp>
#include <glisson/core/loads/make_loads.hpp>
#include <glisson/core/simulation/simulation.hpp>
#include <glisson/core/solids/mass.hpp>
#include <glisson/core/solids/stable_step.hpp>
#include <glisson/run/search_parts.hpp>
#include <glisson/shells/inertia.hpp>
#include <glisson/shells/shell_forces.hpp>

namespace glisson {

/// In the internal node order.
inline std::vector<double> reordered(const std::vector<double>& user, const Numbering& numbering) {
  std::vector<double> internal(user.size());
  for (std::size_t n = 0; n < user.size(); ++n)
    internal[n] = user[static_cast<std::size_t>(numbering.user_of_internal[n])];
  return internal;
}

/// Membranes and shells as loops over triangles; solids may be null.
template <Backend B, class R>
std::unique_ptr<SolidForces<R>> make_plain_shells(B& backend, const Model& model, const Numbering& numbering,
                                                  std::unique_ptr<SolidForces<R>> solids) {
  return std::make_unique<shells::ShellForces<B, R>>(backend, model, numbering, std::move(solids));
}

/// make_solids(backend, model, numbering) -> std::unique_ptr<SolidForces<R>>; make_shells as above. loops: of
/// contact, on hosts.
template <Backend B, class R, class MakeSolids, class MakeShells>
// NOLINTNEXTLINE(performance-unnecessary-value-param): the device's name is moved
std::unique_ptr<AnySimulation> assemble(const Model& model, std::unique_ptr<B> backend, std::string device,
                                        MakeSolids&& make_solids, MakeShells&& make_shells,
                                        const contact::ContactLoops<R>& loops = {}) {
  SimulationParts<B, R> parts;
  parts.device = std::move(device);
  parts.numbering = make_numbering(model.mesh);
  InertialMass inertia = inertial_mass(model);
  shells::add_inertia(model, inertia);
  parts.mass = reordered(inertia.mass, parts.numbering);
  parts.added_mass = inertia.added_share;
  parts.element_step = inertia.step;
  if (model.mesh.element_count() > 0) parts.solids = make_solids(*backend, model, parts.numbering);
  if (!model.shells.empty())
    parts.solids = make_shells(*backend, model, parts.numbering, std::move(parts.solids));
  const std::vector<double> gravity_mass = reordered(lumped_mass(model), parts.numbering);
  parts.loads = make_loads<B, R>(*backend, model, parts.numbering, gravity_mass, parts.mass);
  parts.bodies = contact::make_rigid_bodies<B, R>(*backend, model, parts.numbering, parts.mass);
  contact::add_rigid_surfaces<B, R>(*backend, model, parts.numbering, parts.bodies);
  if (model.contact.wanted())
    parts.bodies.push_back(std::make_unique<contact::BodyContact<B, R>>(*backend, model, parts.numbering,
                                                                        search_parts(*backend), loops));
  contact::add_tied_surfaces<B, R>(*backend, model, parts.numbering, parts.mass, parts.bodies);
  parts.constraints = std::make_unique<Constraints<B, R>>(*backend, model, parts.numbering);
  parts.backend = std::move(backend);
  return std::make_unique<Simulation<B, R>>(model, std::move(parts));
}

}  // namespace glisson
