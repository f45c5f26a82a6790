// Triangle surfaces: who lies across which edge, parts, a common orientation, sizes, facets cut into
// triangles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glisson/core/mesh/mesh.hpp>

namespace glisson {

using Triangle = std::array<int, 3>;

/// The triangles at one edge, side s of a triangle being the one opposite to its node s.
struct TriangleEdge {
  int a = 0, b = 0;        ///< nodes, a < b
  std::vector<int> sides;  ///< 3 * triangle + side [-]
};

/// Every edge once, sorted by its nodes.
std::vector<TriangleEdge> edges_of(std::span<const Triangle> triangles);

/// True when the two sides of an edge run through it in opposite directions, as neighbours of one orientation
/// do.
bool same_orientation(std::span<const Triangle> triangles, const TriangleEdge& edge);

/// Turns triangles until neighbours across two-sided edges agree, following the first of each connected part;
/// returns how many were turned, or -1 when the surface has one side only (a Moebius strip), which is then
/// left as it was.
int orient(std::vector<Triangle>& triangles);

/// Appends the triangle, or the two that a quadrilateral is cut into: along its shorter diagonal, or, where
/// the two are equal within one part in a thousand, along the one at its lowest node. Meshes with rows of
/// numbers then get parallel diagonals, and one facet is cut in one way wherever it is listed.
void append_triangles(const Facet& facet, std::span<const Vec3<double>> X, std::vector<Triangle>& triangles);

/// The triangles as facets without a solid element.  [triangle_count]
std::vector<Facet> facets_of(std::span<const Triangle> triangles);

/// Smallest and largest height over an edge (twice the area per longest edge) [m]; both 0 without triangles.
struct TriangleSizes {
  double smallest = 0, largest = 0;
};
TriangleSizes triangle_sizes(std::span<const Triangle> triangles, std::span<const Vec3<double>> X);

/// Triangles that hang together over edges with two sides.
struct SurfacePart {
  std::vector<std::size_t> triangles;
  bool closed = true;  ///< all of their edges have two sides
};
std::vector<SurfacePart> connected_parts(std::span<const Triangle> triangles);

/// [m^2]
double triangle_area(const Triangle& triangle, std::span<const Vec3<double>> X);

}  // namespace glisson
