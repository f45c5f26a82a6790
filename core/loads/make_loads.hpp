// All loads of a model as native providers of a backend. Include it only where a backend is instantiated.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glisson/core/loads/gravity_load.hpp>
#include <glisson/core/loads/nodal_forces.hpp>
#include <glisson/core/loads/spring_load.hpp>
#include <glisson/core/loads/surface_loads.hpp>

namespace glisson {

/// mass: what gravity acts on, in internal order [kg]  [node_count]. inertia: what the stepper divides by,
/// for the stable step of springs [kg]  [node_count], or empty: the same; mass scaling and static runs make
/// them differ. The backend must outlive the result; the model need not.
template <Backend B, class R>
std::vector<std::unique_ptr<ForceProvider<R>>> make_loads(B& backend, const Model& model,
                                                          const Numbering& numbering,
                                                          std::span<const double> mass,
                                                          std::span<const double> inertia = {}) {
  std::vector<std::unique_ptr<ForceProvider<R>>> loads;
  for (const auto& load : model.forces)
    loads.push_back(std::make_unique<NodalForces<B, R>>(backend, load, numbering));
  for (const auto& load : model.gravity)
    loads.push_back(std::make_unique<GravityLoad<B, R>>(backend, load, numbering, mass));
  for (const auto& load : model.pressures)
    loads.push_back(std::make_unique<PressureLoad<B, R>>(backend, load, model.mesh, numbering));
  for (const auto& load : model.tractions)
    loads.push_back(std::make_unique<TractionLoad<B, R>>(backend, load, model.mesh, numbering));
  for (const auto& load : model.springs)
    loads.push_back(
        std::make_unique<SpringLoad<B, R>>(backend, load, numbering, inertia.empty() ? mass : inertia));
  return loads;
}

}  // namespace glisson
