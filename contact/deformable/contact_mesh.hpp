// The outer surface of a model's solids as contact between deformable bodies sees it: triangles, edges,
// connected parts. Host data, constant.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glisson/contact/geometry/triangles.hpp>
#include <glisson/core/model.hpp>

namespace glisson::contact {

/// Where errors say that they come from.
constexpr const char* contact_place = "contact of deformable bodies";

/// An edge with the corners opposite to it in its two triangles; the first triangle runs from node 0 to 1.
struct ContactEdge {
  std::array<int, 2> node{};
  std::array<int, 2> opposite{};
  std::array<int, 2> triangle{};
};

/// Node numbers below are places in `nodes`. A quadrilateral is four triangles about the mean of its corners,
/// which follows the nodes as a point of its own: cut along one diagonal, an interface of grids that do not
/// match could warp without opening, in a way that a uniform stress works on.
struct ContactMesh {
  std::vector<int> nodes;                          ///< node of the mesh, rising [-]          [node_count]
  std::vector<std::array<int, 4>> quads;           ///< corners of the point node_count() + q   [quad_count]
  std::vector<Vec3<double>> X;                     ///< rest position from `centre` [m]      [point_count]
  Vec3<double> centre;                             ///< of the surface's box, so that float keeps digits [m]
  std::vector<Triangle> triangles;                 ///< points; the centre of a quad last [triangle_count]
  std::vector<ContactEdge> edges;                  ///< [edge_count]
  std::vector<std::array<int, 3>> triangle_edges;  ///< [triangle_count]
  std::vector<int> around_begin, around;           ///< triangles around each point
  /// Triangles that hang together at nodes and belong to one named body are a region.
  std::vector<int> region;                          ///< [triangle_count]
  std::vector<int> node_region;                     ///< of the first triangle around a node  [node_count]
  std::vector<int> part_of_region, body_of_region;  ///< part: what hangs together at nodes; body: see below
  std::vector<int> solid;       ///< what hangs together through elements, cavities included  [node_count]
  std::vector<bool> may_touch;  ///< the node may touch facets  [node_count]
  double edge_length = 0;       ///< lower quartile at rest: the length that distances are measured by [m]
  double shortest = 0, longest = 0;  ///< height of a facet over its longest edge [m]

  int node_count() const { return static_cast<int>(nodes.size()); }
  int point_count() const { return static_cast<int>(X.size()); }
  bool is_node(int point) const { return point < node_count(); }
  /// Nodes of the facet that a triangle is a part of; -1 for none.
  std::array<int, 4> facet_nodes(int triangle) const;
  /// x of the nodes, to which the points of the quads are appended.
  void append_centres(std::vector<Vec3<double>>& x) const;
  int triangle_count() const { return static_cast<int>(triangles.size()); }
};

/// body_of_region: 0 for elements without a name, k + 1 for Model::bodies_by_name[k]. Throws Error(input) for
/// an edge with other than two facets, which has no inside, and for nodes that are not on the surface.
ContactMesh contact_mesh(const Model& model);

/// The gap below which an approach is slowed: epsilon_r of Johnsen 2016, section 5.3.5.2, which is 1/4000 of
/// the sum of the smallest and the largest facet height [m].
double default_contact_distance(const ContactMesh& mesh);

}  // namespace glisson::contact
