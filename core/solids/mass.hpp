// Lumped masses: the true one, and the inertial one that mass scaling or a quasi-static run makes of it.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/solids/stable_step.hpp>

namespace glisson {

/// Each element shares its mass rho V equally among its nodes (Johnsen 2016, algorithm 4.1); V of hexahedra
/// is exact. Each triangle shares rho h A. User's node order [kg]  [node_count]
std::vector<double> lumped_mass(const Model& model);

struct InertialMass {
  std::vector<double> mass;  ///< user's node order [kg]  [node_count]
  double added_share = 0;    ///< mass added / true mass [-]
  StableStep step;           ///< element bound with this mass
};

/// The mass that moves in a run. Elements whose stable step is below TimeSettings::mass_scaling_step are made
/// heavier until they reach it. In a quasi-static run every element gets the mass that makes its step that of
/// the slowest one: fictitious, but then no sliver slows the relaxation.
InertialMass inertial_mass(const Model& model);

}  // namespace glisson
