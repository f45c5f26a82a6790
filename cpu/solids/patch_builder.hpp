// Cuts elements into patches and fills their memory.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <glisson/core/numbering.hpp>
#include <glisson/cpu/solids/arena.hpp>
#include <glisson/cpu/solids/element_parameters.hpp>
#include <glisson/cpu/solids/kernel_table.hpp>

namespace glisson::patches {

/// Shape of a formulation in memory. An item is what one lane holds: a strip of tetrahedra or a hexahedron.
struct Layout {
  int corners;  ///< nodes per item
  int elements_per_item;
  int constants;        ///< per element
  int points;           ///< with history, per element
  int items_per_patch;  ///< so that the force rows stay in the first cache
};
Layout layout_of(Kind kind);

/// Elements that one kernel can run: same kind, law and Prony terms.
struct Block {
  Kind kind = Kind::t4;
  const LawTable* law = nullptr;
  std::vector<PronyTerm> isochoric, volumetric;
  int first_patch = 0, patch_count = 0;
  int terms() const { return static_cast<int>(isochoric.size() + volumetric.size()); }
};

/// One lane of a patch.
struct Item {
  std::array<int, 8> node{};               ///< internal numbers; those beyond `corners` repeat a real one
  std::array<int, 3> element{-1, -1, -1};  ///< user's numbers
  int corners = 0;                         ///< real ones
  int urgency = 0;                         ///< the largest stay in this patch
};

class PatchBuilder {
 public:
  PatchBuilder(const Model& model, const Numbering& numbering, ElementParameters& parameters, int width,
               Arena& arena);

  /// Appends the patches of a block; `elements` (user's numbers, in internal order) is consumed.
  void add(Block& block, std::vector<int> elements, std::vector<Patch>& patches);

  int slot_count() const { return slot_count_; }
  int largest_node_count() const { return largest_node_count_; }
  int largest_row_count() const { return largest_row_count_; }

 private:
  struct LocalNode {
    int node, rows, elements;
  };
  /// Where the numbers of the elements of a patch go.
  struct Arrays {
    int* element;  ///< null: not kept
    float *parameters, *constants;
  };
  std::vector<Item> tetrahedron_items(std::span<const int> elements);
  void add_patch(const Block& block, std::span<const Item> items, std::vector<Patch>& patches);
  std::vector<LocalNode> sorted_nodes(const Layout& layout, std::span<const Item> items, int& interior);
  void write_corners_and_rows(const Layout& layout, std::span<const Item> items,
                              std::span<const LocalNode> nodes, std::uint16_t* corner,
                              std::uint16_t* row) const;
  void write_elements(const Block& block, const Layout& layout, std::span<const Item> items, bool uniform,
                      const Patch& patch, const Arrays& to);
  bool same_parameters(std::span<const Item> items);

  const Model& model_;
  const Numbering& numbering_;
  ElementParameters& parameters_;
  int width_;
  Arena& arena_;
  std::vector<int> valence_;  ///< elements around an internal node [node_count]
  std::vector<int> local_;  ///< scratch: local number of an internal node, -1 outside of a patch [node_count]
  int slot_count_ = 0, largest_node_count_ = 0, largest_row_count_ = 0;
};

}  // namespace glisson::patches
