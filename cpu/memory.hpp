// Host memory for large arrays: aligned to cache lines, in huge pages where that pays, untouched.
#pragma once

#include <cstddef>

namespace glisson::detail {

constexpr std::size_t cache_line = 64;  ///< [bytes]

/// `count` x `size` bytes aligned to a cache line, not yet touched, so that the thread that touches a page
/// first decides where it lies. Throws Error(run) when there is not that much.
void* allocate_untouched(std::size_t count, std::size_t size);
void release_untouched(void* memory) noexcept;

}  // namespace glisson::detail
