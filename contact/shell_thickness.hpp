// How far membranes and shells reach from their nodes.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::contact {

/// Half of the thickness of each shell triangle at rest [m]  [triangle_count]
std::vector<double> half_thicknesses(const Model& model);

/// The mean of it over the triangles around each node, 0 without any [m]  [node_count]
std::vector<double> half_thickness_at_nodes(const Model& model);

}  // namespace glisson::contact
