// Candidates of contact between deformable bodies by brute force: every node against every facet, every edge
// against every edge, without a hierarchy.
#pragma once

#include <algorithm>
#include <set>

#include <glisson/contact/deformable/candidates.hpp>
#include <glisson/contact/geometry/closest_points.hpp>

namespace glisson::contact {

/// Whether normals lie in a half-space with room: perceptron steps. All in a cone with a half-angle of 81
/// degrees, they end after 1 / cos(81)^2 = 41 steps at most (Novikoff 1962). What does not end before lies in
/// no cone that a search within a part may leave out, whatever formula merges cones.
inline bool in_a_half_space(const std::vector<Vec3<double>>& normals) {
  Vec3<double> w;
  for (int steps = 0; steps < 50;) {
    const auto wrong =
        std::find_if(normals.begin(), normals.end(), [&](const auto& n) { return !(dot(n, w) > 0); });
    if (wrong == normals.end()) return true;
    w = w + *wrong;
    ++steps;
  }
  return false;
}

/// What may meet by the rules of the search at the positions x, near: up to 2 margin apart.
class CandidateReference {
 public:
  CandidateReference(const ContactMesh& mesh, std::vector<Vec3<double>> x, double reach, double margin)
      : mesh_(mesh), x_(std::move(x)), reach_(reach), margin_(margin) {
    for (const Triangle& t : mesh.triangles) {
      const auto n = cross(at(x_, t[1]) - at(x_, t[0]), at(x_, t[2]) - at(x_, t[0]));
      const double length = std::sqrt(dot(n, n));
      normal_.push_back((length > 0 ? 1 / length : 0) * n);
    }
    for (const ContactEdge& e : mesh.edges) sticks_out_.push_back(sticks_out(e));
  }
  bool node_may_meet(int node, int facet) const {
    const Triangle& c = mesh_.triangles[std::size_t(facet)];
    if (distance(x_, node, c) > 2 * margin_ || facing(node, facet) < 0.05) return false;
    if (at(mesh_.solid, node) != at(mesh_.solid, c[0])) return true;
    const auto A = at(mesh_.X, c[0]), N = cross(at(mesh_.X, c[1]) - A, at(mesh_.X, c[2]) - A);
    const bool behind = dot(N, at(mesh_.X, node) - A) < 0;
    const auto corners = mesh_.facet_nodes(facet);
    return !neighbours(node, {corners.begin(), corners.end()}) &&
           !(behind && distance(mesh_.X, node, c) < 2 * reach_);
  }
  bool edges_may_meet(int i, int j) const {
    const ContactEdge &a = mesh_.edges[std::size_t(i)], &b = mesh_.edges[std::size_t(j)];
    if (!sticks_out_[std::size_t(i)] || !sticks_out_[std::size_t(j)] ||
        of_edges(x_, a, b).distance_squared > 4 * margin_ * margin_)
      return false;
    if (at(mesh_.solid, a.node[0]) != at(mesh_.solid, b.node[0])) return true;
    const auto rest = of_edges(mesh_.X, a, b);
    const auto on_a = mid(mesh_.X, a.node, rest.s), on_b = mid(mesh_.X, b.node, rest.t);
    const auto inward = mid(mesh_.X, a.opposite, 0.5) - mid(mesh_.X, a.node, 0.5);
    const bool through = rest.distance_squared < 4 * reach_ * reach_ && dot(on_b - on_a, inward) > 0;
    return !through && !neighbours(a.node[0], {b.node.begin(), b.node.end()}) &&
           !neighbours(a.node[1], {b.node.begin(), b.node.end()});
  }
  /// Whether the facets at them fit into a half-space: what touches from outside has normals that do not.
  bool node_may_be_left_out(int node, int facet) const {
    std::vector<Vec3<double>> normals{normal_[std::size_t(facet)]};
    for (int i = at(mesh_.around_begin, node); i < at(mesh_.around_begin, node + 1); ++i)
      normals.push_back(at(normal_, at(mesh_.around, i)));
    return in_a_half_space(normals);
  }
  bool edges_may_be_left_out(int i, int j) const {
    std::vector<Vec3<double>> normals;
    for (const int e : {i, j})
      for (const int t : mesh_.edges[std::size_t(e)].triangle) normals.push_back(at(normal_, t));
    return in_a_half_space(normals);
  }

 private:
  template <class T>
  static const T& at(const std::vector<T>& values, int i) {
    return values[std::size_t(i)];
  }
  static Vec3<double> mid(const std::vector<Vec3<double>>& x, const std::array<int, 2>& n, double s) {
    return (1 - s) * at(x, n[0]) + s * at(x, n[1]);
  }
  static double distance(const std::vector<Vec3<double>>& x, int node, const Triangle& c) {
    return std::sqrt(
        closest_on_triangle(at(x, node), at(x, c[0]), at(x, c[1]), at(x, c[2])).distance_squared);
  }
  static SegmentPoints<double> of_edges(const std::vector<Vec3<double>>& x, const ContactEdge& a,
                                        const ContactEdge& b) {
    return closest_of_segments(at(x, a.node[0]), at(x, a.node[1]), at(x, b.node[0]), at(x, b.node[1]));
  }
  double facing(int node, int facet) const {
    double most = -1;
    for (int i = at(mesh_.around_begin, node); i < at(mesh_.around_begin, node + 1); ++i)
      most = std::max(most, -dot(at(normal_, at(mesh_.around, i)), at(normal_, facet)));
    return most;
  }
  /// Edges to the centre of a quadrilateral lie within a facet.
  bool sticks_out(const ContactEdge& e) const {
    if (!mesh_.is_corner(e.node[0]) || !mesh_.is_corner(e.node[1])) return false;
    const auto aside = at(x_, e.opposite[1]) - at(x_, e.node[0]);
    return dot(at(normal_, e.triangle[0]), aside) < -0.03 * std::sqrt(dot(aside, aside));
  }
  /// Corners of one facet.
  bool neighbours(int node, const std::set<int>& others) const {
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const auto its = mesh_.facet_nodes(t);
      if (std::find(its.begin(), its.end(), node) == its.end()) continue;
      if (std::any_of(its.begin(), its.end(), [&](int n) { return n >= 0 && others.contains(n); }))
        return true;
    }
    return false;
  }

  const ContactMesh& mesh_;
  std::vector<Vec3<double>> x_, normal_;
  std::vector<bool> sticks_out_;  ///< [edge_count]
  double reach_, margin_;
};

}  // namespace glisson::contact
