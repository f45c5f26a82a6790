// Chains of up to three tetrahedra that share faces, or triangles that share sides.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace glisson::patches {

/// Simplices of N nodes: tetrahedra (4) or triangles (3). Number j of a strip has the nodes node[j] ..
/// node[j + N - 1], in an order that may turn it inside out (the inverse of the edge matrix of a tetrahedron
/// turns with it, so H does not). A short strip repeats its last node.
template <std::size_t N>
struct Strip {
  std::array<int, N + 2> node;
  std::array<int, 3> element;  ///< place in the list; -1: none
  int length() const { return element[2] >= 0 ? 3 : element[1] >= 0 ? 2 : 1; }
  int corners() const { return length() + static_cast<int>(N) - 1; }
};

/// Each simplex in exactly one strip. Nodes are 0 .. 65535. Greedy: those with the fewest free neighbours
/// first, which leaves few alone (about 2 % of the lanes of tetrahedra stay empty).
template <std::size_t N>
std::vector<Strip<N>> build_strips(std::span<const std::array<int, N>> simplices);
extern template std::vector<Strip<3>> build_strips(std::span<const std::array<int, 3>>);
extern template std::vector<Strip<4>> build_strips(std::span<const std::array<int, 4>>);

}  // namespace glisson::patches
