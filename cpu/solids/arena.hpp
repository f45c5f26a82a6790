// Memory for many blocks that are freed together, without the copies and slack of a growing vector.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

#include <glisson/cpu/memory.hpp>

namespace glisson::patches {

class Arena {
 public:
  /// Zeroed, aligned to a cache line.
  std::byte* allocate(std::size_t bytes) {
    bytes = (bytes + detail::cache_line - 1) / detail::cache_line * detail::cache_line;
    if (bytes > left_) {
      const std::size_t chunk = std::max(bytes, std::clamp(used_, smallest_chunk, largest_chunk));
      chunks_.emplace_back(static_cast<std::byte*>(detail::allocate_untouched(chunk, 1)));
      next_ = chunks_.back().get();
      left_ = chunk;
    }
    std::byte* result = next_;
    std::memset(result, 0, bytes);
    next_ += bytes;
    left_ -= bytes;
    used_ += bytes;
    return result;
  }
  std::size_t used() const { return used_; }  ///< [bytes]

 private:
  struct Release {
    void operator()(std::byte* chunk) const { detail::release_untouched(chunk); }
  };
  static constexpr std::size_t smallest_chunk = std::size_t{1} << 16, largest_chunk = std::size_t{32} << 20;

  std::vector<std::unique_ptr<std::byte[], Release>> chunks_;
  std::byte* next_ = nullptr;
  std::size_t left_ = 0, used_ = 0;
};

}  // namespace glisson::patches
