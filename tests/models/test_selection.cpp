// Selections by place, label and distance, and their combinations, on nodes and on facets.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/models/selection/selection.hpp>

namespace glisson {
namespace {

using Kind = Selection::Kind;

Selection region(Kind kind, std::array<double, 6> numbers) { return {kind, numbers, {}, {}, {}}; }

/// 4 x 4 x 4 hexahedra of a unit cube; the upper half has label 2, the lower 1.
Mesh labelled_cube() {
  Mesh mesh = box_mesh({4, 4, 4}, {1, 1, 1}, Shape::hexahedron);
  for (int e = 0; e < mesh.element_count(); ++e) {
    double z = 0;
    for (const int n : mesh.element(e)) z += mesh.X[static_cast<std::size_t>(n)].z / 8;
    mesh.label.push_back(z > 0.5 ? 2 : 1);
  }
  return mesh;
}

TEST(Selection, RegionsHoldTheNodesInThem) {
  const Mesh mesh = labelled_cube();
  const SelectionMesh selecting(mesh);
  EXPECT_EQ(selecting.nodes({}).size(), 125U);
  EXPECT_EQ(selecting.nodes({Kind::surface, {}, {}, {}, {}}).size(), 125U - 27U);
  EXPECT_EQ(selecting.nodes(region(Kind::box, {0, 1, 0, 1, 0, 0.25})).size(), 50U);
  EXPECT_EQ(selecting.nodes(region(Kind::sphere, {0.26, 0.5, 0.5, 0.5})).size(), 7U);
  EXPECT_EQ(selecting.nodes(region(Kind::sphere, {0.25, 0.5, 0.5, 0.5})).size(), 1U);  // the ball is open
  EXPECT_EQ(selecting.nodes(region(Kind::half_space, {0, 0, 0.75, 0, 0, 2})).size(), 50U);
  EXPECT_EQ(selecting.nodes(region(Kind::normal, {0, 0, 1, 10})).size(), 25U);
  EXPECT_EQ(selecting.nodes({Kind::label, {}, {2}, {}, {}}).size(),
            75U);  // both sides share the nodes between them
}

TEST(Selection, FacetsGoByTheirCentreOwnerAndCorners) {
  const Mesh mesh = labelled_cube();
  const SelectionMesh selecting(mesh);
  EXPECT_EQ(selecting.facets({}).size(), 96U);
  EXPECT_EQ(selecting.facets(region(Kind::normal, {0, 0, 1, 10})).size(), 16U);
  EXPECT_EQ(selecting.facets(region(Kind::box, {0, 1, 0, 1, 0, 0.25})).size(), 16U + 16U);
  EXPECT_EQ(selecting.facets({Kind::label, {}, {1}, {}, {}}).size(), 48U);
  EXPECT_EQ(selecting.facets({Kind::nodes, {}, {0, 1, 5, 6, 7}, {}, {}}).size(), 1U);
}

TEST(Selection, TwoHalvesOfASurfaceShareNoFacet) {
  const Mesh mesh = labelled_cube();
  const SelectionMesh selecting(mesh);
  const auto left = region(Kind::box, {0, 0.5, 0, 1, 0, 1}), right = region(Kind::box, {0.5, 1, 0, 1, 0, 1});
  EXPECT_EQ(selecting.facets(left).size() + selecting.facets(right).size(), 96U);
}

TEST(Selection, CombinesByAndOrNot) {
  const Mesh mesh = labelled_cube();
  const SelectionMesh selecting(mesh);
  const auto low = region(Kind::half_space, {0, 0, 0.5, 0, 0, -1}),
             high = region(Kind::half_space, {0, 0, 0.5, 0, 0, 1});
  EXPECT_EQ(selecting.nodes({Kind::both, {}, {}, {}, {low, high}}).size(), 25U);
  EXPECT_EQ(selecting.nodes({Kind::either, {}, {}, {}, {low, high}}).size(), 125U);
  EXPECT_EQ(selecting.nodes({Kind::neither, {}, {}, {}, {low}}).size(), 50U);
  EXPECT_EQ(selecting.nodes({Kind::neither, {}, {}, {}, {low, high}}).size(), 0U);
  const Selection not_low{Kind::neither, {}, {}, {}, {low}};
  EXPECT_EQ(selecting.nodes({Kind::both, {}, {}, {}, {not_low, {Kind::surface, {}, {}, {}, {}}}}).size(),
            50U - 9U);
}

SurfaceMesh random_triangles(int count, double size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(0, 1), off(-size, size);
  SurfaceMesh surface;
  for (int t = 0; t < count; ++t) {
    const Vec3<double> a{at(random), at(random), at(random)};
    for (int k = 0; k < 3; ++k) surface.X.push_back(a + Vec3<double>{off(random), off(random), off(random)});
    surface.facets.push_back({{3 * t, 3 * t + 1, 3 * t + 2, -1}, -1});
  }
  return surface;
}

bool within_by_brute_force(const SurfaceMesh& surface, const Vec3<double>& x, double reach) {
  for (const auto& facet : surface.facets) {
    const auto at = [&](std::size_t a) { return surface.X[static_cast<std::size_t>(facet.nodes[a])]; };
    const auto d = x - closest_point(x, at(0), at(1), at(2));
    if (dot(d, d) <= reach * reach) return true;
  }
  return false;
}

TEST(SelectionDistance, TheGridAgreesWithBruteForce) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-0.5, 1.5);
  int inside = 0;
  for (const auto& [size, reach] : {std::pair{0.05, 0.03}, {0.5, 0.01}, {0.02, 0.7}, {1e-3, 1e-3}}) {
    const auto surface = random_triangles(60, size);
    const SurfaceDistance distance(surface, reach);
    for (int i = 0; i < 2000; ++i) {
      const Vec3<double> x{at(random), at(random), at(random)};
      const bool expected = within_by_brute_force(surface, x, reach);
      inside += expected;
      EXPECT_EQ(distance.within(x, reach), expected);
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_LT(inside, 7900);
}

TEST(SelectionDistance, ClosestPointOfEachRegion) {
  const Vec3<double> a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  const auto expect = [&](const Vec3<double>& p, const Vec3<double>& q) {
    const auto d = closest_point(p, a, b, c) - q;
    EXPECT_NEAR(dot(d, d), 0, 1e-28);
  };
  expect({-1, -1, 1}, a);
  expect({2, -1, 1}, b);
  expect({-1, 3, 1}, c);
  expect({0.4, -1, 1}, {0.4, 0, 0});
  expect({-1, 0.3, 1}, {0, 0.3, 0});
  expect({1, 1, 1}, {0.5, 0.5, 0});
  expect({0.2, 0.3, -5}, {0.2, 0.3, 0});
}

TEST(SelectionDistance, DegenerateSurfacesDoNotHurt) {
  SurfaceMesh point{{{1, 1, 1}}, {{{0, 0, 0, -1}, -1}}};
  const SurfaceDistance distance(point, 0.5);
  EXPECT_TRUE(distance.within({1, 1, 1.5}, 0.5));
  EXPECT_FALSE(distance.within({1, 1, 1.6}, 0.5));
  EXPECT_THROW(SurfaceDistance(SurfaceMesh{}, 1), Error);
}

TEST(SelectionDistance, QuadrilateralsAreWhole) {
  const SurfaceMesh quad{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{{0, 1, 2, 3}, -1}}};
  const SurfaceDistance distance(quad, 0.1);
  EXPECT_TRUE(distance.within({0.9, 0.1, 0.1}, 0.1));
  EXPECT_TRUE(distance.within({0.1, 0.9, 0.1}, 0.1));
}

}  // namespace
}  // namespace glisson
