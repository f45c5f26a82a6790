// The parameters of the law of one element, from its section and from per-element values.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::detail {

class ElementParameters {
 public:
  explicit ElementParameters(const Model& model);

  int section_of(int element) const { return section_[static_cast<std::size_t>(element)]; }
  /// All parameters of the element's law in file order.
  std::vector<float> operator()(int element) const;

 private:
  const Model& model_;
  std::vector<int> section_;  ///< [element_count]
  std::vector<int> place_;    ///< within the section [element_count]; empty when no section has per-element values
};

}  // namespace glisson::detail
