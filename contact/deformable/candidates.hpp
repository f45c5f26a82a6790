// Which nodes may meet which facets, and which edges which edges, while nothing moves farther than a margin:
// the broad phase of contact between deformable bodies, on the host.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glisson/contact/bvh/pairs.hpp>
#include <glisson/contact/deformable/contact_rules.hpp>

namespace glisson::contact {

/// A slot holds at most one contact: slot g < group_count() that of group g, the others that of an edge pair.
/// Everything is sorted, so that the same positions give the same lists. `nodes` are nodes, the others
/// corners and edges of the mesh.
struct Candidates {
  std::vector<int> group_node;      ///< a corner and the facets of one region [-]  [group_count]
  std::vector<int> group_region;    ///< of the facets                           [group_count]
  std::vector<int> group_begin{0};  ///< into facets                            [group_count + 1]
  std::vector<int> facets;
  std::vector<double> bias;  ///< added to the distance of a facet that the node does not face [m]  [facets]
  std::vector<double> group_friction;          ///< [-]  [group_count]
  /// Depth up to which something on the way into a sheet, or a sheet on the way into something, counts as in
  /// front of it [m]; infinite between solids  [group_count], [edge_pairs]
  std::vector<double> group_entry, edge_entry;
  std::vector<std::array<int, 2>> edge_pairs;  ///< edges of the mesh
  std::vector<double> edge_friction;           ///< [-]  [edge_pairs]
  std::vector<int> nodes;                      ///< that slots may push, rising
  std::vector<int> incident_begin{0};          ///< into incident  [nodes + 1]
  std::vector<int> incident;                   ///< slots that may push the node, rising

  int group_count() const { return static_cast<int>(group_node.size()); }
  int slot_count() const { return group_count() + static_cast<int>(edge_pairs.size()); }
};

/// What the searches of a run did.
struct SearchCounts {
  std::int64_t searches = 0, volumes_refitted = 0, subtrees_tested = 0, triangle_pairs = 0;
  double refit_seconds = 0, pair_seconds = 0, list_seconds = 0;
};

class CandidateSearch {
 public:
  /// The mesh and the rules must outlive the search. reach: distance up to which contacts are looked for [m].
  CandidateSearch(const ContactMesh& mesh, const ContactRules& rules, double reach);
  /// The same with a hierarchy of the mesh that is built already.
  CandidateSearch(const ContactMesh& mesh, const ContactRules& rules, double reach, Hierarchy hierarchy);

  /// Candidates while every point stays within `margin` - reach / 2 of x [m]  [point_count]
  const Candidates& find(const std::vector<Vec3<double>>& x, double margin);
  const SearchCounts& counts() const { return counts_; }
  const Hierarchy& hierarchy() const { return hierarchy_; }

 private:
  double half_thickness(std::span<const int> corners) const;
  void start_group(int node, int region, int facet);
  bool node_may_meet(int node, int facet) const;
  double facing(int node, int facet) const;
  bool edges_may_meet(int a, int b) const;
  bool adjacent(int a, int b) const;
  void refit_to(const std::vector<Vec3<double>>& x, double margin);
  void find_pairs();
  void set_partners();
  void facets_near(int node, std::vector<std::array<int, 2>>& found);
  void find_groups();
  void find_edge_pairs();
  template <class Use>
  void for_each_push(Use&& use);
  void find_incidence();

  const ContactMesh& mesh_;
  const ContactRules& rules_;
  double reach_, margin_ = 0;
  Hierarchy hierarchy_;
  std::vector<Vec3<double>> x_, normal_;  ///< of this search: positions, unit normals of the triangles
  std::vector<bool> ridge_;               ///< the edge sticks out  [edge_count]
  std::vector<bool> on_sheet_;            ///< a side of a sheet is around it  [corner_count]
  Pairs pairs_;
  std::vector<int> partner_begin_, partners_;  ///< triangles near each triangle, and where its list begins
  std::vector<int> seen_;                      ///< by whom a triangle or node was seen last
  std::vector<std::array<int, 2>> meetings_;   ///< {region of the facet, facet} of one node
  std::vector<int> push_place_;                ///< [node_count]
  Candidates found_;
  SearchCounts counts_;
};

}  // namespace glisson::contact
