// Geometry of the experiments in Johnsen 2016, section 5.5: the outer sizes and, as near as bricks of
// tetrahedra allow, the numbers of facets. The thesis shows the shapes in pictures only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glisson/core/mesh/box_mesh.hpp>

namespace glisson::bench {

constexpr double half_turn = 3.14159265358979323846;

/// "C" (figure 5.10): 22.5 x 10 x 21.5, 960 facets and 482 surface nodes from 28 x 4 x 4 bricks. A ring
/// around y whose ends face each other across a gap of 3 in z at its largest x.
inline Mesh c_shape(std::array<int, 3> cells = {28, 4, 4}) {
  Mesh mesh = box_mesh(cells, {1, 10, 1}, Shape::tetrahedron);
  for (auto& X : mesh.X) {
    const double radius = 5.5 + 5.5 * X.z;
    const double angle = (2 * X.x - 1) * (half_turn - std::asin(1.5 / radius));
    X = {-22.5 / 22 * radius * std::cos(angle), X.y, 21.5 / 22 * radius * std::sin(angle)};
  }
  return mesh;
}

/// "Zipper" (figure 5.10): 35 x 7 x 12.5, 712 facets and 358 surface nodes from 24 x 5 x 2 bricks. A strip in
/// six straight legs up and down along x; cells[0] must be a multiple of 6.
inline Mesh zipper_shape(std::array<int, 3> cells = {24, 5, 2}) {
  constexpr double legs = 6, thickness = 2.5;  // thickness along z
  Mesh mesh = box_mesh(cells, {1, 7, 1}, Shape::tetrahedron);
  for (auto& X : mesh.X) {
    const double along = legs * X.x, up = std::abs(along - 2 * std::round(along / 2));
    X = {35 * X.x, X.y, (12.5 - thickness) * up + thickness * X.z};
  }
  return mesh;
}

/// Ball of radius 1: a cube of these bricks mapped so that its shells become spheres.
inline Mesh ball_shape(std::array<int, 3> cells) {
  Mesh mesh = box_mesh(cells, {2, 2, 2}, Shape::tetrahedron);
  for (auto& X : mesh.X) {
    X = X - Vec3<double>{1, 1, 1};
    const double shell = std::max({std::abs(X.x), std::abs(X.y), std::abs(X.z)});
    // equal angles on the faces keep the surface triangles alike
    const auto bent = [&](double c) { return shell > 0 ? std::tan(c / shell * half_turn / 4) : 0; };
    const Vec3<double> q{bent(X.x), bent(X.y), bent(X.z)};
    const double length = std::sqrt(dot(q, q));
    X = length > 0 ? (shell / length) * q : Vec3<double>{};
  }
  return mesh;
}

}  // namespace glisson::bench
