// What every backend without a memory of its own shares.
#pragma once

#include <algorithm>
#include <cstddef>

#include <glisson/core/force_provider.hpp>

namespace glisson {

struct HostCopies {
  static constexpr Space space = Space::host;

  template <class T>
  void copy_in(const T* from, T* to, std::size_t count) {
    std::copy_n(from, count, to);
  }
  template <class T>
  void copy_out(const T* from, T* to, std::size_t count) {
    std::copy_n(from, count, to);
  }
  void* stream() { return nullptr; }
};

}  // namespace glisson
