// The reference backend: one thread, one loop, written for reading.
#pragma once

#include <algorithm>
#include <cstring>
#include <new>
#include <type_traits>

#include <glisson/core/backend.hpp>
#include <glisson/cpu/host_copies.hpp>

namespace glisson {

class Serial : public HostCopies {
 public:
  /// Zeroed, 64-byte aligned.
  template <class T>
  Buffer<T> allocate(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    constexpr std::align_val_t alignment{64};
    const std::size_t bytes = std::max<std::size_t>(count * sizeof(T), 1);
    void* data = ::operator new(bytes, alignment);
    std::memset(data, 0, bytes);
    auto release = [](void*, T* memory, std::size_t) {
      ::operator delete(static_cast<void*>(memory), alignment);
    };
    return Buffer<T>(static_cast<T*>(data), {release, nullptr, count});
  }
  template <class F>
  void for_each(int n, F body) {
    for (int i = 0; i < n; ++i) body(i);
  }
};

static_assert(Backend<Serial>);

}  // namespace glisson
