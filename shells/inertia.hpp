// Mass and stable step of membranes and shells.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/solids/mass.hpp>

namespace glisson::shells {

struct TriangleStep {
  double dt = 0;    ///< 2 / omega_max of the element at rest, bending included [s]
  double size = 0;  ///< V / sqrt(sum of squared gradients), as of solids [m]
};

/// Of every triangle, by section. A rotation-free element has no mass of its own at the nodes of its
/// neighbours: it borrows a quarter of the mass of each of the four triangles of its patch, and no triangle
/// is in more than four patches, so that the largest frequency of the mesh stays below the largest of the
/// elements.
std::vector<TriangleStep> triangle_steps(const Model& model);

/// Adds the shells' mass to that of the solids, scaled as TimeSettings asks for, and tightens the step bound.
void add_inertia(const Model& model, InertialMass& inertia);

}  // namespace glisson::shells
