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

/// Coefficient times the modulus that scales hourglass stiffness [Pa]: lambda + 2 mu for h8_fixed (Joldes et
/// al. 2008); for h8 at most 4 mu, its value at nu = 1/3, because modes without volume change lock when
/// lambda grows with nu -> 1/2.
double hourglass_stiffness(const Section& section, const std::vector<double>& parameters);

}  // namespace glisson
