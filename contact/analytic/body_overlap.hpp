// Rigid bodies given by formulas that nodes lie in in the file.
#pragma once

#include <vector>

#include <glisson/contact/analytic/rigid_motion.hpp>

namespace glisson::contact {

/// Throws Error(input) that names the deepest of the nodes when it starts deeper in the body than a tenth of
/// the shortest edge of the elements around it. Less is brought out in the first step, as NiftySim does.
void refuse_overlap(const RigidMotion& motion, const std::vector<int>& nodes, const Mesh& mesh);

/// How far nodes stay in front of the body: half of the thickness of shells, or the gap that they start with
/// if that is less, so that files in which a shell touches a body with its middle run [m]  [node_count of the
/// mesh]
std::vector<double> gaps_to_keep(const RigidMotion& motion, const std::vector<int>& nodes,
                                 const std::vector<double>& half_thickness, const Mesh& mesh);

}  // namespace glisson::contact
