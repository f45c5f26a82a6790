// Arrays that members of an ensemble only read: what has the same bytes is in the device's memory once, so
// that the patches, constants and lists of one mesh stay in its caches however many members read them.
#pragma once

#include <cstddef>
#include <mutex>
#include <unordered_map>
#include <vector>

#include <glisson/cuda/runtime.hpp>

namespace glisson::cuda {

/// Of one device. Usable from any thread. The bytes are kept on the host as well: they are compared, not only
/// their hashes.
class ConstantArrays {
 public:
  /// Memory with these bytes, which are there when this returns. The device is the current one.
  int get(const Runtime& runtime, void* stream, const void* from, std::size_t bytes, void** memory);
  /// Frees it with its last user. False: it is not from here.
  bool release(const Runtime& runtime, void* memory);
  /// Of all arrays that are in use.
  std::size_t bytes() const;

 private:
  struct Array {
    std::size_t hash = 0;
    std::vector<std::byte> bytes;
    int users = 1;
  };
  void* find(std::size_t hash, const void* from, std::size_t bytes);

  mutable std::mutex mutex_;
  std::unordered_map<void*, Array> arrays_;              ///< by their place on the device
  std::unordered_multimap<std::size_t, void*> by_hash_;  ///< places
};

}  // namespace glisson::cuda
