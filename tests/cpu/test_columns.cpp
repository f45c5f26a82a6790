#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <glisson/core/elements/hexahedron.hpp>
#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/cpu/solids/columns.hpp>

namespace glisson::patches {
namespace {

using Corners = std::array<int, 8>;

std::vector<Corners> hexahedra_of(const Mesh& mesh) {
  std::vector<Corners> result(static_cast<std::size_t>(mesh.element_count()));
  for (int e = 0; e < mesh.element_count(); ++e)
    std::copy_n(mesh.element(e).begin(), 8, result[static_cast<std::size_t>(e)].begin());
  return result;
}

/// The same hexahedron from another corner: turned about the zeta or the xi axis.
Corners turned(const Corners& n, int turn) {
  Corners result = n;
  for (int i = 0; i < turn % 4; ++i)
    result = {result[1], result[2], result[3], result[0], result[5], result[6], result[7], result[4]};
  for (int i = 0; i < turn / 4; ++i)
    result = {result[3], result[2], result[6], result[7], result[0], result[1], result[5], result[4]};
  return result;
}

/// Every hexahedron once, and in its place with its own nodes.
void check(const std::vector<Corners>& hexahedra, const std::vector<Column>& columns) {
  std::vector<int> seen(hexahedra.size());
  for (const Column& column : columns)
    for (std::size_t j = 0; j < column_length; ++j) {
      if (column.element[j] < 0) continue;
      const auto e = static_cast<std::size_t>(column.element[j]);
      ++seen[e];
      const auto first = column.node.begin() + static_cast<std::ptrdiff_t>(4 * j);
      EXPECT_EQ(std::multiset<int>(first, first + 8),
                std::multiset<int>(hexahedra[e].begin(), hexahedra[e].end()));
    }
  for (const int count : seen) EXPECT_EQ(count, 1);
}

double fill(const std::vector<Corners>& hexahedra, const std::vector<Column>& columns) {
  return double(hexahedra.size()) / double(column_length * columns.size());
}

TEST(Columns, LeaveFewLanesEmpty) {
  for (const int cells : {3, 5, 7, 8}) {
    const auto hexahedra = hexahedra_of(box_mesh({cells, cells, cells}, {1, 1, 1}, Shape::hexahedron));
    const auto columns = build_columns(hexahedra);
    check(hexahedra, columns);
    EXPECT_GT(fill(hexahedra, columns), 0.95) << cells;
  }
}

TEST(Columns, TurnHexahedraWithoutTurningThemInsideOut) {
  const Mesh mesh = box_mesh({6, 5, 4}, {1, 1, 1}, Shape::hexahedron, 0.1);
  auto hexahedra = hexahedra_of(mesh);
  for (std::size_t e = 0; e < hexahedra.size(); ++e)
    hexahedra[e] = turned(hexahedra[e], static_cast<int>(e * 7 % 16));
  const auto columns = build_columns(hexahedra);
  check(hexahedra, columns);
  EXPECT_GT(fill(hexahedra, columns), 0.8);
  for (const Column& column : columns)
    for (std::size_t j = 0; j < column_length && column.element[j] >= 0; ++j) {
      Vec3<double> X[8];
      for (std::size_t a = 0; a < 8; ++a) X[a] = mesh.X[static_cast<std::size_t>(column.node[4 * j + a])];
      const double volume = mean_gradient(X).volume;
      EXPECT_GT(volume, 0.3 / 120);
      EXPECT_LT(volume, 2.0 / 120);
    }
}

TEST(Columns, WorkWithoutNeighboursInRingsAndWithRepeatedHexahedra) {
  const std::vector<Corners> apart{{0, 1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 11, 12, 13, 14, 15}};
  check(apart, build_columns(apart));
  // a ring of four around a hole: the last one shares a face with the first
  std::vector<Corners> ring;
  for (int i = 0; i < 4; ++i) {
    const int a = 4 * i, b = 4 * ((i + 1) % 4);
    ring.push_back({a, a + 1, a + 2, a + 3, b, b + 1, b + 2, b + 3});
  }
  check(ring, build_columns(ring));
  const Corners one{0, 1, 2, 3, 4, 5, 6, 7};
  const std::vector<Corners> twice{one, one, {4, 5, 6, 7, 8, 9, 10, 11}, {7, 6, 5, 4, 8, 9, 10, 11}};
  check(twice, build_columns(twice));
  const std::vector<Corners> collapsed{
      {0, 1, 2, 2, 4, 5, 6, 6}, {4, 5, 6, 6, 8, 9, 10, 10}, {0, 0, 0, 0, 0, 0, 0, 0}};
  check(collapsed, build_columns(collapsed));
  EXPECT_TRUE(build_columns({}).empty());
}

}  // namespace
}  // namespace glisson::patches
