// Chains of up to three tetrahedra that share faces.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace glisson::patches {

/// Tetrahedron j of a strip has the nodes node[j] .. node[j + 3], in an order that may turn it inside out
/// (the inverse of the edge matrix turns with it, so H does not). A short strip repeats its last node.
struct Strip {
  std::array<int, 6> node;
  std::array<int, 3> element;  ///< place in the list; -1: none
  int length() const { return element[2] >= 0 ? 3 : element[1] >= 0 ? 2 : 1; }
  int corners() const { return length() + 3; }
};

/// Each tetrahedron in exactly one strip. Nodes are 0 .. 65535. Greedy: those with the fewest free neighbours
/// first, which leaves few alone (about 2 % of the lanes stay empty).
std::vector<Strip> build_strips(std::span<const std::array<int, 4>> tetrahedra);

}  // namespace glisson::patches
