// Rigid bodies given by formulas that nodes lie in in the file.
#pragma once

#include <vector>

#include <glisson/contact/analytic/rigid_motion.hpp>

namespace glisson::contact {

/// Throws Error(input) that names the deepest of the nodes when it starts deeper in the body than a tenth of
/// the shortest edge of the elements around it. Less is brought out in the first step, as NiftySim does.
/// half_thickness: of shells, which stay so far in front of it [m]  [node_count of the mesh]
void refuse_overlap(const RigidMotion& motion, const std::vector<int>& nodes,
                    const std::vector<double>& half_thickness, const Mesh& mesh);

}  // namespace glisson::contact
