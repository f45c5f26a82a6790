// Cuts elements into patches and fills their memory.
#pragma once

#include <span>
#include <vector>

#include <glisson/core/numbering.hpp>
#include <glisson/cpu/solids/arena.hpp>
#include <glisson/cpu/solids/element_parameters.hpp>
#include <glisson/cpu/solids/kernel_table.hpp>
#include <glisson/cpu/solids/patch_lists.hpp>

namespace glisson::patches {

Layout layout_of(Kind kind);

/// Elements that one kernel can run: same kind, law and Prony terms.
struct Block {
  Kind kind = Kind::t4;
  const LawTable* law = nullptr;
  std::vector<PronyTerm> isochoric, volumetric;
  int first_patch = 0, patch_count = 0;
  int terms() const { return static_cast<int>(isochoric.size() + volumetric.size()); }
};

class PatchBuilder {
 public:
  PatchBuilder(const Model& model, const Numbering& numbering, ElementParameters& parameters, int width,
               Arena& arena);

  /// Appends the patches of a block; `elements` (user's numbers, in internal order) is consumed.
  void add(Block& block, std::vector<int> elements, std::vector<Patch>& patches);

  const PatchLists& lists() const { return lists_; }

 private:
  /// Where the numbers of the elements of a patch go.
  struct Arrays {
    int* element;  ///< null: not kept
    float *parameters, *constants;
  };
  template <std::size_t corners>
  std::vector<std::array<int, corners>> in_local_numbers(std::span<const int> elements,
                                                         std::vector<int>& internal);
  std::vector<Item> items_of(const Layout& layout, std::span<const int> elements);
  void add_patch(const Block& block, std::span<const Item> items, std::vector<Patch>& patches);
  void write_elements(const Block& block, const Layout& layout, std::span<const Item> items, bool uniform,
                      const Patch& patch, const Arrays& to);
  bool same_parameters(std::span<const Item> items);

  const Model& model_;
  const Numbering& numbering_;
  ElementParameters& parameters_;
  int width_;
  Arena& arena_;
  PatchLists lists_;
  std::vector<int> local_;  ///< scratch of tetrahedron_items: as in PatchLists  [node_count]
};

}  // namespace glisson::patches
