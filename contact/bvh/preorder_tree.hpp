// A hierarchy as arrays in preorder, for upload to a device: what they mean stands in bvh/device_tree.hpp.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <glisson/contact/bvh/hierarchy.hpp>

namespace glisson::contact {

/// Which triangles may touch which.
struct SearchRegions {
  std::span<const int> of_triangle;                           ///< [triangle_count]
  int count = 0;                                              ///< of regions
  std::function<bool(int region_a, int region_b)> may_touch;  ///< or one with itself
};

struct PreorderTree {
  std::vector<int> skip, parent, triangle, connected, region;  ///< [node_count]
  std::vector<int> leaf, corners;                              ///< [triangle_count], [triangle_count][3]
  std::vector<unsigned char> may_touch;                        ///< [region_count][region_count]
  std::vector<int> by_level, level_begin;  ///< as in Hierarchy, in the numbers of this order
  int region_count = 0;
  ConeRule rule = ConeRule::narrowest;
  bool uses_cones = false;  ///< a connected patch of several triangles may touch itself
};
PreorderTree preorder_tree(const Hierarchy& hierarchy, std::span<const Triangle> triangles,
                           const SearchRegions& regions);

}  // namespace glisson::contact
