// Which edges may meet which edges.
#include <algorithm>

#include <glisson/contact/deformable/candidates.hpp>
#include <glisson/contact/geometry/closest_points.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

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
  for (const auto& [a, b] : pairs_) {
    if (!ridges_[at(a)] || !ridges_[at(b)]) continue;
    for (const int i : mesh_.triangle_edges[at(a)])
      for (const int j : mesh_.triangle_edges[at(b)])
        if (i != j && ridge_[at(i)] && ridge_[at(j)]) edges.push_back({std::min(i, j), std::max(i, j)});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
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

}  // namespace glisson::contact
