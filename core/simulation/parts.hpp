// What a simulation is put together from; made by run/ where backend, solids, loads and contact are known.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/constraints/constraints.hpp>
#include <glisson/core/numbering.hpp>
#include <glisson/core/solids/solid_forces.hpp>
#include <glisson/core/solids/stable_step.hpp>

namespace glisson {

template <Backend B, class R>
struct SimulationParts {
  std::unique_ptr<B> backend;  ///< first: outlives every buffer below
  std::string device;          ///< "Threads float, 2 threads, AVX-512"
  Numbering numbering;
  std::vector<double> mass;  ///< inertial mass, internal order [kg]  [node_count]
  double added_mass = 0;     ///< share of the mass that scaling added [-]
  StableStep element_step;   ///< bound from the elements at rest
  std::unique_ptr<SolidForces<R>> solids;
  std::vector<std::unique_ptr<ForceProvider<R>>> loads;   ///< need no prediction
  std::vector<std::unique_ptr<ForceProvider<R>>> bodies;  ///< contact: see the predicted displacement
  std::unique_ptr<Constraints<B, R>> constraints;
};

}  // namespace glisson
