// The gap below which contact slows an approach, for surfaces that leave it to the mesh.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::contact {

/// epsilon_r of Johnsen 2016, section 5.3.5.2: 1/4000 of the sum of the smallest and the largest height of a
/// facet over its longest edge [m]
constexpr double rate_distance(double smallest, double largest) { return 2.5e-4 * (smallest + largest); }

/// Farther than half an edge, both sides of a body one element thick would feel the same surface. Edges are
/// differences of rounded positions.
constexpr bool within_half_an_edge(double distance, double edge) {
  return distance <= (1 + 1e-9) * 0.5 * edge;
}

/// Those of the rigid surfaces [m]: their own, the run's or that of the outer facets of solids, membranes and
/// shells; 0 with penalties  [surfaces]. Throws Error(input) when one is more than half the edge length
/// (lower quartile at rest) of the body's facets with a node that may touch the surface: nodes on the far
/// side of a body that is one element thick would be slowed too, by a surface that the body itself keeps away
/// from them.
std::vector<double> rate_distances(const Model& model);

}  // namespace glisson::contact
