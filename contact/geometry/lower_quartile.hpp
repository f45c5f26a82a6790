// The length that stands for those of many edges: small, but not the exception.
#pragma once

#include <algorithm>
#include <vector>

namespace glisson::contact {

/// The value below which a quarter of them lie; of one at least.
inline double lower_quartile(std::vector<double> values) {
  const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), quarter, values.end());
  return *quarter;
}

}  // namespace glisson::contact
