// The parameters of the law of one element, from its section and from per-element values.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/cpu/solids/element_constants.hpp>

namespace glisson::patches {

class ElementParameters {
 public:
  explicit ElementParameters(const Model& model);

  struct Values {
    std::vector<float> parameters;  ///< of the law, in file order
    Stiffness stiffness;
  };
  int section_of(int element) const { return section_[static_cast<std::size_t>(element)]; }
  /// Parameters are the same for all elements of the section.
  bool uniform(int section) const {
    return place_.empty() || own_values_[static_cast<std::size_t>(section)] == 0;
  }
  /// Valid until the next call.
  const Values& operator()(int element);

 private:
  Values evaluate(int section, int place) const;

  const Model& model_;
  std::vector<int> section_;  ///< -1: none                                       [element_count]
  std::vector<int>
      place_;  ///< within the section                             [element_count] or empty: nobody asks
  std::vector<char> own_values_;  ///< 1: elements of the section differ              [section_count]
  std::vector<Values> values_;    ///< of the section, or of the element asked last   [section_count]
};

}  // namespace glisson::patches
