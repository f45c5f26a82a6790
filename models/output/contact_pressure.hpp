// Contact forces on nodes as a pressure.
#pragma once

#include <span>
#include <vector>

#include <glisson/core/mesh/mesh.hpp>

namespace glisson {

/// Pressure [Pa] on each node: the part of its force against the mean normal of the present outer facets
/// around it, over its share of their area (a third or a quarter each). 0 inside.  [node_count]
/// displacement [m], force [N]: [node_count]
std::vector<double> nodal_pressure(const Mesh& mesh, std::span<const Vec3<double>> displacement,
                                   std::span<const Vec3<double>> force);

}  // namespace glisson
