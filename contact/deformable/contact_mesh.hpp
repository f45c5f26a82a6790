// The surface of a model as contact between deformable bodies sees it: triangles, edges, connected parts.
// Host data, constant.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glisson/contact/deformable/contact_facets.hpp>
#include <glisson/contact/geometry/triangles.hpp>

namespace glisson::contact {

/// Where errors say that they come from.
constexpr const char* contact_place = "contact of deformable bodies";

/// An edge with the points opposite to it in its two triangles; the first triangle runs from node 0 to 1.
struct ContactEdge {
  std::array<int, 2> node{};  ///< points
  std::array<int, 2> opposite{};
  std::array<int, 2> triangle{};
};

/// Points are the nodes, then side points, then the centres of quadrilaterals; all but the last are corners.
/// A quadrilateral is four triangles about the mean of its corners, which follows them as a point of its own:
/// cut along one diagonal, an interface of grids that do not match could warp without opening, in a way that
/// a uniform stress works on.
struct ContactMesh {
  std::vector<int> nodes;                          ///< node of the mesh, as ContactFacets::nodes [node_count]
  std::vector<SidePoint> beside;                   ///< of the points from node_count() on
  std::vector<std::array<int, 4>> quads;           ///< corners of the points from corner_count() on
  std::vector<Vec3<double>> X;                     ///< rest position from `centre` [m]      [point_count]
  Vec3<double> centre;                             ///< of the surface's box, so that float keeps digits [m]
  std::vector<Triangle> triangles;                 ///< points; the centre of a quad last [triangle_count]
  std::vector<int> sheet;                          ///< as ContactFacet::sheet            [triangle_count]
  std::vector<ContactEdge> edges;                  ///< [edge_count]
  std::vector<std::array<int, 3>> triangle_edges;  ///< [triangle_count]
  std::vector<int> around_begin, around;           ///< triangles around each point
  std::vector<int> near_begin, near;               ///< nodes that share a facet with each node, rising
  /// Triangles that hang together at nodes, belong to one named body and are not of both sides of a sheet are
  /// a region.
  std::vector<int> region;                          ///< [triangle_count]
  std::vector<int> point_region;                    ///< of the first triangle around it, or -1 [corner_count]
  std::vector<int> part_of_region, body_of_region;  ///< part: what hangs together at nodes; body: see below
  std::vector<int> solid;       ///< what hangs together through elements, cavities included  [corner_count]
  std::vector<bool> may_touch;  ///< the node may touch facets  [node_count]
  double edge_length = 0;       ///< lower quartile at rest: the length that distances are measured by [m]
  double shortest = 0, longest = 0;  ///< height of a facet over its longest edge [m]

  int node_count() const { return static_cast<int>(nodes.size()); }
  int corner_count() const { return node_count() + static_cast<int>(beside.size()); }
  int point_count() const { return corner_count() + static_cast<int>(quads.size()); }
  bool is_corner(int point) const { return point < corner_count(); }
  /// Node that forces on a corner act on.
  int node_of(int corner) const {
    return corner < node_count() ? corner : beside[static_cast<std::size_t>(corner - node_count())].node;
  }
  /// Distance of a corner from its node [m].
  double offset_of(int corner) const {
    return corner < node_count() ? 0 : beside[static_cast<std::size_t>(corner - node_count())].distance;
  }
  double largest_offset() const;
  /// Whether a triangle of a membrane or shell is around the corner.
  bool on_sheet(int corner) const;
  /// Nodes of the facet that a triangle is a part of; -1 for none.
  std::array<int, 4> facet_nodes(int triangle) const;
  /// Mean normal at a side point for positions of the nodes, as mean_side_normal.
  Vec3<double> mean_normal(int side_point, const std::vector<Vec3<double>>& x) const;
  /// x of the nodes, to which the other points are appended.
  void append_points(std::vector<Vec3<double>>& x) const;
  int triangle_count() const { return static_cast<int>(triangles.size()); }
};

/// body_of_region: as ContactFacet::body. Throws Error(input) for an edge of solids with other than two
/// facets, which has no inside, and for nodes that are not on the surface.
ContactMesh contact_mesh(const Model& model);
/// The same with the nodes in the order of the engine: near nodes of all bodies near each other, so that a
/// thread has both sides of an interface, and the entries of a list in the order of its nodes.
ContactMesh contact_mesh(const Model& model, const Numbering& numbering);

}  // namespace glisson::contact
