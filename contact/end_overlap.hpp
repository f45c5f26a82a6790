// What contact lost during a run: bodies that lie in each other at its end.
#pragma once

#include <string>
#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::contact {

/// Contact looks for nodes up to a fifth of an edge length behind a surface: what got deeper, because it was
/// thrown at the speed of waves or went in between nodes, feels no force and is not part of largest_depth. A
/// sentence for the bodies, and for each rigid surface, of which such nodes lie in a solid at the time t [s].
/// Not looked at: what passed a membrane or left again, a solid in itself, where the file says which nodes
/// may touch. u: [m, node_count of the mesh]
std::vector<std::string> overlap_warnings(const Model& model, const std::vector<Vec3<double>>& u, double t);

}  // namespace glisson::contact
