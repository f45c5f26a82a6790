#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/cpu/solids/strips.hpp>

namespace glisson::patches {
namespace {

std::vector<std::array<int, 4>> tetrahedra_of_box(int cells) {
  const Mesh mesh = box_mesh({cells, cells, cells}, {1, 1, 1}, Shape::tetrahedron);
  std::vector<std::array<int, 4>> result;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto n = mesh.element(e);
    result.push_back({n[0], n[1], n[2], n[3]});
  }
  return result;
}

/// Every tetrahedron once, and in its place with its own nodes.
void check(const std::vector<std::array<int, 4>>& tetrahedra, const std::vector<Strip<4>>& strips) {
  std::vector<int> seen(tetrahedra.size());
  for (const Strip<4>& strip : strips)
    for (std::size_t j = 0; j < 3; ++j) {
      if (strip.element[j] < 0) continue;
      const auto e = static_cast<std::size_t>(strip.element[j]);
      ++seen[e];
      const std::set<int> expected(tetrahedra[e].begin(), tetrahedra[e].end());
      const auto first = strip.node.begin() + static_cast<std::ptrdiff_t>(j);
      EXPECT_EQ(std::set<int>(first, first + 4), expected);
    }
  for (const int count : seen) EXPECT_EQ(count, 1);
}

TEST(Strips, HoldEveryTetrahedronOnceAndLeaveFewLanesEmpty) {
  const auto tetrahedra = tetrahedra_of_box(5);
  const auto strips = build_strips<4>(tetrahedra);
  check(tetrahedra, strips);
  EXPECT_GT(double(tetrahedra.size()) / double(3 * strips.size()), 0.95);
}

TEST(Strips, WorkWithoutNeighboursAndWithRepeatedTetrahedra) {
  const std::vector<std::array<int, 4>> apart{{0, 1, 2, 3}, {4, 5, 6, 7}};
  check(apart, build_strips<4>(apart));
  const std::vector<std::array<int, 4>> twice{{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 5}};
  check(twice, build_strips<4>(twice));
  EXPECT_TRUE(build_strips<4>({}).empty());
}

}  // namespace
}  // namespace glisson::patches
