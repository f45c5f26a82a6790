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

/// mass: weight-giving mass in internal order, without what mass scaling added [kg]  [node_count]. The
/// backend must outlive the result; the model need not.
template <Backend B, class R>
std::vector<std::unique_ptr<ForceProvider<R>>> make_loads(B& backend, const Model& model,
                                                          const Numbering& numbering,
                                                          std::span<const double> mass) {
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
    loads.push_back(std::make_unique<SpringLoad<B, R>>(backend, load, numbering, mass));
  return loads;
}

}  // namespace glisson
