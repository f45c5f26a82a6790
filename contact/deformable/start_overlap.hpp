// Bodies that lie in each other in the file already.
#pragma once

#include <glisson/contact/bvh/hierarchy.hpp>
#include <glisson/contact/deformable/contact_distances.hpp>

namespace glisson::contact {

/// Largest depth [m] of a node of one solid in another at rest; nodes of the same solid do not count. Throws
/// Error(input) that names the node when it exceeds what can be resolved, or when a solid lies within
/// another. `hierarchy` is one of the mesh; its boxes are not used.
double start_depth(const ContactMesh& mesh, const ContactRules& rules, const ContactDistances& distances,
                   const Hierarchy& hierarchy);

}  // namespace glisson::contact
