// The number types that binary mesh files hold, and how to get them out of bytes of either byte order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace glisson::detail {

enum class NumberType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

constexpr std::size_t size_of(NumberType type) {
  constexpr std::uint8_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

constexpr bool is_integer(NumberType type) { return type < NumberType::float32; }

/// One number from unaligned bytes. swap: the bytes stand in the order that is not this machine's.
template <class T>
T load(const char* data, bool swap) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, data, sizeof(T));
  if (swap) std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// Calls f with a value of the C++ type that `type` stands for.
template <class F>
auto with_type(NumberType type, F f) {
  switch (type) {
    case NumberType::int8:
      return f(std::int8_t{});
    case NumberType::uint8:
      return f(std::uint8_t{});
    case NumberType::int16:
      return f(std::int16_t{});
    case NumberType::uint16:
      return f(std::uint16_t{});
    case NumberType::int32:
      return f(std::int32_t{});
    case NumberType::uint32:
      return f(std::uint32_t{});
    case NumberType::int64:
      return f(std::int64_t{});
    case NumberType::uint64:
      return f(std::uint64_t{});
    case NumberType::float32:
      return f(float{});
    default:
      return f(double{});
  }
}

inline double load_number(const char* data, NumberType type, bool swap) {
  return with_type(type, [&](auto kind) { return static_cast<double>(load<decltype(kind)>(data, swap)); });
}

/// Of an integer type; an unsigned number above the range of int64 comes out negative, so range checks refuse
/// it.
inline std::int64_t load_integer(const char* data, NumberType type, bool swap) {
  return with_type(type, [&](auto kind) -> std::int64_t {
    if constexpr (std::is_integral_v<decltype(kind)>)
      return static_cast<std::int64_t>(load<decltype(kind)>(data, swap));
    else
      return -1;
  });
}

}  // namespace glisson::detail
