// Rigid bodies given by formulas that nodes lie in in the file.
#pragma once

#include <vector>

#include <glisson/contact/analytic/rigid_motion.hpp>

namespace glisson::contact {

/// How deep the nodes start in the body [m]  [node_count of the mesh]. Throws Error(input) that names the
/// deepest of them when that is more than a tenth of the shortest edge of the elements around it.
std::vector<double> start_depths(const RigidMotion& motion, const std::vector<int>& nodes, const Mesh& mesh);

/// How far nodes stay in front of the body: half of the thickness of shells, or the gap that they start with
/// if that is less, so that files in which a shell touches a body with its middle run [m]  [node_count of the
/// mesh]
std::vector<double> gaps_to_keep(const RigidMotion& motion, const std::vector<int>& nodes,
                                 const std::vector<double>& half_thickness, const Mesh& mesh);

}  // namespace glisson::contact
