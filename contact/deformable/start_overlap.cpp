#include <glisson/contact/deformable/start_overlap.hpp>

#include <algorithm>
#include <cmath>
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
  for (int k = 0; k < mesh.node_count(); ++k) {
    Solid& its = solids[mesh.solid[at(k)]];
    its.nodes.push_back(k);
    its.box = united(its.box, mesh.X[at(k)]);
  }
  for (int t = 0; t < mesh.triangle_count(); ++t)
    solids[mesh.solid[at(mesh.triangles[at(t)][0])]].triangles.push_back(t);
  return solids;
}

/// Turns of the triangles that may touch it around a node: 2 inside, 0 outside; nothing for a node that lies
/// on one of them, where rounding would decide.
std::optional<double> turns_around(const ContactMesh& mesh, const ContactRules& rules, int node,
                                   const Solid& solid, double on) {
  const auto& p = mesh.X[at(node)];
  double sum = 0;
  for (const int t : solid.triangles) {
    if (!rules.may_touch(mesh.node_region[at(node)], mesh.region[at(t)])) return 0;
    const Triangle& c = mesh.triangles[at(t)];
    const auto &a = mesh.X[at(c[0])], &b = mesh.X[at(c[1])], &d = mesh.X[at(c[2])];
    if (closest_on_triangle(p, a, b, d).distance_squared < on * on) return {};
    sum += solid_angle(a - p, b - p, d - p) / full_turn;
  }
  return sum;
}

/// A solid within another is one whose box lies in the other's and whose nodes the other goes round; a few
/// nodes are tried. What crosses a surface is found by its depth.
void refuse_nested(const ContactMesh& mesh, const ContactRules& rules, double on) {
  constexpr std::size_t tries = 20;
  const auto solids = solids_of(mesh);
  for (const auto& [inner, a] : solids)
    for (const auto& [outer, b] : solids) {
      if (inner == outer || !contains(b.box, a.box.low) || !contains(b.box, a.box.high)) continue;
      const std::size_t stride = a.nodes.size() / tries + 1;
      std::optional<double> turns;
      std::size_t k = 0;
      for (; k < a.nodes.size() && !turns; k += stride) turns = turns_around(mesh, rules, a.nodes[k], b, on);
      if (turns.value_or(0) > 1.5)
        throw Error(ErrorKind::input,
                    "Contact: the solid with node " + std::to_string(mesh.nodes[at(a.nodes[k - stride])]) +
                        " starts inside of the one with node " + std::to_string(mesh.nodes[at(b.nodes[0])]) +
                        ", so there is no way out of it. Move one of them, or forbid the pair.");
    }
}

/// The surface at rest for the loop bodies.
class RestSurface {
 public:
  explicit RestSurface(const ContactMesh& mesh) : motion_(mesh.X.size()) {
    for (const auto& X : mesh.X) to_.push_back({X.x, X.y, X.z, 0});
    for (const auto& c : mesh.triangles) triangles_.push_back({{c[0], c[1], c[2]}});
    for (const auto& q : mesh.quads) quads_.push_back({{q[0], q[1], q[2], q[3]}});
    node_count_ = mesh.node_count();
  }
  SurfaceView<double> view() {
    return {nullptr,     nullptr,    nullptr,        triangles_.data(), quads_.data(),
            node_count_, to_.data(), motion_.data(), motion_.data()};
  }

 private:
  std::vector<Vec4<double>> to_, motion_;
  std::vector<Corners> triangles_;
  std::vector<Quad> quads_;
  int node_count_ = 0;
};

/// End of a segment that lies behind the triangle which the segment goes through, -1 if it does not.
int end_behind(const ContactMesh& mesh, const std::array<int, 2>& segment, const Triangle& c) {
  const auto &p = mesh.X[at(segment[0])], &q = mesh.X[at(segment[1])];
  const auto &a = mesh.X[at(c[0])], &b = mesh.X[at(c[1])], &d = mesh.X[at(c[2])];
  const auto volume = [](const Vec3<double>& x, const Vec3<double>& y, const Vec3<double>& z) {
    return dot(x, cross(y, z));
  };
  const double front = volume(p - a, b - a, d - a), back = volume(q - a, b - a, d - a);
  if (!(front * back < 0)) return -1;
  const double s = volume(q - p, a - p, b - p), t = volume(q - p, b - p, d - p),
               w = volume(q - p, d - p, a - p);
  const bool through = (s > 0 && t > 0 && w > 0) || (s < 0 && t < 0 && w < 0);
  return !through ? -1 : front < 0 ? segment[0] : segment[1];
}

/// Surface nodes of other solids behind facets that an edge at them goes through, with the solid of the
/// facet.
std::vector<std::array<int, 2>> nodes_behind(const ContactMesh& mesh, const ContactRules& rules,
                                             const Hierarchy& hierarchy) {
  std::vector<std::array<int, 2>> found;
  for (const auto& [a, b] : overlapping_pairs(hierarchy, full_turn).pairs) {
    if (!rules.may_touch(mesh.region[at(a)], mesh.region[at(b)])) continue;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
      const Triangle &c = mesh.triangles[at(from)], &facet = mesh.triangles[at(to)];
      const int solid = mesh.solid[at(facet[0])];
      if (mesh.solid[at(c[0])] == solid) continue;
      for (std::size_t k = 0; k < 3; ++k)
        if (const int n = end_behind(mesh, {c[k], c[(k + 1) % 3]}, facet); n >= 0 && mesh.is_node(n))
          found.push_back({n, solid});
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

[[noreturn]] void refuse_depth(const ContactMesh& mesh, int node, const std::string& depth, double most) {
  throw Error(ErrorKind::input, "Contact: node " + std::to_string(mesh.nodes[at(node)]) + " starts " + depth +
                                    " inside of another solid; up to " + number_text(most) +
                                    " can be resolved. Move the bodies apart, or forbid the pair.");
}

/// Where surfaces cross, the nodes behind must be near enough to some facet to come out again.
void refuse_deep_crossings(const ContactMesh& mesh, const ContactRules& rules, double most) {
  HierarchySettings settings;
  settings.margin = 0;
  const Hierarchy hierarchy = build_hierarchy(mesh.triangles, mesh.X, settings);
  std::vector<int> near, stack;
  for (const auto& [node, solid] : nodes_behind(mesh, rules, hierarchy)) {
    const auto& p = mesh.X[at(node)];
    triangles_near(hierarchy, inflated(Box{p, p}, most), near, stack);
    const bool resolvable = std::any_of(near.begin(), near.end(), [&, solid = solid](int t) {
      const Triangle& c = mesh.triangles[at(t)];
      return mesh.solid[at(c[0])] == solid &&
             closest_on_triangle(p, mesh.X[at(c[0])], mesh.X[at(c[1])], mesh.X[at(c[2])]).distance_squared <=
                 most * most;
    });
    if (!resolvable) refuse_depth(mesh, node, "more than " + number_text(most), most);
  }
}

}  // namespace

double start_depth(const ContactMesh& mesh, const ContactRules& rules, const ContactDistances& distances) {
  refuse_nested(mesh, rules, 1e-3 * mesh.edge_length);
  refuse_deep_crossings(mesh, rules, distances.reach);
  const double reach = 2 * distances.reach;
  CandidateSearch search(mesh, rules, reach);
  const Candidates& found = search.find(mesh.X, reach);
  RestSurface surface(mesh);
  std::vector<Touch<double>> touches(at(found.group_count()));
  const FindFacetTouch<double> find{surface.view(),
                                    found.group_node.data(),
                                    found.group_begin.data(),
                                    found.facets.data(),
                                    found.bias.data(),
                                    found.group_friction.data(),
                                    touches.data(),
                                    {reach, 0, 0, distances.slack},
                                    false};
  double deepest = 0;
  int worst = -1;
  for (int g = 0; g < found.group_count(); ++g) {
    const int node = found.group_node[at(g)], facet = found.facets[at(found.group_begin[at(g)])];
    if (mesh.solid[at(node)] == mesh.solid[at(mesh.triangles[at(facet)][0])]) continue;
    touches[at(g)] = {};
    find(g);
    if (touches[at(g)].used && -touches[at(g)].gap > deepest) {
      deepest = -touches[at(g)].gap;
      worst = node;
    }
  }
  if (deepest > distances.reach) refuse_depth(mesh, worst, number_text(deepest), distances.reach);
  return deepest;
}

}  // namespace glisson::contact
