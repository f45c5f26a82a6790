#include <glisson/contact/bvh/hierarchy.hpp>

#include <glisson/contact/bvh/fit_node.hpp>

namespace glisson::contact {
namespace {

using Nodes = std::span<const Vec3<double>>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// As fit_node.hpp wants it.
struct HostTree {
  Hierarchy& h;
  double margin = h.settings.margin;
  ConeRule rule = h.settings.cones;

  bool connected(int n) const { return h.nodes[at(n)].connected; }
  Box& box(int n) const { return h.box[at(n)]; }
  NormalCone& cone(int n) const { return h.cone[at(n)]; }
  template <class Use>
  void for_each_child(int n, Use&& use) const {
    for (const int c : h.nodes[at(n)].child)
      if (c >= 0) use(c);
  }
};

void fit(Hierarchy& h, int n, std::span<const Triangle> triangles, Nodes x, bool cones) {
  const HostTree tree{h};
  if (!h.is_leaf(n)) return fit_inner(tree, n, cones);
  const Triangle& t = triangles[at(h.nodes[at(n)].triangle)];
  fit_leaf(tree, n, x[at(t[0])], x[at(t[1])], x[at(t[2])], cones);
}

}  // namespace

void refit_box(Hierarchy& h, int n, std::span<const Triangle> triangles, Nodes x) {
  fit(h, n, triangles, x, false);
}

void refit_node(Hierarchy& h, int n, std::span<const Triangle> triangles, Nodes x) {
  fit(h, n, triangles, x, true);
}

void refit(Hierarchy& h, std::span<const Triangle> triangles, Nodes x) {
  for (const int n : h.by_level) refit_node(h, n, triangles, x);
}

}  // namespace glisson::contact
