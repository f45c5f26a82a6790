// Nodes that several patches touch.
#pragma once

#include <span>
#include <vector>

#include <glisson/cpu/solids/patch.hpp>
#include <glisson/cpu/team.hpp>

namespace glisson::patches {

/// Each with the places of its parts in the slot arrays.
struct SharedNodes {
  std::vector<int> node;   ///< internal number                 [count]
  std::vector<int> begin;  ///< first of its slots in `slots`   [count + 1]
  std::vector<int> slots;  ///< in the order of the patches     [slot count]
  int node_count = 0;      ///< of the mesh

  SharedNodes() = default;
  SharedNodes(std::span<const Patch> patches, int node_count, int slot_count);

  int count() const { return static_cast<int>(node.size()); }
  /// Those that the thread also moves in loops over all nodes.
  Share share(int thread, int thread_count) const;
  /// f += the sum of the parts, always in the same order.
  void sum_forces(const Pass& pass, const Share& share) const;
};

}  // namespace glisson::patches
