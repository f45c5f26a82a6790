// Plain bytes of a checkpoint: same machine type, same build. The run's file format (run/) wraps them with a
// check sum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <ostream>
#include <span>
#include <type_traits>
#include <vector>

#include <glisson/core/base/error.hpp>

namespace glisson {

template <class T>
requires std::is_trivially_copyable_v<T>
void write_value(std::ostream& out, const T& value) {
  out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
requires std::is_trivially_copyable_v<T> T read_value(std::istream& in) {
  T value;
  if (!in.read(reinterpret_cast<char*>(&value), sizeof value))
    throw Error(ErrorKind::input,
                "The checkpoint ends too early. It is damaged: start the run again without --resume.");
  return value;
}

template <class T>
void write_array(std::ostream& out, std::span<const T> values) {
  write_value<std::uint64_t>(out, values.size());
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
}

/// Reads exactly `expected` values; another count means another model.
template <class T>
std::vector<T> read_array(std::istream& in, std::size_t expected) {
  const auto count = read_value<std::uint64_t>(in);
  if (count != expected)
    throw Error(ErrorKind::input, "The checkpoint holds " + std::to_string(count) +
                                      " values where this model needs " + std::to_string(expected) +
                                      ". It belongs to another model or options.");
  std::vector<T> values(expected);
  if (!in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(expected * sizeof(T))) &&
      expected)
    throw Error(ErrorKind::input,
                "The checkpoint ends too early. It is damaged: start the run again without --resume.");
  return values;
}

/// Bytes of any count, in pieces, so that a damaged count ends at the end of the stream.
inline std::vector<std::byte> read_bytes(std::istream& in) {
  auto left = read_value<std::uint64_t>(in);
  std::vector<std::byte> bytes;
  while (left > 0) {
    const std::size_t piece = left < (1u << 20) ? static_cast<std::size_t>(left) : (1u << 20);
    bytes.resize(bytes.size() + piece);
    if (!in.read(reinterpret_cast<char*>(bytes.data() + bytes.size() - piece),
                 static_cast<std::streamsize>(piece)))
      throw Error(ErrorKind::input,
                  "The checkpoint ends too early. It is damaged: start the run again without --resume.");
    left -= piece;
  }
  return bytes;
}

}  // namespace glisson
