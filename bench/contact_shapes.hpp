// Geometry of the experiments in Johnsen 2016, section 5.5: the same outer sizes and, as near as bricks of
// tetrahedra allow, the same numbers of facets. The thesis shows the shapes in pictures only.
#pragma once

#include <cmath>

#include <glisson/core/mesh/box_mesh.hpp>

namespace glisson::bench {

constexpr double half_turn = 3.14159265358979323846;

/// "C" (figure 5.10): 22.5 x 10 x 21.5, 960 facets and 482 surface nodes. A ring around y whose ends face
/// each other across a gap of 3 in z at its largest x.
inline Mesh c_shape() {
  Mesh mesh = box_mesh({28, 4, 4}, {1, 10, 1}, Shape::tetrahedron);
  for (auto& X : mesh.X) {
    const double radius = 5.5 + 5.5 * X.z;
    const double angle = (2 * X.x - 1) * (half_turn - std::asin(1.5 / radius));
    X = {-22.5 / 22 * radius * std::cos(angle), X.y, 21.5 / 22 * radius * std::sin(angle)};
  }
  return mesh;
}

}  // namespace glisson::bench
