// A box cut into tetrahedra or hexahedra: for tests, benchmarks and first steps.
#pragma once

#include <array>

#include <glisson/core/mesh/mesh.hpp>

namespace glisson {

/// The box [0, size] [m] in cells[0] x cells[1] x cells[2] bricks; a brick is one hexahedron or six
/// tetrahedra around its diagonal (Kuhn 1960), which fit together across bricks. Node (i, j, k) has number (k
/// (cells[1] + 1) + j) (cells[0] + 1) + i unless shuffled. jitter moves interior nodes by up to that share of
/// a brick [-]; up to 0.2 no element inverts. shuffled: nodes and elements in a random order, always the same
/// one. Throws Error(usage) when a count or a size is not positive or the node count does not fit into int.
Mesh box_mesh(std::array<int, 3> cells, Vec3<double> size, Shape shape, double jitter = 0,
              bool shuffled = false);

}  // namespace glisson
