// Which nodes may meet which facets.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <glisson/contact/deformable/candidates.hpp>
#include <glisson/contact/geometry/closest_points.hpp>

namespace glisson::contact {
namespace {

constexpr int nodes_per_part = 128;
/// A node meets facets that it faces by at least this much [cosine].
constexpr double least_facing = 0.05;
/// Distance that a facet which the node faces not at all loses to one that it faces fully, per edge length:
/// at the flush sides of two blocks on each other the side facets are nearest but face nothing.
constexpr double bias_per_length = 0.2;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Least square of the distance from p to the box of a triangle.
double box_distance_squared(const Vec3<double>& p, const Vec3<double>& a, const Vec3<double>& b,
                            const Vec3<double>& c) {
  const Box box = united(united(Box{a, a}, b), c);
  const auto beyond = [](double low, double at, double high) {
    return larger(larger(low - at, at - high), 0);
  };
  const Vec3<double> d{beyond(box.low.x, p.x, box.high.x), beyond(box.low.y, p.y, box.high.y),
                       beyond(box.low.z, p.z, box.high.z)};
  return dot(d, d);
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void NodeGroups::clear() {
  group_node.clear();
  group_region.clear();
  group_begin.assign(1, 0);
  facets.clear();
  bias.clear();
  group_friction.clear();
  group_entry.clear();
}

void NodeGroups::add(const NodeGroups& more) {
  const int first = group_begin.back();
  append(group_node, more.group_node);
  append(group_region, more.group_region);
  append(facets, more.facets);
  append(bias, more.bias);
  append(group_friction, more.group_friction);
  append(group_entry, more.group_entry);
  for (std::size_t g = 1; g < more.group_begin.size(); ++g)
    group_begin.push_back(first + more.group_begin[g]);
}

/// Of one solid, neighbours do not count as contacts, nor does the other side of a thin wall, which lies
/// behind the facet at rest already.
bool CandidateSearch::node_may_meet(int node, int facet) const {
  const Triangle& c = mesh_.triangles[at(facet)];
  const auto &p = x_[at(node)], &a = x_[at(c[0])], &b = x_[at(c[1])], &d = x_[at(c[2])];
  const double most = 4 * margin_ * margin_;
  // most are told apart by their box, which is cheap; a little more, so that rounding decides nothing
  if (box_distance_squared(p, a, b, d) > (1 + 1e-9) * most) return false;
  if (mesh_.solid[at(node)] == mesh_.solid[at(c[0])]) {
    for (const int n : mesh_.facet_nodes(facet))
      if (n >= 0 && adjacent(n, node)) return false;
    const auto& A = mesh_.X[at(c[0])];
    const double rest =
        closest_on_triangle(mesh_.X[at(node)], A, mesh_.X[at(c[1])], mesh_.X[at(c[2])]).distance_squared;
    const auto N = cross(mesh_.X[at(c[1])] - A, mesh_.X[at(c[2])] - A);
    if (rest < 4 * reach_ * reach_ && dot(N, mesh_.X[at(node)] - A) < 0) return false;
  }
  return closest_on_triangle(p, a, b, d).distance_squared <= most;
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
void CandidateSearch::facets_near(int node, Scratch& scratch) const {
  scratch.meetings.clear();
  for (int i = mesh_.around_begin[at(node)]; i < mesh_.around_begin[at(node + 1)]; ++i) {
    const int t = mesh_.around[at(i)];
    for (int j = partner_begin_[at(t)]; j < partner_begin_[at(t + 1)]; ++j) {
      const int facet = partners_[at(j)];
      if (scratch.seen[at(facet)] == node) continue;
      scratch.seen[at(facet)] = node;
      if (!node_may_meet(node, facet)) continue;
      const double faces = facing(node, facet);
      if (faces >= least_facing) scratch.meetings.push_back({mesh_.region[at(facet)], facet, faces});
    }
  }
  std::sort(scratch.meetings.begin(), scratch.meetings.end(), [](const Meeting& a, const Meeting& b) {
    return std::pair{a.region, a.facet} < std::pair{b.region, b.facet};
  });
}

void CandidateSearch::start_group(int node, int region, int facet, NodeGroups& groups) const {
  groups.group_node.push_back(node);
  groups.group_region.push_back(region);
  groups.group_friction.push_back(rules_.friction(mesh_.point_region[at(node)], region));
  const bool of_sheet = mesh_.sheet[at(facet)] >= 0;
  groups.group_entry.push_back(
      entry_depth(half_thickness({&node, 1}), of_sheet ? half_thickness(mesh_.triangles[at(facet)]) : -1));
  groups.group_begin.push_back(groups.group_begin.back());
}

void CandidateSearch::list_groups(int node, Scratch& scratch, NodeGroups& groups) const {
  if (!mesh_.may_touch[at(mesh_.node_of(node))]) return;
  facets_near(node, scratch);
  int last = -1;
  for (const Meeting& m : scratch.meetings) {
    if (m.region != last) start_group(node, m.region, m.facet, groups);
    last = m.region;
    groups.facets.push_back(m.facet);
    groups.bias.push_back(bias_per_length * mesh_.edge_length * (1 - m.faces));
    ++groups.group_begin.back();
  }
}

void CandidateSearch::find_groups() {
  set_partners();
  scratch_.resize(at(parts_.workers));
  for (Scratch& scratch : scratch_) scratch.seen.assign(mesh_.triangles.size(), -1);
  group_parts_.resize(at((mesh_.corner_count() + nodes_per_part - 1) / nodes_per_part));
  in_pieces(parts_, mesh_.corner_count(), nodes_per_part, [&](int first, int last, int worker) {
    NodeGroups& groups = group_parts_[at(first / nodes_per_part)];
    groups.clear();
    for (int node = first; node < last; ++node) list_groups(node, scratch_[at(worker)], groups);
  });
  found_.clear();
  for (const NodeGroups& groups : group_parts_) found_.add(groups);
}

}  // namespace glisson::contact
