// A triangle surface as contact sees it: quadrilaterals split, edges found, neighbours known.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glisson/core/mesh/mesh.hpp>

namespace glisson::contact {

using Triangle = std::array<int, 3>;

/// Quadrilaterals become two triangles along their shorter diagonal at rest; order and orientation stay.
std::vector<Triangle> split_facets(std::span<const Facet> facets, std::span<const Vec3<double>> X);

/// Triangle across edge k (from corner k to corner k + 1) of each triangle, -1 where there is none. An edge
/// with three or more owners joins none of them.  [triangle_count]
std::vector<std::array<int, 3>> neighbours_of(std::span<const Triangle> triangles);

/// Gives the triangles that hang together over edges around a node a copy of it where they are not all that
/// meet there, as at the tips of two cones: each side then has a vertex normal of its own. The first ones
/// keep the node; copies are appended to x.
void part_vertices(std::vector<Triangle>& triangles, std::vector<Vec3<double>>& x);

/// Each edge once, lower node first, sorted.
std::vector<std::array<int, 2>> edges_of(std::span<const Triangle> triangles);

/// Vertex normals: the mean of the unit normals of the facets around a vertex, weighted by their angle there
/// (Thuermer & Wuethrich 1998). Johnsen 2016, eq. 5.11, weights by area as well; without, the result does not
/// depend on how a flat part is divided, and its sign tells inside from outside (Baerentzen & Aanaes 2005).
/// The zero vector where no triangle with an area touches the vertex.  [x.size()]
std::vector<Vec3<double>> vertex_normals(std::span<const Triangle> triangles,
                                         std::span<const Vec3<double>> x);

}  // namespace glisson::contact
