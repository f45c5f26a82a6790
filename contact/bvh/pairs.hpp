// Broad phase: pairs of triangles whose boxes overlap.
#pragma once

#include <utility>
#include <vector>

#include <glisson/contact/bvh/hierarchy.hpp>

namespace glisson::contact {

/// {triangle of a, triangle of b}, sorted.
using Pairs = std::vector<std::pair<int, int>>;
Pairs overlapping_pairs(const Hierarchy& a, const Hierarchy& b);

struct SelfPairs {
  Pairs pairs;              ///< {lower, higher triangle}, sorted; neighbours among them
  int subtrees_tested = 0;  ///< nodes whose children were tested against each other
};
/// Pairs within one surface. A connected patch is searched only if its normals open by `threshold` or more
/// (eq. 5.3): below pi it cannot touch itself. 0 searches everything.
SelfPairs overlapping_pairs(const Hierarchy& a, double threshold);

/// Triangles whose box overlaps the box, sorted, in `found`. `stack` is scratch.
void triangles_near(const Hierarchy& a, const Box& box, std::vector<int>& found, std::vector<int>& stack);

}  // namespace glisson::contact
