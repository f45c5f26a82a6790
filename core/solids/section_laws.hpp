// A section's material in double: parameters of each element and what set-up needs of the law.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>

namespace glisson {

/// Parameters of the k-th element of a section, with per-element values in place [parameter_count].
void element_parameters(const Section& section, std::size_t k, std::vector<double>& parameters);

/// Moduli at rest [Pa].
struct RestModuli {
  double shear = 0, bulk = 0, wave = 0;
};
RestModuli rest_moduli(const std::string& law, const std::vector<double>& parameters);

/// lambda + 2 mu that scales hourglass stiffness: bulk + 4/3 shear [Pa].
double hourglass_stiffness(const Section& section, const std::vector<double>& parameters);

}  // namespace glisson
