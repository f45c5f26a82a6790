// The size of the mesh at a node.
#pragma once

#include <glisson/core/mesh/mesh.hpp>

namespace glisson::contact {

/// Of the elements and triangles that have the node; infinite without any [m].
double shortest_edge_around(const Mesh& mesh, int node);

}  // namespace glisson::contact
