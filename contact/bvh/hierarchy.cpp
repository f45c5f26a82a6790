#include <glisson/contact/bvh/hierarchy.hpp>

namespace glisson::contact {
namespace {

using Nodes = std::span<const Vec3<double>>;

Vec3<double> corner(Nodes x, const Triangle& triangle, std::size_t k) {
  return x[static_cast<std::size_t>(triangle[k])];
}

NormalCone leaf_cone(const Triangle& triangle, Nodes x) {
  const Vec3<double> a = corner(x, triangle, 0);
  return cone_of(cross(corner(x, triangle, 1) - a, corner(x, triangle, 2) - a));
}

}  // namespace

void refit_box(Hierarchy& h, int node, std::span<const Triangle> triangles, Nodes x, Nodes x_next) {
  const auto n = static_cast<std::size_t>(node);
  const Hierarchy::Node& it = h.nodes[n];
  Box box;
  if (it.triangle >= 0) {
    const Triangle& triangle = triangles[static_cast<std::size_t>(it.triangle)];
    for (std::size_t k = 0; k < 3; ++k) {
      box = united(box, corner(x, triangle, k));
      if (!x_next.empty()) box = united(box, corner(x_next, triangle, k));
    }
    box = inflated(box, h.settings.margin);
  } else {
    for (const int c : it.child)
      if (c >= 0) box = united(box, h.box[static_cast<std::size_t>(c)]);
  }
  h.box[n] = box;
}

void refit_node(Hierarchy& h, int node, std::span<const Triangle> triangles, Nodes x, Nodes x_next) {
  refit_box(h, node, triangles, x, x_next);
  const auto n = static_cast<std::size_t>(node);
  const Hierarchy::Node& it = h.nodes[n];
  if (it.triangle >= 0) {
    h.cone[n] = leaf_cone(triangles[static_cast<std::size_t>(it.triangle)], x_next.empty() ? x : x_next);
    return;
  }
  NormalCone cone = it.connected ? NormalCone{} : any_direction();
  for (const int c : it.child)
    if (c >= 0) cone = merged(cone, h.cone[static_cast<std::size_t>(c)], h.settings.cones);
  h.cone[n] = cone;
}

void refit(Hierarchy& hierarchy, std::span<const Triangle> triangles, Nodes x, Nodes x_next) {
  for (const int n : hierarchy.by_level) refit_node(hierarchy, n, triangles, x, x_next);
}

}  // namespace glisson::contact
