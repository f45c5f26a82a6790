// Moves a mesh: rotation, scale, translation; and joins nodes that lie on each other.
#pragma once

#include <span>
#include <vector>

#include <glisson/core/mesh/mesh.hpp>

namespace glisson {

/// x' = scale (Rx(ax) Ry(ay) Rz(az) (x - centre) + centre) + translation, the order of NiftySim's mesh
/// elements.
struct Transform {
  Vec3<double> centre;       ///< of the rotation [m]
  Vec3<double> angles;       ///< about x, y, z; the one about z is applied first [degrees]
  double scale = 1;          ///< about the origin, positive [-]
  Vec3<double> translation;  ///< [m]
};

Vec3<double> transformed(const Transform& transform, const Vec3<double>& x);
/// All positions. Error(usage) when the scale is not positive or a number is not finite.
void transform_nodes(const Transform& transform, std::span<Vec3<double>> X);

/// Gives each node that lies closer than `distance` (strictly) to a node before it which stays, the number of
/// the first such. The distance from a node that was merged itself does not count, so that chains do not run
/// together. Rows of point arrays follow the node that stays. Takes time proportional to the number of nodes.
/// Returns old -> new number [node_count before]; the identity when distance is 0 or negative.
/// Error(input) when an element would have a node twice, or when the distance is not finite.
std::vector<int> merge_nodes(Mesh& mesh, double distance);

}  // namespace glisson
