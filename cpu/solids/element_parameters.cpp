#include <glisson/cpu/solids/element_parameters.hpp>

#include <algorithm>

#include <glisson/core/solids/section_laws.hpp>

namespace glisson::patches {

ElementParameters::ElementParameters(const Model& model)
    : model_(model), section_(static_cast<std::size_t>(model.mesh.element_count()), -1) {
  for (const Section& section : model.sections)
    own_values_.push_back(!section.material.element_parameters.empty());
  const bool places = std::find(own_values_.begin(), own_values_.end(), 1) != own_values_.end();
  if (places) place_.resize(section_.size());
  for (std::size_t s = 0; s < model.sections.size(); ++s) {
    int place = 0;
    for (const int e : model.sections[s].elements) {
      section_[static_cast<std::size_t>(e)] = static_cast<int>(s);
      if (places) place_[static_cast<std::size_t>(e)] = place++;
    }
    values_.push_back(model.sections[s].elements.empty() ? Values{} : evaluate(static_cast<int>(s), 0));
  }
}

ElementParameters::Values ElementParameters::evaluate(int section, int place) const {
  const Section& its_section = model_.sections[static_cast<std::size_t>(section)];
  std::vector<double> parameters;
  element_parameters(its_section, static_cast<std::size_t>(place), parameters);
  const RestModuli moduli = rest_moduli(its_section.material.law, parameters);
  return {{parameters.begin(), parameters.end()},
          {moduli.bulk, hourglass_stiffness(its_section, parameters)}};
}

const ElementParameters::Values& ElementParameters::operator()(int element) {
  const int section = section_of(element);
  Values& values = values_[static_cast<std::size_t>(section)];
  if (!uniform(section)) values = evaluate(section, place_[static_cast<std::size_t>(element)]);
  return values;
}

}  // namespace glisson::patches
