#include <glisson/app/mesh_quality.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <glisson/core/mesh/triangles.hpp>

namespace glisson::app {
namespace {

double length(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

double tetrahedron_quality(const std::array<Vec3<double>, 8>& X) {
  const double volume = dot(cross(X[1] - X[0], X[2] - X[0]), X[3] - X[0]) / 6;
  double squares = 0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b) squares += dot(X[b] - X[a], X[b] - X[a]);
  if (squares <= 0) return 0;
  return std::copysign(12 * std::pow(3 * std::abs(volume), 2.0 / 3) / squares, volume);
}

double hexahedron_quality(const std::array<Vec3<double>, 8>& X) {
  // the three neighbours of each corner, right-handed
  constexpr std::array<std::array<std::size_t, 3>, 8> next{
      {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
  double smallest = 1;
  for (std::size_t a = 0; a < 8; ++a) {
    const auto p = X[next[a][0]] - X[a], q = X[next[a][1]] - X[a], r = X[next[a][2]] - X[a];
    const double lengths = length(p) * length(q) * length(r);
    smallest = std::min(smallest, lengths > 0 ? dot(cross(p, q), r) / lengths : 0.0);
  }
  return smallest;
}

}  // namespace

double element_quality(const Mesh& mesh, int element) {
  std::array<Vec3<double>, 8> X{};
  const auto nodes = mesh.element(element);
  for (std::size_t a = 0; a < nodes.size(); ++a) X[a] = mesh.X[static_cast<std::size_t>(nodes[a])];
  return nodes.size() == 4 ? tetrahedron_quality(X) : hexahedron_quality(X);
}

double triangle_quality(const std::array<int, 3>& triangle, const Mesh& mesh) {
  double squares = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto side = mesh.X[static_cast<std::size_t>(triangle[(a + 1) % 3])] -
                      mesh.X[static_cast<std::size_t>(triangle[a])];
    squares += dot(side, side);
  }
  return squares > 0 ? 4 * std::sqrt(3.0) * triangle_area(triangle, mesh.X) / squares : 0;
}

}  // namespace glisson::app
