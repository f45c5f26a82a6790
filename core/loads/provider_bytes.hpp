// State of a provider as plain bytes for a restart: same machine type, same build.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/base/error.hpp>

namespace glisson::detail {

class ByteWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T> ByteWriter& value(const T& v) { return array(&v, 1); }
  template <class B, class T>
  ByteWriter& buffer(B& backend, const Buffer<T>& buffer, std::size_t count) {
    std::vector<T> host(count);
    if (count) backend.copy_out(buffer.get(), host.data(), count);
    return array(host.data(), count);
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  template <class T>
  ByteWriter& array(const T* data, std::size_t count) {
    const auto* begin = reinterpret_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), begin, begin + count * sizeof(T));
    return *this;
  }
  std::vector<std::byte> bytes_;
};

/// Reads what a ByteWriter wrote, in the same order; throws Error(input) when the sizes differ.
class ByteReader {
 public:
  ByteReader(std::span<const std::byte> bytes, std::string owner) : bytes_(bytes), owner_(std::move(owner)) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void value(T& v) { array(&v, 1); }
  template <class B, class T>
  void buffer(B& backend, const Buffer<T>& buffer, std::size_t count) {
    std::vector<T> host(count);
    array(host.data(), count);
    if (count) backend.copy_in(host.data(), buffer.get(), count);
  }
  void end() const {
    if (!bytes_.empty()) fail();
  }

 private:
  template <class T>
  void array(T* data, std::size_t count) {
    if (bytes_.size() / sizeof(T) < count) fail();
    if (count) std::memcpy(data, bytes_.data(), count * sizeof(T));
    bytes_ = bytes_.subspan(count * sizeof(T));
  }
  [[noreturn]] void fail() const {
    throw Error(ErrorKind::input, "The checkpoint's state of '" + owner_ +
                                      "' has the wrong size, so it belongs to another model or options. "
                                      "Resume with the model and options that wrote it.");
  }
  std::span<const std::byte> bytes_;
  std::string owner_;
};

}  // namespace glisson::detail
