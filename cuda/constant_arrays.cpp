#include <glisson/cuda/constant_arrays.hpp>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string_view>

namespace glisson::cuda {

void* ConstantArrays::find(std::size_t hash, const void* from, std::size_t bytes) {
  const auto [first, last] = by_hash_.equal_range(hash);
  for (auto at = first; at != last; ++at) {
    Array& array = arrays_.at(at->second);
    if (array.bytes.size() != bytes || std::memcmp(array.bytes.data(), from, bytes) != 0) continue;
    ++array.users;
    return at->second;
  }
  return nullptr;
}

int ConstantArrays::get(const Runtime& runtime, void* stream, const void* from, std::size_t bytes,
                        void** memory) {
  const std::size_t hash = std::hash<std::string_view>{}({static_cast<const char*>(from), bytes});
  const std::scoped_lock lock(mutex_);
  if ((*memory = find(hash, from, bytes)) != nullptr) return status::done;
  if (const int code = runtime.allocate(memory, bytes)) return code;
  if (const int code = runtime.copy_in(from, *memory, bytes, stream)) {
    runtime.release(*memory);
    return code;
  }
  const auto* first = static_cast<const std::byte*>(from);
  arrays_[*memory] = {hash, {first, first + bytes}};
  by_hash_.emplace(hash, *memory);
  return status::done;
}

bool ConstantArrays::release(const Runtime& runtime, void* memory) {
  const std::scoped_lock lock(mutex_);
  const auto found = arrays_.find(memory);
  if (found == arrays_.end()) return false;
  if (--found->second.users > 0) return true;
  const auto [first, last] = by_hash_.equal_range(found->second.hash);
  by_hash_.erase(std::find_if(first, last, [&](const auto& entry) { return entry.second == memory; }));
  arrays_.erase(found);
  runtime.release(memory);
  return true;
}

std::size_t ConstantArrays::bytes() const {
  const std::scoped_lock lock(mutex_);
  std::size_t sum = 0;
  for (const auto& [memory, array] : arrays_) sum += array.bytes.size();
  return sum;
}

}  // namespace glisson::cuda
