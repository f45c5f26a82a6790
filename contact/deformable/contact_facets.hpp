// The facets that take part in contact between deformable bodies: outer facets of solids, and membranes and
// shells with their thickness. Host data.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/numbering.hpp>

namespace glisson::contact {

/// A point beside a node, along the mean normal of the facets around the point.
struct SidePoint {
  int node = 0;         ///< place in ContactFacets::nodes
  double distance = 0;  ///< half of the thickness at rest; in ContactMesh more at edges [m]
};

struct ContactFacet {
  std::array<int, 4> point{-1, -1, -1, -1};  ///< corners, outward by the right-hand rule; a triangle ends -1
  int body = 0;       ///< 0 for elements without a name, k + 1 for Model::bodies_by_name[k]
  int sheet = -1;     ///< a side or the rim of this one of Mesh::triangles; -1: of a solid
  bool back = false;  ///< of a sheet: the side that its normal points away from

  int corner_count() const { return point[3] < 0 ? 3 : 4; }
};

/// Corner numbers below node_count are places in `nodes`, those from there on are side points.
struct ContactFacets {
  std::vector<int> nodes;  ///< of the mesh, rising; or as their internal numbers rise
  std::vector<SidePoint> beside;
  std::vector<ContactFacet> facets;  ///< those of the solids first
};

/// A shell triangle that covers an outer facet of a solid moves it outward by half of its thickness; one in a
/// solid does nothing; all others have two sides, half a thickness off their nodes (Johnsen 2016, section
/// 5.3.3), and a rim at free borders. At nodes of a solid, and where more than two triangles meet at an edge
/// or two parts of a sheet at a node, a sheet has no thickness.
ContactFacets contact_facets(const Model& model);
/// The same with the nodes in the order of the engine, in which neighbours lie near each other.
ContactFacets contact_facets(const Model& model, const Numbering& numbering);

/// body of each solid element and of each shell triangle, as ContactFacet::body.
std::vector<int> body_of_elements(const Model& model);
std::vector<int> body_of_triangles(const Model& model);
/// The body of a name, as ContactFacet::body. where: what asks for it. Throws Error(input) there.
int body_named(const Model& model, const std::string& name, const std::string& where);

}  // namespace glisson::contact
