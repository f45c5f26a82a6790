// Box and cone of one node of a hierarchy (Johnsen 2016, algorithm 5.4), for the host's arrays and a
// device's. Tree: margin, rule, connected(n), box(n), cone(n) and for_each_child(n, use).
#pragma once

#include <glisson/contact/bvh/box.hpp>
#include <glisson/contact/bvh/normal_cone.hpp>

namespace glisson::contact {

/// A leaf around the triangle a, b, c. Without cones, the cone stays, here and below.
template <class Tree>
GLISSON_HD void fit_leaf(const Tree& tree, int n, const Vec3<double>& a, const Vec3<double>& b,
                         const Vec3<double>& c, bool cones) {
  tree.box(n) = inflated(united(united(Box{a, a}, b), c), tree.margin);
  if (cones) tree.cone(n) = cone_of(cross(b - a, c - a));
}

/// Another node around its children.
template <class Tree>
GLISSON_HD void fit_inner(const Tree& tree, int n, bool cones) {
  Box box;
  NormalCone cone = tree.connected(n) ? NormalCone{} : any_direction();
  tree.for_each_child(n, [&](int child) {
    box = united(box, tree.box(child));
    if (cones) cone = merged(cone, tree.cone(child), tree.rule);
  });
  tree.box(n) = box;
  if (cones) tree.cone(n) = cone;
}

}  // namespace glisson::contact
