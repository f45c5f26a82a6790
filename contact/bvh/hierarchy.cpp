#include <glisson/contact/bvh/hierarchy.hpp>

namespace glisson::contact {
namespace {

using Nodes = std::span<const Vec3<double>>;

void refit_leaf(Hierarchy& h, std::size_t n, const Triangle& triangle, Nodes x, Nodes x_next) {
  const auto corner = [&](Nodes from, int k) {
    return from[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
  };
  Box box;
  for (int k = 0; k < 3; ++k) {
    box = united(box, corner(x, k));
    if (!x_next.empty()) box = united(box, corner(x_next, k));
  }
  const Nodes last = x_next.empty() ? x : x_next;
  h.box[n] = inflated(box, h.settings.margin);
  h.cone[n] = cone_of(cross(corner(last, 1) - corner(last, 0), corner(last, 2) - corner(last, 0)));
}

}  // namespace

void refit_node(Hierarchy& h, int node, std::span<const Triangle> triangles, Nodes x, Nodes x_next) {
  const auto n = static_cast<std::size_t>(node);
  const Hierarchy::Node& it = h.nodes[n];
  if (it.triangle >= 0) {
    refit_leaf(h, n, triangles[static_cast<std::size_t>(it.triangle)], x, x_next);
    return;
  }
  Box box;
  NormalCone cone = it.connected ? NormalCone{} : any_direction;
  for (const int c : it.child) {
    if (c < 0) break;
    box = united(box, h.box[static_cast<std::size_t>(c)]);
    cone = merged(cone, h.cone[static_cast<std::size_t>(c)], h.settings.cones);
  }
  h.box[n] = box;
  h.cone[n] = cone;
}

void refit(Hierarchy& hierarchy, std::span<const Triangle> triangles, Nodes x, Nodes x_next) {
  for (const int n : hierarchy.by_level) refit_node(hierarchy, n, triangles, x, x_next);
}

}  // namespace glisson::contact
