// Rigid surfaces: friction that exists, facets that have a front each, the same one for all.
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/validation/checks.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace glisson::detail {
namespace {

void check_corners(const RigidSurface& s, const std::string& where) {
  if (s.surface.facets.empty()) refuse(where, "it has no facet, so nothing can touch it");
  for (std::size_t f = 0; f < s.surface.facets.size(); ++f) {
    const Facet& facet = s.surface.facets[f];
    for (int a = 0; a < facet.node_count(); ++a) {
      const int n = facet.nodes[static_cast<std::size_t>(a)];
      if (n < 0 || n >= static_cast<int>(s.surface.X.size()))
        refuse(where, "facet " + std::to_string(f) + " names node " + std::to_string(n) +
                          ", but its nodes are 0 to " + std::to_string(s.surface.X.size() - 1));
    }
    const auto n = facet_normal(facet, s.surface.X);
    if (!(dot(n, n) > 0))
      refuse(where,
             "facet " + std::to_string(f) + " has no area, so it has no front; remove it or merge its nodes");
  }
}

/// An edge has one owner (border) or two that run along it in opposite directions.
void check_edges(const RigidSurface& s, const std::string& where) {
  std::map<std::pair<int, int>, std::size_t> owners;  // of directed edges
  for (std::size_t f = 0; f < s.surface.facets.size(); ++f) {
    const Facet& facet = s.surface.facets[f];
    for (int a = 0; a < facet.node_count(); ++a) {
      const int from = facet.nodes[static_cast<std::size_t>(a)];
      const int to = facet.nodes[static_cast<std::size_t>((a + 1) % facet.node_count())];
      const auto [other, first] = owners.emplace(std::pair{from, to}, f);
      if (!first)
        refuse(where,
               "facets " + std::to_string(other->second) + " and " + std::to_string(f) +
                   " both run from node " + std::to_string(from) + " to node " + std::to_string(to) +
                   ": they face opposite sides, or more than two facets share the edge. Turn one round, "
                   "or cut the surface there");
    }
  }
}

}  // namespace

void check_rigid_surfaces(const Model& model) {
  for (std::size_t i = 0; i < model.surfaces.size(); ++i) {
    const RigidSurface& s = model.surfaces[i];
    const std::string where = s.name.empty() ? "ContactSurface " + std::to_string(i) : s.name;
    if (!(s.friction >= 0) || !std::isfinite(s.friction))
      refuse(where, "its friction coefficient is " + number_text(s.friction) + ", but must not be negative");
    check_corners(s, where);
    check_edges(s, where);
  }
}

}  // namespace glisson::detail
