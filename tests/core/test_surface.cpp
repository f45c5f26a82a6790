// The outer surface: closed, outward, of the right area, for tetrahedra, hexahedra and a mixture.
#include <gtest/gtest.h>

#include <cmath>

#include <glisson/core/mesh/surface.hpp>

namespace glisson {
namespace {

Mesh cube(std::vector<std::pair<Shape, std::vector<int>>> elements) {
  Mesh mesh;
  mesh.X = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int k = 0; k < 4; ++k)
    mesh.X.push_back(mesh.X[4 + static_cast<std::size_t>(k)] + Vec3<double>{0, 0, 1});
  for (const auto& [shape, nodes] : elements) mesh.add_element(shape, nodes);
  return mesh;
}

const std::pair<Shape, std::vector<int>> lower_hexahedron{Shape::hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}};
const std::pair<Shape, std::vector<int>> upper_hexahedron{Shape::hexahedron, {4, 5, 6, 7, 8, 9, 10, 11}};
const std::vector<std::vector<int>> five{
    {0, 1, 3, 4}, {1, 2, 3, 6}, {1, 6, 4, 5}, {3, 4, 6, 7}, {1, 3, 4, 6}};

double area_of(const std::vector<Facet>& facets, const Mesh& mesh) {
  double area = 0;
  for (const auto& facet : facets) {
    const auto a = area_vector(facet, mesh.X);
    area += std::sqrt(dot(a, a));
  }
  return area;
}

/// Divergence theorem: one third of the flux of x through an outward closed surface is the volume inside.
double volume_of(const std::vector<Facet>& facets, const Mesh& mesh) {
  double volume = 0;
  for (const auto& facet : facets) volume += dot(facet_centre(facet, mesh.X), area_vector(facet, mesh.X)) / 3;
  return volume;
}

TEST(Surface, OfTetrahedraIsClosedAndOutward) {
  Mesh mesh = cube({});
  for (const auto& nodes : five) mesh.add_element(Shape::tetrahedron, nodes);
  const auto facets = outer_surface(mesh);
  EXPECT_EQ(facets.size(), 12U);
  EXPECT_NEAR(area_of(facets, mesh), 6, 1e-14);
  EXPECT_NEAR(volume_of(facets, mesh), 1, 1e-14);
  for (const auto& facet : facets) {
    const auto owner = mesh.element(facet.element);
    for (int a = 0; a < 3; ++a)
      EXPECT_NE(std::find(owner.begin(), owner.end(), facet.nodes[static_cast<std::size_t>(a)]), owner.end());
  }
}

TEST(Surface, OfHexahedraLeavesOutTheSharedFacet) {
  const Mesh mesh = cube({lower_hexahedron, upper_hexahedron});
  const auto facets = outer_surface(mesh);
  EXPECT_EQ(facets.size(), 10U);
  EXPECT_NEAR(area_of(facets, mesh), 10, 1e-14);
  EXPECT_NEAR(volume_of(facets, mesh), 2, 1e-14);
}

TEST(Surface, TrianglesAndQuadrilateralsMix) {
  Mesh mesh = cube({upper_hexahedron});
  mesh.add_element(Shape::tetrahedron, five[0]);
  const auto facets = outer_surface(mesh);
  EXPECT_EQ(facets.size(), 10U);
  EXPECT_EQ(facets[0].node_count(), 4);
  EXPECT_EQ(facets[9].node_count(), 3);
  EXPECT_NEAR(volume_of(facets, mesh), 1 + 1.0 / 6, 1e-14);
}

TEST(Surface, AMissingFacetWouldBeSeen) {  // the volume test above can fail
  const Mesh mesh = cube({lower_hexahedron});
  auto facets = outer_surface(mesh);
  facets.erase(facets.begin() + 1);  // the top
  EXPECT_GT(std::abs(volume_of(facets, mesh) - 1), 0.1);
}

TEST(Surface, NodesAreListedOnce) {
  const Mesh mesh = cube({lower_hexahedron});
  EXPECT_EQ(nodes_of(outer_surface(mesh)), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(Surface, NormalOfAFlatFacetIsZero) {
  const std::vector<Vec3<double>> X{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const auto n = facet_normal(Facet{{0, 1, 2, -1}, -1}, X);
  EXPECT_EQ(dot(n, n), 0);
}

}  // namespace
}  // namespace glisson
