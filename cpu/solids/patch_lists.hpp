// Which nodes a patch has and where the rows of its forces lie: the same for every kind of element.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/cpu/memory.hpp>
#include <glisson/cpu/solids/patch.hpp>

namespace glisson::patches {

/// Shape of a formulation in memory. An item is what one lane holds: one element, a strip of up to three or
/// a column.
struct Layout {
  int corners;  ///< nodes per item
  int elements_per_item;
  int constants;        ///< per element
  int points;           ///< with history, per element
  int items_per_patch;  ///< so that the force rows stay in the first cache
  int new_corners = 1;  ///< from one element of an item to the next; 0: they are taken for one element

  /// In an item with so many real corners.
  int corners_of_element(int real) const {
    return new_corners == 0 ? real : corners - new_corners * (elements_per_item - 1);
  }
  int elements(int real) const {
    return new_corners == 0 ? 1 : (real - corners_of_element(real)) / new_corners + 1;
  }
};

/// One lane of a patch.
struct Item {
  std::array<int, column_corners> node{};  ///< internal numbers; those beyond `corners` repeat a real one
  std::array<int, 3> element{-1, -1, -1};  ///< user's numbers
  int corners = 0;                         ///< real ones
  int urgency = 0;                         ///< the largest stay in this patch
};

/// What fits into it need not be fetched ahead [bytes]; today's cores have 0.5 to 2 MiB.
constexpr std::size_t second_cache = std::size_t{1} << 20;

/// For steps of dt [s].
std::vector<PronyCoefficients<float>> prony_terms(std::span<const PronyTerm> terms, double dt);

/// Places in one block of memory, each aligned to a cache line.
class MemoryPlan {
 public:
  template <class T>
  std::size_t add(std::size_t count) {
    const std::size_t place = bytes_;
    bytes_ += (count * sizeof(T) + detail::cache_line - 1) / detail::cache_line * detail::cache_line;
    return place;
  }
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

/// The nodes of one patch in their local order, and how their rows are summed.
struct PatchOutline {
  struct Node {
    int node, rows, elements;
  };
  Patch patch;  ///< the counts; no pointers yet
  std::vector<Node> nodes;
  std::vector<SumRun> runs;
  std::size_t rows = 0;
};

/// Where lists go.
struct PatchListArrays {
  int* node;
  SumRun* run;
  std::uint16_t *row, *corner;
};

class PatchLists {
 public:
  PatchLists(int node_count, int width);

  /// Before the first outline: one more element has this (internal) node.
  void count(int node) { ++valence_[static_cast<std::size_t>(node)]; }
  /// The next patch. Must be followed by write().
  PatchOutline outline(const Layout& layout, std::span<const Item> items);
  void write(const PatchOutline& outline, const Layout& layout, std::span<const Item> items,
             const PatchListArrays& to);

  int slot_count() const { return slot_count_; }
  int largest_node_count() const { return largest_node_count_; }
  int largest_row_count() const { return largest_row_count_; }

 private:
  void sort_nodes(const Layout& layout, std::span<const Item> items, PatchOutline& outline);
  void write_corners_and_rows(const PatchOutline& outline, const Layout& layout, std::span<const Item> items,
                              std::uint16_t* corner, std::uint16_t* row) const;

  int width_;
  std::vector<int> valence_;  ///< elements around an internal node                       [node_count]
  std::vector<int> local_;    ///< scratch: number in the patch, -1 outside of it         [node_count]
  int slot_count_ = 0, largest_node_count_ = 0, largest_row_count_ = 0;
};

}  // namespace glisson::patches
