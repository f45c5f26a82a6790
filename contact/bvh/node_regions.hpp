// Regions of the surface below the nodes of a hierarchy: what a search need not open.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <glisson/contact/bvh/hierarchy.hpp>

namespace glisson::contact {

struct NodeRegions {
  std::vector<int> of_node;  ///< of all triangles below; -1: several  [node_count]
  /// A connected patch of several triangles may touch itself: then cones say what regions do not.
  bool uses_cones = false;
};
/// of_triangle: region of each; may_touch: whether two may, or one with itself.
NodeRegions node_regions(const Hierarchy& hierarchy, std::span<const int> of_triangle,
                         const std::function<bool(int region_a, int region_b)>& may_touch);

}  // namespace glisson::contact
