#include <glisson/contact/deformable/candidates.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Patches whose normals open by less are not searched: below pi by what normals may turn while a list is
/// used. Of a node that touches a facet from outside, the normals of its own facets and of that facet lie in
/// no half-space (with the normal w of one inside, the solid at -w of the node would lie behind the facet).
/// The smallest subtree with all of these facets then opens by pi at least and sets one of the node's facets
/// against the other facet; so it does for the four facets of two edges.
constexpr double self_threshold = 0.9 * full_turn / 2;
/// An edge sticks out when its triangles bend back by more than this [tangent].
constexpr double ridge_slope = 0.03;

HierarchySettings settings_for(double margin) {
  HierarchySettings settings;
  settings.margin = margin;
  return settings;
}

}  // namespace

CandidateSearch::CandidateSearch(const ContactMesh& mesh, const ContactRules& rules, double reach)
    : CandidateSearch(mesh, rules, reach, build_hierarchy(mesh.triangles, mesh.X, settings_for(reach))) {}

CandidateSearch::CandidateSearch(const ContactMesh& mesh, const ContactRules& rules, double reach,
                                 Hierarchy hierarchy)
    : mesh_(mesh),
      rules_(rules),
      reach_(reach),
      hierarchy_(std::move(hierarchy)),
      normal_(mesh.triangles.size()),
      ridge_(mesh.edges.size()),
      ridges_(mesh.triangles.size()) {
  for (int k = 0; k < mesh.corner_count(); ++k) on_sheet_.push_back(mesh.on_sheet(k));
}

PairSearch& CandidateSearch::pair_search() {
  if (!pair_search_)
    pair_search_.emplace(hierarchy_, mesh_.region,
                         [&rules = rules_](int a, int b) { return rules.may_touch(a, b); });
  return *pair_search_;
}

void CandidateSearch::refit_hierarchy() {
  const bool cones = pair_search().uses_cones();
  for (int level = 0; level < hierarchy_.level_count(); ++level) {
    const int begin = hierarchy_.level_begin[at(level)];
    in_pieces(parts_, hierarchy_.level_begin[at(level + 1)] - begin, 512, [&](int first, int last, int) {
      for (int i = begin + first; i < begin + last; ++i) {
        const int n = hierarchy_.by_level[at(i)];
        cones ? refit_node(hierarchy_, n, mesh_.triangles, x_)
              : refit_box(hierarchy_, n, mesh_.triangles, x_);
      }
    });
  }
}

void CandidateSearch::set_normals() {
  in_pieces(parts_, mesh_.triangle_count(), 512, [&](int first, int last, int) {
    for (int t = first; t < last; ++t) {
      const Triangle& c = mesh_.triangles[at(t)];
      const auto n = cross(x_[at(c[1])] - x_[at(c[0])], x_[at(c[2])] - x_[at(c[0])]);
      const double length = std::sqrt(dot(n, n));
      normal_[at(t)] = (length > 0 ? 1 / length : 0) * n;
    }
  });
}

void CandidateSearch::set_ridges() {
  in_pieces(parts_, static_cast<int>(ridge_.size()), 512, [&](int first, int last, int) {
    for (int e = first; e < last; ++e) {
      const ContactEdge& edge = mesh_.edges[at(e)];
      const auto aside = x_[at(edge.opposite[1])] - x_[at(edge.node[0])];
      ridge_[at(e)] = mesh_.is_corner(edge.node[1]) &&
                      dot(normal_[at(edge.triangle[0])], aside) < -ridge_slope * std::sqrt(dot(aside, aside));
    }
  });
  in_pieces(parts_, mesh_.triangle_count(), 512, [&](int first, int last, int) {
    for (int t = first; t < last; ++t) {
      const auto& its = mesh_.triangle_edges[at(t)];
      ridges_[at(t)] = std::any_of(its.begin(), its.end(), [&](int e) { return ridge_[at(e)] != 0; });
    }
  });
}

const Candidates& CandidateSearch::find(const std::vector<Vec3<double>>& x, double margin,
                                        const HostParts& parts, const PairSource& source) {
  const auto timed = [](double& seconds, auto&& stage) {
    const auto start = std::chrono::steady_clock::now();
    stage();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  x_ = x;
  margin_ = margin;
  parts_ = parts;
  hierarchy_.settings.margin = margin;
  timed(counts_.refit_seconds, [&] {
    if (!source) refit_hierarchy();
    set_normals();
    set_ridges();
  });
  timed(counts_.pair_seconds, [&] { find_pairs(source); });
  timed(counts_.list_seconds, [&] {
    find_groups();
    find_edge_pairs();
    find_incidence();
  });
  return found_;
}

void CandidateSearch::find_pairs(const PairSource& source) {
  const double threshold = rules_.any_self_contact() ? self_threshold : full_turn;
  if (source)
    source(x_, margin_, threshold, pairs_);
  else
    counts_.subtrees_tested += pair_search().find(hierarchy_, threshold, parts_, pairs_);
  ++counts_.searches;
  counts_.volumes_refitted += hierarchy_.node_count();
  counts_.triangle_pairs += static_cast<std::int64_t>(pairs_.size());
}

/// Whether the nodes of two corners are those of one facet.
bool CandidateSearch::adjacent(int a, int b) const {
  const int n = mesh_.node_of(a), m = mesh_.node_of(b);
  const auto first = mesh_.near.begin();
  return std::binary_search(first + mesh_.near_begin[at(n)], first + mesh_.near_begin[at(n + 1)], m);
}

/// Largest half thickness of a sheet at corners of one of its sides [m]; -1: not of a sheet.
double CandidateSearch::half_thickness(std::span<const int> corners) const {
  double half = -1;
  for (const int k : corners)
    if (on_sheet_[at(k)]) half = std::max(half, mesh_.offset_of(k));
  return half;
}

/// Calls use(node, slot) once for each node that a slot may push, slots rising.
template <class Use>
void CandidateSearch::for_each_push(Use&& use) {
  seen_.assign(mesh_.nodes.size(), -1);
  const auto once = [&](int node, int slot) {
    if (seen_[at(node)] == slot) return;
    seen_[at(node)] = slot;
    use(node, slot);
  };
  for (int g = 0; g < found_.group_count(); ++g) {
    once(mesh_.node_of(found_.group_node[at(g)]), g);
    for (int i = found_.group_begin[at(g)]; i < found_.group_begin[at(g + 1)]; ++i)
      for (const int n : mesh_.facet_nodes(found_.facets[at(i)]))
        if (n >= 0) once(n, g);
  }
  for (int k = 0; k < static_cast<int>(found_.edge_pairs.size()); ++k)
    for (const int e : found_.edge_pairs[at(k)])
      for (const int n : mesh_.edges[at(e)].node) once(mesh_.node_of(n), found_.group_count() + k);
}

void CandidateSearch::find_incidence() {
  std::vector<int>& place = push_place_;  // first the number of a node's slots, then where the next one goes
  place.assign(mesh_.nodes.size(), 0);
  for_each_push([&](int node, int) { ++place[at(node)]; });
  found_.nodes.clear();
  found_.incident_begin.assign(1, 0);
  for (int n = 0; n < mesh_.node_count(); ++n) {
    const int count = place[at(n)];
    place[at(n)] = found_.incident_begin.back();
    if (count == 0) continue;
    found_.nodes.push_back(n);
    found_.incident_begin.push_back(found_.incident_begin.back() + count);
  }
  found_.incident.resize(at(found_.incident_begin.back()));
  for_each_push([&](int node, int slot) { found_.incident[at(place[at(node)]++)] = slot; });
}

}  // namespace glisson::contact
