// How well shaped the elements of a mesh are.
#pragma once

#include <glisson/core/mesh/mesh.hpp>

namespace glisson::app {

/// 1 for the regular tetrahedron or the cube, 0 for a flat element, negative when inverted. Tetrahedra: mean
/// ratio 12 (3 V)^(2/3) / sum of squared edges (Liu and Joe 1994). Hexahedra: smallest scaled Jacobian of the
/// 8 corners (Knupp 2000).
double element_quality(const Mesh& mesh, int element);

/// 1 for the equilateral triangle, 0 for one without area: 4 sqrt(3) A / sum of squared sides (Bhatia and
/// Lawrence 1990).
double triangle_quality(const std::array<int, 3>& triangle, const Mesh& mesh);

}  // namespace glisson::app
