// Which nodes may meet which facets, and which edges which edges, while nothing moves farther than a margin:
// the broad phase of contact between deformable bodies, on the host.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <glisson/contact/bvh/pair_search.hpp>
#include <glisson/contact/deformable/contact_rules.hpp>

namespace glisson::contact {

/// Nodes with the facets that they may meet.
struct NodeGroups {
  std::vector<int> group_node;      ///< a corner and the facets of one region [-]  [group_count]
  std::vector<int> group_region;    ///< of the facets                           [group_count]
  std::vector<int> group_begin{0};  ///< into facets                            [group_count + 1]
  std::vector<int> facets;
  std::vector<double> bias;  ///< added to the distance of a facet that the node does not face [m]  [facets]
  std::vector<double> group_friction;  ///< [-]  [group_count]
  std::vector<double> group_entry;     ///< see Candidates::edge_entry [m]  [group_count]

  int group_count() const { return static_cast<int>(group_node.size()); }
  void clear();
  /// Appends other nodes with their facets.
  void add(const NodeGroups& more);
};

/// A slot holds at most one contact: slot g < group_count() that of group g, the others that of an edge pair.
/// Everything is sorted, so that the same positions give the same lists. `nodes` are nodes, the others
/// corners and edges of the mesh.
struct Candidates : NodeGroups {
  std::vector<std::array<int, 2>> edge_pairs;  ///< edges of the mesh
  std::vector<double> edge_friction;           ///< [-]  [edge_pairs]
  /// Depth up to which something on the way into a sheet, or a sheet on the way into something, counts as in
  /// front of it [m]; infinite between solids  [edge_pairs]
  std::vector<double> edge_entry;
  std::vector<int> nodes;              ///< that slots may push, rising
  std::vector<int> incident_begin{0};  ///< into incident  [nodes + 1]
  std::vector<int> incident;           ///< slots that may push the node, rising

  int slot_count() const { return group_count() + static_cast<int>(edge_pairs.size()); }
};

/// Half of both thicknesses, where the middles meet: less far in it is in front, farther it comes from the
/// other side. A twentieth more, for what starts at the middle. Negative: not a sheet.
inline double entry_depth(double half_a, double half_b) {
  if (half_a < 0 && half_b < 0) return std::numeric_limits<double>::infinity();
  return 1.05 * (std::max(half_a, 0.0) + std::max(half_b, 0.0));
}

/// What the searches of a run did.
struct SearchCounts {
  std::int64_t searches = 0, volumes_refitted = 0, subtrees_tested = 0, triangle_pairs = 0;
  double refit_seconds = 0, pair_seconds = 0, list_seconds = 0;
};

/// Finds the pairs of triangles in place of the host's hierarchy: for positions [point_count], a margin [m]
/// and a threshold as PairSearch::find does.
using PairSource =
    std::function<void(const std::vector<Vec3<double>>& x, double margin, double threshold, Pairs& found)>;

class CandidateSearch {
 public:
  /// The mesh and the rules must outlive the search. reach: distance up to which contacts are looked for [m].
  CandidateSearch(const ContactMesh& mesh, const ContactRules& rules, double reach);
  /// The same with a hierarchy of the mesh that is built already.
  CandidateSearch(const ContactMesh& mesh, const ContactRules& rules, double reach, Hierarchy hierarchy);

  /// Candidates while every point stays within `margin` - reach / 2 of x [m]  [point_count]
  /// The same for any parts. source: who finds the pairs, if not the host.
  const Candidates& find(const std::vector<Vec3<double>>& x, double margin, const HostParts& parts = {},
                         const PairSource& source = {});
  const SearchCounts& counts() const { return counts_; }
  const Hierarchy& hierarchy() const { return hierarchy_; }

 private:
  struct Meeting {
    int region, facet;  ///< of the facet
    double faces;
  };
  /// Of one thread.
  struct Scratch {
    std::vector<int> seen;  ///< by which node a triangle was seen last
    std::vector<Meeting> meetings;
  };

  PairSearch& pair_search();
  void refit_hierarchy();
  void set_normals();
  void set_ridges();
  void find_pairs(const PairSource& source);
  double half_thickness(std::span<const int> corners) const;
  bool adjacent(int a, int b) const;

  bool node_may_meet(int node, int facet) const;
  double facing(int node, int facet) const;
  void set_partners();
  void facets_near(int node, Scratch& scratch) const;
  void start_group(int node, int region, int facet, NodeGroups& groups) const;
  void list_groups(int node, Scratch& scratch, NodeGroups& groups) const;
  void find_groups();

  bool edges_may_meet(int a, int b) const;
  void find_edge_pairs();
  template <class Use>
  void for_each_push(Use&& use);
  void find_incidence();

  const ContactMesh& mesh_;
  const ContactRules& rules_;
  double reach_, margin_ = 0;
  Hierarchy hierarchy_;
  std::optional<PairSearch> pair_search_;  ///< of those that had to find pairs themselves
  HostParts parts_;
  std::vector<Vec3<double>> x_, normal_;  ///< of this search: positions, unit normals of the triangles
  std::vector<char> ridge_;               ///< the edge sticks out  [edge_count]
  std::vector<char> ridges_;              ///< any of its edges does  [triangle_count]
  std::vector<bool> on_sheet_;            ///< a side of a sheet is around it  [corner_count]
  Pairs pairs_;
  std::vector<int> partner_begin_, partners_;  ///< triangles near each triangle, and where its list begins
  std::vector<Scratch> scratch_;               ///< [workers]
  std::vector<NodeGroups> group_parts_;
  std::vector<int> seen_;                      ///< by which slot a node was seen last
  std::vector<int> push_place_;                ///< [node_count]
  Candidates found_;
  SearchCounts counts_;
};

}  // namespace glisson::contact
