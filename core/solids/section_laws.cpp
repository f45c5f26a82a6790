#include <glisson/core/solids/section_laws.hpp>

#include <algorithm>

#include <glisson/core/base/error.hpp>
#include <glisson/core/materials/laws.hpp>

namespace glisson {

void element_parameters(const Section& section, std::size_t k, std::vector<double>& parameters) {
  parameters = section.material.parameters;
  for (const auto& [index, values] : section.material.element_parameters)
    parameters[static_cast<std::size_t>(index)] = values[k];
}

RestModuli rest_moduli(const std::string& law, const std::vector<double>& parameters) {
  RestModuli moduli;
  bool found = false;
  for_each_type(AllLaws<double>{}, [&]<class L>() {
    if (law != L::name) return;
    found = true;
    if (parameters.size() != static_cast<std::size_t>(L::parameter_count))
      throw Error(ErrorKind::input, "The law " + law + " needs " + std::to_string(L::parameter_count) +
                                        " parameters, not " + std::to_string(parameters.size()) + ".");
    const L value = L::load(parameters.data());
    moduli = {value.shear_modulus(), value.bulk_modulus(), value.wave_modulus()};
  });
  if (!found) throw Error(ErrorKind::input, "There is no law '" + law + "'. Use LE, NH, AB, PY, TI or OG.");
  return moduli;
}

double hourglass_stiffness(const Section& section, const std::vector<double>& parameters) {
  const RestModuli moduli = rest_moduli(section.material.law, parameters);
  const double wave = moduli.bulk + 4.0 / 3 * moduli.shear;
  const bool fixed = section.formulation == Formulation::h8_fixed;
  return section.hourglass * (fixed ? wave : std::min(wave, 4 * moduli.shear));
}

}  // namespace glisson
