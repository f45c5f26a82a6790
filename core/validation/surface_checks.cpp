// Rigid surfaces: friction that exists, facets that have a front each, the same one for all.
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/validation/checks.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace glisson::detail {
namespace {

/// Height over length below which the normal of a triangle is rounding in single precision.
constexpr double flattest = 1e-6;

std::string facet_text(std::size_t f) { return "facet " + std::to_string(f); }

/// Names the file of the facets and, where it is known, the line of this one.
[[noreturn]] void refuse_facet(const RigidSurface& surface, const std::string& where, std::size_t f,
                               const std::string& message) {
  throw Error(ErrorKind::input, message,
              {surface.file, f < surface.facet_lines.size() ? surface.facet_lines[f] : 0, where});
}

class FacetCheck {
 public:
  FacetCheck(const RigidSurface& surface, const std::string& where) : surface_(surface), where_(where) {}

  void operator()(std::size_t f) const {
    const Facet& facet = surface_.surface.facets[f];
    check_nodes(facet, f);
    const auto area = area_vector(facet, surface_.surface.X);
    const double size = std::sqrt(dot(area, area)), longest = longest_squared(facet);
    if (!std::isfinite(size) || !std::isfinite(longest))
      refuse(f, facet_text(f) + " is too large: its area is no number any more; check its nodes");
    if (!(2 * size > flattest * longest))
      refuse(f,
             facet_text(f) + (facet.node_count() == 4 ? " crosses itself or has no area" : " has no area") +
                 ", so it has no front: its height is " + number_text(longest > 0 ? 2 * size / longest : 0) +
                 " of its length. Remove it or merge its nodes");
    if (facet.node_count() == 4) check_corners(facet, f, (1 / size) * area);
  }

 private:
  [[noreturn]] void refuse(std::size_t f, const std::string& message) const {
    refuse_facet(surface_, where_, f, message);
  }
  const Vec3<double>& corner(const Facet& facet, int a) const {
    const int count = facet.node_count();
    return surface_.surface
        .X[static_cast<std::size_t>(facet.nodes[static_cast<std::size_t>((a + count) % count)])];
  }
  void check_nodes(const Facet& facet, std::size_t f) const {
    const auto begin = facet.nodes.begin(), end = begin + facet.node_count();
    for (auto n = begin; n != end; ++n) {
      if (*n < 0 || *n >= static_cast<int>(surface_.surface.X.size()))
        refuse(f, facet_text(f) + " names node " + std::to_string(*n) + ", but its nodes are 0 to " +
                      std::to_string(surface_.surface.X.size() - 1));
      if (std::find(begin, n, *n) != n)
        refuse(f, facet_text(f) + " names node " + std::to_string(*n) +
                      " twice, so it has no area there; remove it, or list it as a triangle");
    }
  }
  double longest_squared(const Facet& facet) const {
    double longest = 0;
    for (int a = 0; a < facet.node_count(); ++a)
      for (int b = 0; b < a; ++b) {
        const auto d = corner(facet, a) - corner(facet, b);
        longest = std::max(longest, dot(d, d));
      }
    return longest;
  }
  /// A quadrilateral is used as two triangles, which must both have its front.
  void check_corners(const Facet& facet, std::size_t f, const Vec3<double>& normal) const {
    for (int a = 0; a < 4; ++a) {
      const auto &before = corner(facet, a - 1), &it = corner(facet, a), &after = corner(facet, a + 1);
      const auto turn = cross(after - it, before - it);
      if (!(dot(turn, normal) > flattest * longest_squared(facet)))
        refuse(f, facet_text(f) + " is not convex at its node " +
                      std::to_string(facet.nodes[static_cast<std::size_t>(a)]) +
                      ": list the nodes in their order around it, or divide it into triangles");
    }
  }

  const RigidSurface& surface_;
  const std::string& where_;
};

void check_repeated(const RigidSurface& s, const std::string& where) {
  std::map<std::array<int, 4>, std::size_t> seen;
  for (std::size_t f = 0; f < s.surface.facets.size(); ++f) {
    auto nodes = s.surface.facets[f].nodes;
    std::sort(nodes.begin(), nodes.end());
    if (const auto [first, is_new] = seen.emplace(nodes, f); !is_new)
      refuse_facet(s, where, f,
                   "facets " + std::to_string(first->second) + " and " + std::to_string(f) +
                       " have the same nodes, so they have no side of their own; remove one of them");
  }
}

struct Owner {
  std::size_t facet;
  bool forward;  ///< runs from the lower node to the higher one
};

[[noreturn]] void refuse_edge(const RigidSurface& s, const std::string& where, std::pair<int, int> edge,
                              const std::vector<Owner>& owners) {
  const std::string nodes = "nodes " + std::to_string(edge.first) + " and " + std::to_string(edge.second);
  if (owners.size() == 2)
    refuse_facet(s, where, owners[1].facet,
                 "facets " + std::to_string(owners[0].facet) + " and " + std::to_string(owners[1].facet) +
                     " face opposite sides: both run the same way along the edge between the " + nodes +
                     ". Turn one of them round (list its nodes backwards)");
  std::string facets;
  for (std::size_t i = 0; i < owners.size() && i < 6; ++i)
    facets += (i > 0 ? ", " : "") + std::to_string(owners[i].facet);
  refuse_facet(s, where, owners[2].facet,
               std::to_string(owners.size()) + " facets (" + facets + ") share the edge between the " +
                   nodes +
                   ", but there are two at most at an edge with a front and a back. Remove what is "
                   "too much, or give the parts nodes of their own");
}

/// An edge has one owner (border) or two that run along it in opposite directions.
void check_edges(const RigidSurface& s, const std::string& where) {
  std::map<std::pair<int, int>, std::vector<Owner>> edges;
  for (std::size_t f = 0; f < s.surface.facets.size(); ++f) {
    const Facet& facet = s.surface.facets[f];
    for (int a = 0; a < facet.node_count(); ++a) {
      const int from = facet.nodes[static_cast<std::size_t>(a)];
      const int to = facet.nodes[static_cast<std::size_t>((a + 1) % facet.node_count())];
      edges[std::minmax(from, to)].push_back({f, from < to});
    }
  }
  for (const auto& [edge, owners] : edges)
    if (owners.size() > 2 || (owners.size() == 2 && owners[0].forward == owners[1].forward))
      refuse_edge(s, where, edge, owners);
}

}  // namespace

void check_rigid_surfaces(const Model& model) {
  for (std::size_t i = 0; i < model.surfaces.size(); ++i) {
    const RigidSurface& s = model.surfaces[i];
    const std::string where = s.name.empty() ? "ContactSurface " + std::to_string(i) : s.name;
    check_friction(s.friction, where);
    check_penalty(s.penalty, where);
    if (s.distance && !(*s.distance >= 0 && std::isfinite(*s.distance)))
      refuse(where,
             "its rate constraint distance is " + number_text(*s.distance) + ", but must not be negative");
    if (s.surface.facets.empty()) refuse(where, "it has no facet, so nothing can touch it");
    const FacetCheck check(s, where);
    for (std::size_t f = 0; f < s.surface.facets.size(); ++f) check(f);
    check_repeated(s, where);
    check_edges(s, where);
    check_volumes(s, where);
  }
}

}  // namespace glisson::detail
