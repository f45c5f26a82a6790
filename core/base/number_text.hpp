// A number as text for messages: shortest form that shows what matters, independent of the locale.
#pragma once

#include <charconv>
#include <string>

namespace glisson {

/// Up to `digits` significant digits, e.g. 0.3, 1e-09, 14.74.
inline std::string number_text(double value, int digits = 6) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits);
  return std::string(buffer, end.ptr);
}

}  // namespace glisson
