// Broad phase in parts: pairs of triangles of one surface whose boxes overlap and whose regions may touch.
#pragma once

#include <functional>
#include <span>

#include <glisson/contact/bvh/pairs.hpp>
#include <glisson/contact/host_parts.hpp>

namespace glisson::contact {

class PairSearch {
 public:
  using MayTouch = std::function<bool(int region_a, int region_b)>;

  /// region: of each triangle. may_touch: whether two may, or one with itself; asked by several threads.
  PairSearch(const Hierarchy& hierarchy, std::span<const int> region, MayTouch may_touch);

  /// Whether cones say anything that regions do not: if false, they need not fit.
  bool uses_cones() const { return uses_cones_; }
  /// Pairs of the boxes as they are, in an order that depends on nothing but the hierarchy and its boxes.
  /// threshold: as for overlapping_pairs. Returns the number of subtrees tested.
  int find(const Hierarchy& hierarchy, double threshold, const HostParts& parts, Pairs& found);

 private:
  /// Two subtrees, or one with itself.
  using Task = std::pair<int, int>;
  struct Part {
    std::vector<Task> open;
    Pairs found;
    int subtrees = 0;
  };
  void step(const Hierarchy& h, double threshold, Part& part) const;
  void open_one(const Hierarchy& h, int n, Part& part) const;
  void open_two(const Hierarchy& h, Task task, Part& part) const;
  bool may_touch(int a, int b) const;
  void divide(const Hierarchy& h, double threshold);

  MayTouch may_touch_;
  std::vector<int> region_;  ///< of all triangles below a node; -1: several  [node_count]
  bool uses_cones_ = false;
  std::vector<Part> parts_;
};

}  // namespace glisson::contact
