// Patches in a backend's memory.
#pragma once

#include <cstdint>
#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/kernels/patch_view.hpp>
#include <glisson/core/solids/host_patches.hpp>

namespace glisson {

/// The arrays of the patches of one block of elements.
class PatchArrays {
 public:
  /// Uploads and lets the view point to the arrays.
  template <class B, class R>
  PatchArrays(B& backend, const HostPatches& patches, PatchView<R>& view) {
    const auto put = [&](auto& buffer, const auto& from, auto& pointer) {
      using T = typename std::remove_cvref_t<decltype(from)>::value_type;
      buffer = upload_constant(backend, from.data(), from.size());
      pointer = buffer.get();
      bytes_ += from.size() * sizeof(T);
    };
    put(element_begin_, patches.element_begin, view.element_begin);
    put(node_begin_, patches.node_begin, view.node_begin);
    put(interior_count_, patches.interior_count, view.interior_count);
    put(node_, patches.node, view.node);
    put(slot_, patches.slot, view.slot);
    put(shared_, patches.shared, view.shared);
    put(row_begin_, patches.row_begin, view.row_begin);
    put(row_, patches.row, view.row);
    put(corner_, patches.corner, view.corner);
    view.patch_count = patches.patch_count();
    view.stride = (patches.largest_node_count + 31) / 32 * 32;
  }
  std::size_t bytes() const { return bytes_; }

 private:
  Buffer<int> element_begin_, node_begin_, interior_count_, node_, slot_, shared_, row_begin_;
  Buffer<std::uint16_t> row_, corner_;
  std::size_t bytes_ = 0;
};

}  // namespace glisson
