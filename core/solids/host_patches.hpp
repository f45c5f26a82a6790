// Cuts blocks of elements into patches. Host arrays, ready for upload; what they mean stands in
// core/kernels/patch_view.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include <glisson/core/kernels/patch_view.hpp>
#include <glisson/core/solids/host_blocks.hpp>

namespace glisson {

/// The patches of one block.
struct HostPatches {
  std::vector<int> element_begin{0}, node_begin{0}, interior_count;
  std::vector<int> node, slot, shared, row_begin{0};
  std::vector<std::uint16_t> row, corner;
  int largest_node_count = 0;

  int patch_count() const { return static_cast<int>(interior_count.size()); }
};

/// Nodes that several patches have, of whatever block. A slot for each of the patches, in their order.
struct SharedNodes {
  std::vector<int> nodes;           ///< internal number, increasing [shared_count]
  std::vector<int> begin{0};        ///< [shared_count + 1]
  std::vector<int> shared_of_node;  ///< -1: not shared [node_count]

  int count() const { return static_cast<int>(nodes.size()); }
  int slot_count() const { return begin.back(); }
};

struct PatchCut {
  std::vector<HostPatches> blocks;
  SharedNodes shared;
};

/// Consecutive elements in the order of the blocks; a patch is full at patch_threads() elements or
/// node_limit nodes. Its nodes: those of this patch only, then the shared ones, each by falling number
/// of elements, so that neighbouring threads sum equally many rows.
template <class R>
PatchCut cut_into_patches(const std::vector<HostBlock<R>>& blocks, int node_count,
                          int node_limit = patch_node_limit);

/// X of RestView  [3][place_count]
template <class R>
std::vector<R> rest_positions(const HostPatches& patches, const Mesh& mesh, const Numbering& numbering);

/// T4ANP: 1 / volume of the T4ANP elements around a node, 0 without any [1/m^3]  [node_count]; empty when no
/// block is T4ANP.
template <class R>
std::vector<R> inverse_volumes(const std::vector<HostBlock<R>>& blocks, int node_count);

}  // namespace glisson
