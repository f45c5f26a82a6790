#include <glisson/contact/deformable/start_overlap.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include <glisson/contact/deformable/candidates.hpp>
#include <glisson/contact/deformable/find_touches.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Share of the search depth from which bodies may start in each other: a node that goes deeper than the
/// whole in the first steps is lost.
constexpr double largest_start_depth = 0.8;

[[noreturn]] void refuse(const std::string& message) {
  throw Error(ErrorKind::input, message, {"", 0, contact_place});
}

std::string number_of(const ContactMesh& mesh, int corner) {
  return std::to_string(mesh.nodes[at(mesh.node_of(corner))]);
}
std::string node_text(const ContactMesh& mesh, const ContactRules& rules, int corner) {
  return "node " + number_of(mesh, corner) + " of " + rules.body_name(mesh.point_region[at(corner)]);
}

/// Order in which messages name nodes: that of the file.
bool comes_first(const ContactMesh& mesh, int a, int b) {
  return mesh.nodes[at(mesh.node_of(a))] < mesh.nodes[at(mesh.node_of(b))];
}

/// Solid angle of a triangle seen from the origin (van Oosterom & Strackee 1983) [sr].
double solid_angle(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  const double x = std::sqrt(dot(a, a)), y = std::sqrt(dot(b, b)), z = std::sqrt(dot(c, c));
  return 2 * std::atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
}

/// Nodes, triangles and box of each solid at rest.
struct Solid {
  std::vector<int> nodes, triangles;
  Box box;
};

std::map<int, Solid> solids_of(const ContactMesh& mesh) {
  std::map<int, Solid> solids;
  for (int k = 0; k < mesh.corner_count(); ++k) {
    if (mesh.point_region[at(k)] < 0) continue;  // only its side points are on the surface
    Solid& its = solids[mesh.solid[at(k)]];
    its.nodes.push_back(k);
    its.box = united(its.box, mesh.X[at(k)]);
  }
  for (int t = 0; t < mesh.triangle_count(); ++t)
    solids[mesh.solid[at(mesh.triangles[at(t)][0])]].triangles.push_back(t);
  for (auto& [number, its] : solids)
    std::stable_sort(its.nodes.begin(), its.nodes.end(),
                     [&](int a, int b) { return comes_first(mesh, a, b); });
  return solids;
}

/// How deep a point lies in a solid; 0 outside. `turns` are those of the solid's triangles around the point:
/// 2 inside, 0 outside. Nothing for a point nearer than `on` to them, where rounding would decide.
std::optional<double> depth_in(const ContactMesh& mesh, const Vec3<double>& p, const Solid& solid,
                               double on) {
  double turns = 0, nearest = std::numeric_limits<double>::infinity();
  for (const int t : solid.triangles) {
    const Triangle& c = mesh.triangles[at(t)];
    const auto &a = mesh.X[at(c[0])], &b = mesh.X[at(c[1])], &d = mesh.X[at(c[2])];
    nearest = std::min(nearest, closest_on_triangle(p, a, b, d).distance_squared);
    if (nearest < on * on) return {};
    turns += solid_angle(a - p, b - p, d - p) / full_turn;
  }
  return turns > 1.5 ? std::sqrt(nearest) : 0;
}

/// Whether a node of a solid, or the point 2 `most` under it in its own solid, lies deep in another one. Of
/// two solids at the same place the nodes themselves lie on both.
bool lies_in(const ContactMesh& mesh, int node, const Vec3<double>& normal, const Solid& own,
             const Solid& other, double on, double most) {
  const auto depth = [&](double under, const Solid& solid) {
    return depth_in(mesh, mesh.X[at(node)] - under * normal, solid, on).value_or(0);
  };
  return depth(2 * on, other) > most || (depth(2 * most, other) > most && depth(2 * most, own) > 0);
}

/// Solids that share more of space than their surfaces show, in each other or at the same place; some nodes
/// of each are tried. What crosses a surface is also found by its depth.
void refuse_nested(const ContactMesh& mesh, const ContactRules& rules, double on, double most) {
  constexpr std::size_t least_tries = 20, most_triangles = 200'000;  // about 40 ms per pair
  const auto solids = solids_of(mesh);
  const auto normals = vertex_normals(mesh.triangles, mesh.X);
  for (const auto& [inner, a] : solids)
    for (const auto& [outer, b] : solids) {
      if (inner == outer || !overlap(a.box, b.box)) continue;
      std::vector<int> nodes;
      for (const int n : a.nodes)
        if (contains(b.box, mesh.X[at(n)]) &&
            rules.may_touch(mesh.point_region[at(n)], mesh.region[at(b.triangles[0])]))
          nodes.push_back(n);
      const std::size_t tries = std::max(least_tries, most_triangles / b.triangles.size());
      for (std::size_t k = 0; k < nodes.size(); k += nodes.size() / tries + 1)
        if (lies_in(mesh, nodes[k], normals[at(nodes[k])], a, b, on, most))
          refuse("the body with " + node_text(mesh, rules, nodes[k]) + " starts inside of the one with " +
                 node_text(mesh, rules, b.nodes[0]) + ". Move one of them, or forbid the pair");
    }
}

/// The surface at rest for the loop bodies.
class RestSurface {
 public:
  explicit RestSurface(const ContactMesh& mesh) : motion_(mesh.X.size()) {
    for (const auto& X : mesh.X) to_.push_back({X.x, X.y, X.z, 0});
    for (const auto& c : mesh.triangles) triangles_.push_back({{c[0], c[1], c[2]}});
    for (const auto& q : mesh.quads) quads_.push_back({{q[0], q[1], q[2], q[3]}});
    for (const SidePoint& p : mesh.beside) side_node_.push_back(p.node);
    node_count_ = mesh.node_count();
    corner_count_ = mesh.corner_count();
  }
  SurfaceView<double> view() {
    return {nullptr,     nullptr,       nullptr,    triangles_.data(), quads_.data(), side_node_.data(),
            node_count_, corner_count_, to_.data(), motion_.data(),    motion_.data()};
  }

 private:
  std::vector<Vec4<double>> to_, motion_;
  std::vector<Corners> triangles_;
  std::vector<Quad> quads_;
  std::vector<int> side_node_;
  int node_count_ = 0, corner_count_ = 0;
};

/// End (0, 1) of a segment that lies behind the triangle which the segment goes through, -1 if it does not or
/// if an end is nearer to its plane than `slack`.
/// border: through a border counts
int end_behind(const std::array<Vec3<double>, 2>& segment, const std::array<Vec3<double>, 3>& triangle,
               double slack, bool border) {
  const auto& [p, q] = segment;
  const auto& [a, b, d] = triangle;
  const auto volume = [](const Vec3<double>& x, const Vec3<double>& y, const Vec3<double>& z) {
    return dot(x, cross(y, z));
  };
  const auto normal = cross(b - a, d - a);
  const double front = dot(p - a, normal), back = dot(q - a, normal);
  if (!(front * back < 0)) return -1;
  if (std::min(std::abs(front), std::abs(back)) < slack * std::sqrt(dot(normal, normal))) return -1;
  const double s = volume(q - p, a - p, b - p), t = volume(q - p, b - p, d - p),
               w = volume(q - p, d - p, a - p);
  const double least = std::min({s, t, w}), largest = std::max({s, t, w});
  const bool through = border ? least >= 0 || largest <= 0 : least > 0 || largest < 0;
  return !through ? -1 : front < 0 ? 0 : 1;
}
int end_behind(const ContactMesh& mesh, const std::array<int, 2>& segment, const Triangle& c,
               double slack = 0) {
  const auto x = [&](int n) { return mesh.X[at(n)]; };
  return end_behind({x(segment[0]), x(segment[1])}, {x(c[0]), x(c[1]), x(c[2])}, slack, false);
}

/// What goes through the middle of a sheet at rest would have to stay there.
void refuse_through_sheet(const ContactMesh& mesh, const ContactRules& rules,
                          const std::array<int, 2>& segment, int triangle) {
  const Triangle& c = mesh.triangles[at(triangle)];
  const auto middle = [&](int n) { return mesh.X[at(mesh.is_corner(n) ? mesh.node_of(n) : n)]; };
  if (end_behind({middle(segment[0]), middle(segment[1])}, {middle(c[0]), middle(c[1]), middle(c[2])}, 0,
                 true) >= 0)
    refuse("what hangs together with " + node_text(mesh, rules, segment[mesh.is_corner(segment[0]) ? 0 : 1]) +
           " goes through the membrane or shell with the nodes " + number_of(mesh, c[0]) + " " +
           number_of(mesh, c[1]) + " " + number_of(mesh, c[2]) + ". Move one of them, or forbid the pair");
}

/// A solid whose surface goes through itself: an edge through a facet that it shares no node with. What
/// overlaps by no more than `slack` may be rounding of sides that touch.
void refuse_self_crossing(const ContactMesh& mesh, const ContactRules& rules, const Hierarchy& hierarchy,
                          double slack) {
  if (!rules.any_self_contact()) return;
  const auto same = [&](int n, int m) {
    return n == m || (mesh.is_corner(n) && mesh.is_corner(m) && mesh.node_of(n) == mesh.node_of(m));
  };
  for (const auto& [a, b] : overlapping_pairs(hierarchy, 0.9 * full_turn / 2).pairs)
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
      const Triangle &c = mesh.triangles[at(from)], &facet = mesh.triangles[at(to)];
      if (mesh.solid[at(c[0])] != mesh.solid[at(facet[0])] ||
          !rules.may_touch(mesh.region[at(a)], mesh.region[at(b)]))
        continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array edge{c[k], c[(k + 1) % 3]};
        const bool apart = std::none_of(facet.begin(), facet.end(),
                                        [&](int n) { return same(n, edge[0]) || same(n, edge[1]); });
        if (!apart || !mesh.is_corner(edge[0]) || !mesh.is_corner(edge[1])) continue;
        if (end_behind(mesh, edge, facet, slack) >= 0)
          refuse("the surface goes through itself: the edge from " + node_text(mesh, rules, edge[0]) +
                 " to node " + number_of(mesh, edge[1]) + " crosses the facet with node " +
                 number_of(mesh, facet[0]) +
                 " of the same solid. Correct the mesh, or switch self-contact off");
      }
    }
}

/// Corners of other solids behind facets that an edge at them goes through, with the solid and
/// the region of the facet.
std::vector<std::array<int, 3>> nodes_behind(const ContactMesh& mesh, const ContactRules& rules,
                                             const Hierarchy& hierarchy) {
  std::vector<std::array<int, 3>> found;
  for (const auto& [a, b] : overlapping_pairs(hierarchy, full_turn).pairs) {
    if (!rules.may_touch(mesh.region[at(a)], mesh.region[at(b)])) continue;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
      const Triangle &c = mesh.triangles[at(from)], &facet = mesh.triangles[at(to)];
      const int solid = mesh.solid[at(facet[0])];
      if (mesh.solid[at(c[0])] == solid) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array segment{c[k], c[(k + 1) % 3]};
        if (mesh.sheet[at(to)] >= 0) refuse_through_sheet(mesh, rules, segment, to);
        const int end = end_behind(mesh, segment, facet);
        if (end >= 0 && mesh.is_corner(segment[at(end)]))
          found.push_back({segment[at(end)], solid, mesh.region[at(to)]});
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

[[noreturn]] void refuse_depth(const ContactMesh& mesh, const ContactRules& rules, int node, int region,
                               const std::string& depth, double most) {
  refuse(node_text(mesh, rules, node) + " starts " + depth + " inside of another body, " +
         rules.body_name(region) + "; up to " + number_text(most) +
         " can be resolved. Move the bodies apart, or forbid the pair");
}

/// Where surfaces cross, the nodes behind must be near enough to some facet to come out again.
void refuse_deep_crossings(const ContactMesh& mesh, const ContactRules& rules, const Hierarchy& hierarchy,
                           double most) {
  std::vector<int> near, stack;
  auto behind = nodes_behind(mesh, rules, hierarchy);
  std::stable_sort(behind.begin(), behind.end(),
                   [&](const auto& a, const auto& b) { return comes_first(mesh, a[0], b[0]); });
  for (const auto& [node, solid, region] : behind) {
    const auto& p = mesh.X[at(node)];
    triangles_near(hierarchy, inflated(Box{p, p}, most), near, stack);
    const bool resolvable = std::any_of(near.begin(), near.end(), [&, solid = solid](int t) {
      const Triangle& c = mesh.triangles[at(t)];
      return mesh.solid[at(c[0])] == solid &&
             closest_on_triangle(p, mesh.X[at(c[0])], mesh.X[at(c[1])], mesh.X[at(c[2])]).distance_squared <=
                 most * most;
    });
    if (!resolvable) refuse_depth(mesh, rules, node, region, "more than " + number_text(most), most);
  }
}

}  // namespace

double start_depth(const ContactMesh& mesh, const ContactRules& rules, const ContactDistances& distances,
                   const Hierarchy& its) {
  Hierarchy hierarchy = its;
  hierarchy.settings.margin = 0;
  refit(hierarchy, mesh.triangles, mesh.X);
  const double most = largest_start_depth * distances.reach;
  refuse_self_crossing(mesh, rules, hierarchy, distances.slack);
  refuse_deep_crossings(mesh, rules, hierarchy, most);
  refuse_nested(mesh, rules, 1e-3 * mesh.edge_length, most);
  const double reach = 2 * distances.reach;
  CandidateSearch search(mesh, rules, reach, std::move(hierarchy));
  const Candidates& found = search.find(mesh.X, reach);
  RestSurface surface(mesh);
  std::vector<Touch<double>> touches(at(found.group_count()));
  std::vector<unsigned char> used(at(found.group_count()));
  const FindFacetTouch<double> find{surface.view(),
                                    found.group_node.data(),
                                    found.group_begin.data(),
                                    found.facets.data(),
                                    found.bias.data(),
                                    found.group_friction.data(),
                                    found.group_entry.data(),
                                    touches.data(),
                                    used.data(),
                                    {reach, 0, 0, distances.slack},
                                    0};
  double deepest = 0;
  int worst = -1, region = -1;
  for (int g = 0; g < found.group_count(); ++g) {
    const int node = found.group_node[at(g)], facet = found.facets[at(found.group_begin[at(g)])];
    if (mesh.solid[at(node)] == mesh.solid[at(mesh.triangles[at(facet)][0])]) continue;
    touches[at(g)] = {};
    find(g);
    if (used[at(g)] && -touches[at(g)].gap > deepest) {
      deepest = -touches[at(g)].gap;
      worst = node;
      region = mesh.region[at(facet)];
    }
  }
  if (deepest > most) refuse_depth(mesh, rules, worst, region, number_text(deepest), most);
  return deepest;
}

}  // namespace glisson::contact
