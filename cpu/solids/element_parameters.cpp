#include <glisson/cpu/solids/element_parameters.hpp>

#include <algorithm>

namespace glisson::detail {

ElementParameters::ElementParameters(const Model& model)
    : model_(model), section_(static_cast<std::size_t>(model.mesh.element_count()), -1) {
  const bool places = std::any_of(model.sections.begin(), model.sections.end(),
                                  [](const Section& s) { return !s.material.element_parameters.empty(); });
  if (places) place_.resize(section_.size());
  for (std::size_t s = 0; s < model.sections.size(); ++s) {
    int place = 0;
    for (const int e : model.sections[s].elements) {
      section_[static_cast<std::size_t>(e)] = static_cast<int>(s);
      if (places) place_[static_cast<std::size_t>(e)] = place++;
    }
  }
}

std::vector<float> ElementParameters::operator()(int element) const {
  const MaterialSpec& material = model_.sections[static_cast<std::size_t>(section_of(element))].material;
  std::vector<float> values(material.parameters.begin(), material.parameters.end());
  for (const auto& [index, per_element] : material.element_parameters)
    values[static_cast<std::size_t>(index)] =
        static_cast<float>(per_element[static_cast<std::size_t>(place_[static_cast<std::size_t>(element)])]);
  return values;
}

}  // namespace glisson::detail
