// Triangle surfaces: splitting, neighbours, smooth normals and the gap along them.
#include <gtest/gtest.h>

#include <cmath>

#include <glisson/contact/geometry/smooth_normal.hpp>
#include <glisson/contact/geometry/triangles.hpp>
#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/mesh/triangles.hpp>

namespace glisson::contact {
namespace {

double length_of(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

struct Cube {
  Mesh mesh = box_mesh({3, 3, 3}, {1, 1, 1}, Shape::hexahedron, 0);
  std::vector<Triangle> triangles = split_facets(outer_surface(mesh), mesh.X);
};

TEST(Triangles, AClosedSurfaceHasThreeNeighboursEverywhere) {
  const Cube cube;
  ASSERT_EQ(cube.triangles.size(), 6u * 9 * 2);
  const auto neighbours = neighbours_of(cube.triangles);
  for (int t = 0; t < int(neighbours.size()); ++t)
    for (const int other : neighbours[std::size_t(t)]) {
      ASSERT_GE(other, 0);
      const auto& back = neighbours[std::size_t(other)];
      EXPECT_EQ(std::count(back.begin(), back.end(), t), 1);
    }
  EXPECT_EQ(edges_of(cube.triangles).size(), cube.triangles.size() * 3 / 2);
}

TEST(Triangles, OpenAndBranchingEdgesHaveNoNeighbour) {
  EXPECT_EQ(neighbours_of(std::vector<Triangle>{{0, 1, 2}})[0], (std::array{-1, -1, -1}));
  const std::vector<Triangle> fins{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  for (const auto& n : neighbours_of(fins)) EXPECT_EQ(n, (std::array{-1, -1, -1}));
}

/// Two fans that meet at node 0 only.
TEST(Triangles, PartsThatMeetAtANodeGetNodesOfTheirOwn) {
  std::vector<Vec3<double>> x(8);
  for (std::size_t n = 0; n < x.size(); ++n) x[n] = {double(n), 0, 0};
  std::vector<Triangle> triangles{{0, 1, 2}, {2, 3, 0}, {4, 0, 5}, {0, 6, 7}, {5, 0, 6}};
  part_vertices(triangles, x);
  EXPECT_EQ(triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 3, 0}, {4, 8, 5}, {8, 6, 7}, {5, 8, 6}}));
  ASSERT_EQ(x.size(), 9u);
  EXPECT_EQ(x[8].x, 0);
  Cube cube;
  const auto before = cube.triangles;
  part_vertices(cube.triangles, cube.mesh.X);
  EXPECT_EQ(cube.triangles, before) << "a closed surface has one fan around each node";
}

TEST(Triangles, QuadrilateralsSplitAlongTheShorterDiagonal) {
  const std::vector<Vec3<double>> X{{0, 0, 0}, {1, 0, 0}, {3, 3, 0}, {0, 1, 0}};
  const std::vector<Facet> facets{{{0, 1, 2, 3}}};
  EXPECT_EQ(split_facets(facets, X), (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Triangles, VertexNormalsOfACubeDoNotDependOnTheSplit) {
  const Cube cube;
  const auto normals = vertex_normals(cube.triangles, cube.mesh.X);
  for (std::size_t n = 0; n < normals.size(); ++n) {
    Vec3<double> expected;
    const auto side = [](double x) { return x < 1e-9 ? -1.0 : x > 1 - 1e-9 ? 1.0 : 0.0; };
    expected = {side(cube.mesh.X[n].x), side(cube.mesh.X[n].y), side(cube.mesh.X[n].z)};
    if (length_of(expected) > 0) expected = (1 / length_of(expected)) * expected;
    EXPECT_LT(length_of(normals[n] - expected), 1e-14) << n;
  }
}

TEST(Triangles, DegenerateFacetsHaveNoSayInTheNormals) {
  const std::vector<Vec3<double>> X{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  const auto normals = vertex_normals(std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}, {1, 1, 3}}, X);
  EXPECT_EQ(normals[0].z, 1);
  EXPECT_EQ(length_of(normals[3]), 0);
  EXPECT_EQ(triangle_sizes(std::vector<Triangle>{{0, 1, 3}}, X).smallest, 0);
}

/// Facet of a sphere of radius 2 with the sphere's own normals.
SmoothTriangle<double> sphere_facet() {
  SmoothTriangle<double> facet;
  const Vec3<double> directions[3] = {{1, 0.1, 0}, {1, -0.1, 0.1}, {1, 0, -0.1}};
  for (int k = 0; k < 3; ++k) {
    facet.n[k] = unit_or(directions[k], {});
    facet.x[k] = 2.0 * facet.n[k];
  }
  if (dot(facet.facet_normal(), facet.n[0]) < 0) {
    std::swap(facet.x[1], facet.x[2]);
    std::swap(facet.n[1], facet.n[2]);
  }
  return facet;
}

TEST(SmoothGaps, ProjectAlongTheInterpolatedNormal) {
  const auto facet = sphere_facet();
  for (const double gap : {-0.3, -0.01, 0.0, 0.02, 0.5}) {
    const double b[3] = {0.2, 0.5, 0.3};
    const auto found = smooth_gap(facet, facet.point(b) + gap * facet.normal(b));
    const double left = std::pow(std::abs(gap) / 2, smooth_projections);  // each step gains gap / radius
    EXPECT_NEAR(found.gap, gap, left + 1e-12);
    EXPECT_LT(found.miss, left + 1e-12);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.b[k], b[k], left + 1e-12);
  }
}

/// Two facets see the same point over their common edge with the same normal and gap.
TEST(SmoothGaps, AreContinuousAcrossAnEdge) {
  const std::vector<Vec3<double>> X{{0, 0, 0}, {1, 0, 0.2}, {0.4, 1, 0}, {0.6, -1, -0.1}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {1, 0, 3}};
  const auto normals = vertex_normals(triangles, X);
  std::array<SmoothGap<double>, 2> found;
  const Vec3<double> n = unit_or(normals[0] + normals[1], {});
  const Vec3<double> p = 0.5 * (X[0] + X[1]) - 0.1 * n;
  for (std::size_t t = 0; t < 2; ++t) {
    SmoothTriangle<double> facet;
    for (std::size_t k = 0; k < 3; ++k) {
      facet.x[k] = X[std::size_t(triangles[t][k])];
      facet.n[k] = normals[std::size_t(triangles[t][k])];
    }
    found[t] = smooth_gap(facet, p);
  }
  EXPECT_NEAR(found[0].gap, -0.1, 1e-9);
  EXPECT_NEAR(found[0].gap, found[1].gap, 1e-9);
  EXPECT_LT(length_of(found[0].normal - found[1].normal), 1e-7);
}

}  // namespace
}  // namespace glisson::contact
