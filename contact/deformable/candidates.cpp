#include <glisson/contact/deformable/candidates.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include <glisson/contact/geometry/closest_points.hpp>

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
/// A node meets facets that it faces by at least this much [cosine].
constexpr double least_facing = 0.05;
/// Distance that a facet which the node faces not at all loses to one that it faces fully, per edge length:
/// at the flush sides of two blocks on each other the side facets are nearest but face nothing.
constexpr double bias_per_length = 0.2;

template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Half of both thicknesses, where the middles meet: less far in it is in front, farther it comes from the
/// other side. A twentieth more, for what starts at the middle. Negative: not a sheet.
double entry_depth(double half_a, double half_b) {
  if (half_a < 0 && half_b < 0) return std::numeric_limits<double>::infinity();
  return 1.05 * (std::max(half_a, 0.0) + std::max(half_b, 0.0));
}

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
      ridge_(mesh.edges.size()) {
  for (int k = 0; k < mesh.corner_count(); ++k) on_sheet_.push_back(mesh.on_sheet(k));
}

void CandidateSearch::refit_to(const std::vector<Vec3<double>>& x, double margin) {
  x_ = x;
  margin_ = margin;
  hierarchy_.settings.margin = margin;
  refit(hierarchy_, mesh_.triangles, x_);
  for (std::size_t t = 0; t < normal_.size(); ++t) {
    const Triangle& c = mesh_.triangles[t];
    const auto n = cross(x_[at(c[1])] - x_[at(c[0])], x_[at(c[2])] - x_[at(c[0])]);
    const double length = std::sqrt(dot(n, n));
    normal_[t] = (length > 0 ? 1 / length : 0) * n;
  }
  for (std::size_t e = 0; e < ridge_.size(); ++e) {
    const ContactEdge& edge = mesh_.edges[e];
    const auto aside = x_[at(edge.opposite[1])] - x_[at(edge.node[0])];
    ridge_[e] = mesh_.is_corner(edge.node[1]) &&
                dot(normal_[at(edge.triangle[0])], aside) < -ridge_slope * std::sqrt(dot(aside, aside));
  }
}

const Candidates& CandidateSearch::find(const std::vector<Vec3<double>>& x, double margin) {
  const auto timed = [](double& seconds, auto&& stage) {
    const auto start = std::chrono::steady_clock::now();
    stage();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  timed(counts_.refit_seconds, [&] { refit_to(x, margin); });
  timed(counts_.pair_seconds, [&] { find_pairs(); });
  timed(counts_.list_seconds, [&] {
    find_groups();
    find_edge_pairs();
    find_incidence();
  });
  return found_;
}

void CandidateSearch::find_pairs() {
  auto [pairs, subtrees] =
      overlapping_pairs(hierarchy_, rules_.any_self_contact() ? self_threshold : full_turn);
  std::erase_if(pairs, [&](const auto& pair) {
    return !rules_.may_touch(mesh_.region[at(pair.first)], mesh_.region[at(pair.second)]);
  });
  pairs_ = std::move(pairs);
  ++counts_.searches;
  counts_.volumes_refitted += hierarchy_.node_count();
  counts_.subtrees_tested += subtrees;
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

/// Of one solid, neighbours do not count as contacts, nor does the other side of a thin wall, which lies
/// behind the facet at rest already.
bool CandidateSearch::node_may_meet(int node, int facet) const {
  const Triangle& c = mesh_.triangles[at(facet)];
  if (mesh_.solid[at(node)] == mesh_.solid[at(c[0])]) {
    for (const int n : mesh_.facet_nodes(facet))
      if (n >= 0 && adjacent(n, node)) return false;
    const auto& A = mesh_.X[at(c[0])];
    const double rest =
        closest_on_triangle(mesh_.X[at(node)], A, mesh_.X[at(c[1])], mesh_.X[at(c[2])]).distance_squared;
    const auto N = cross(mesh_.X[at(c[1])] - A, mesh_.X[at(c[2])] - A);
    if (rest < 4 * reach_ * reach_ && dot(N, mesh_.X[at(node)] - A) < 0) return false;
  }
  if (facing(node, facet) < least_facing) return false;
  const double apart =
      closest_on_triangle(x_[at(node)], x_[at(c[0])], x_[at(c[1])], x_[at(c[2])]).distance_squared;
  return apart <= 4 * margin_ * margin_;
}

/// How much the surface around the node faces the facet: 1 where a normal is opposite to the facet's.
double CandidateSearch::facing(int node, int facet) const {
  double least = 1;
  for (int i = mesh_.around_begin[at(node)]; i < mesh_.around_begin[at(node + 1)]; ++i)
    least = std::min(least, dot(normal_[at(mesh_.around[at(i)])], normal_[at(facet)]));
  return -least;
}

/// Both directions of the pairs by triangle.
void CandidateSearch::set_partners() {
  partner_begin_.assign(mesh_.triangles.size() + 1, 0);
  for (const auto& [a, b] : pairs_) ++partner_begin_[at(a) + 1], ++partner_begin_[at(b) + 1];
  std::partial_sum(partner_begin_.begin(), partner_begin_.end(), partner_begin_.begin());
  partners_.resize(2 * pairs_.size());
  for (const auto& [a, b] : pairs_) {
    partners_[at(partner_begin_[at(a)]++)] = b;
    partners_[at(partner_begin_[at(b)]++)] = a;
  }
  for (std::size_t t = mesh_.triangles.size(); t > 0; --t) partner_begin_[t] = partner_begin_[t - 1];
  partner_begin_[0] = 0;
}

/// Facets that the node may meet, by region.
void CandidateSearch::facets_near(int node, std::vector<std::array<int, 2>>& found) {
  found.clear();
  for (int i = mesh_.around_begin[at(node)]; i < mesh_.around_begin[at(node + 1)]; ++i) {
    const int t = mesh_.around[at(i)];
    for (int j = partner_begin_[at(t)]; j < partner_begin_[at(t + 1)]; ++j) {
      const int facet = partners_[at(j)];
      if (seen_[at(facet)] == node) continue;
      seen_[at(facet)] = node;
      if (node_may_meet(node, facet)) found.push_back({mesh_.region[at(facet)], facet});
    }
  }
  std::sort(found.begin(), found.end());
}

void CandidateSearch::start_group(int node, int region, int facet) {
  found_.group_node.push_back(node);
  found_.group_region.push_back(region);
  found_.group_friction.push_back(rules_.friction(mesh_.point_region[at(node)], region));
  const bool of_sheet = mesh_.sheet[at(facet)] >= 0;
  found_.group_entry.push_back(
      entry_depth(half_thickness({&node, 1}), of_sheet ? half_thickness(mesh_.triangles[at(facet)]) : -1));
  found_.group_begin.push_back(found_.group_begin.back());
}

void CandidateSearch::find_groups() {
  set_partners();
  seen_.assign(mesh_.triangles.size(), -1);
  found_.group_node.clear();
  found_.group_region.clear();
  found_.group_begin.assign(1, 0);
  found_.group_friction.clear();
  found_.group_entry.clear();
  found_.facets.clear();
  found_.bias.clear();
  for (int node = 0; node < mesh_.corner_count(); ++node) {
    if (!mesh_.may_touch[at(mesh_.node_of(node))]) continue;
    facets_near(node, meetings_);
    for (std::size_t i = 0; i < meetings_.size(); ++i) {
      const auto [region, facet] = meetings_[i];
      if (i == 0 || region != meetings_[i - 1][0]) start_group(node, region, facet);
      found_.facets.push_back(facet);
      found_.bias.push_back(bias_per_length * mesh_.edge_length * (1 - facing(node, facet)));
      ++found_.group_begin.back();
    }
  }
}

bool CandidateSearch::edges_may_meet(int i, int j) const {
  const ContactEdge &a = mesh_.edges[at(i)], &b = mesh_.edges[at(j)];
  const auto touches = [&](const ContactEdge& e) {
    return mesh_.may_touch[at(mesh_.node_of(e.node[0]))] && mesh_.may_touch[at(mesh_.node_of(e.node[1]))];
  };
  if (!touches(a) && !touches(b)) return false;
  const auto closest = [&](const std::vector<Vec3<double>>& x) {
    return closest_of_segments(x[at(a.node[0])], x[at(a.node[1])], x[at(b.node[0])], x[at(b.node[1])]);
  };
  if (mesh_.solid[at(a.node[0])] == mesh_.solid[at(b.node[0])]) {
    for (const int n : a.node)
      for (const int m : b.node)
        if (adjacent(n, m)) return false;
    const auto rest = closest(mesh_.X);
    const auto& X = mesh_.X;
    const auto from = X[at(a.node[0])] + rest.s * (X[at(a.node[1])] - X[at(a.node[0])]);
    const auto to = X[at(b.node[0])] + rest.t * (X[at(b.node[1])] - X[at(b.node[0])]);
    const auto inward = X[at(a.opposite[0])] + X[at(a.opposite[1])] - X[at(a.node[0])] - X[at(a.node[1])];
    if (rest.distance_squared < 4 * reach_ * reach_ && dot(to - from, inward) > 0) return false;
  }
  return closest(x_).distance_squared <= 4 * margin_ * margin_;
}

void CandidateSearch::find_edge_pairs() {
  auto& edges = found_.edge_pairs;
  edges.clear();
  for (const auto& [a, b] : pairs_)
    for (const int i : mesh_.triangle_edges[at(a)])
      for (const int j : mesh_.triangle_edges[at(b)])
        if (i != j && ridge_[at(i)] && ridge_[at(j)]) edges.push_back({std::min(i, j), std::max(i, j)});
  sort_unique(edges);
  std::erase_if(edges, [&](const auto& e) { return !edges_may_meet(e[0], e[1]); });
  found_.edge_friction.clear();
  found_.edge_entry.clear();
  for (const auto& [i, j] : edges) {
    const ContactEdge &a = mesh_.edges[at(i)], &b = mesh_.edges[at(j)];
    found_.edge_friction.push_back(
        rules_.friction(mesh_.region[at(a.triangle[0])], mesh_.region[at(b.triangle[0])]));
    found_.edge_entry.push_back(entry_depth(half_thickness(a.node), half_thickness(b.node)));
  }
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
