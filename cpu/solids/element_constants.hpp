// What kernels need of the rest shape of an element.
#pragma once

#include <span>

#include <glisson/core/model.hpp>

namespace glisson::detail {

/// Moduli of an element's law at rest [Pa].
struct Moduli {
  double wave = 0, shear = 0, bulk = 0;
};

/// Writes the constants of one element (see the kernels for their order) from its rest positions [m], in the order in which
/// the kernel visits the nodes.
void element_constants(Formulation formulation, std::span<const Vec3<double>> X, const Moduli& moduli, double hourglass,
                       double* constants);
int constant_count_of(Formulation formulation);

}  // namespace glisson::detail
