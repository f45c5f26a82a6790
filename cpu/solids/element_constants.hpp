// What kernels need of the rest shape of an element.
#pragma once

#include <span>
#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/cpu/solids/kernel_table.hpp>

namespace glisson::patches {

/// Numbers from an element's law at rest [Pa].
struct Stiffness {
  double bulk = 0;
  double hourglass = 0;  ///< coefficient times lambda + 2 mu
};

/// The constants of one element in the order of E::Constants (T4ANP: and 1 / bulk modulus) from its rest
/// positions [m], in the order in which the kernel visits the nodes. Strips may turn a tetrahedron inside
/// out; its volume stays positive.
void element_constants(Kind kind, std::span<const Vec3<double>> X, const Stiffness& stiffness,
                       std::vector<double>& constants);
int constant_count_of(Kind kind);
/// The cheapest kernels that can run an element with these corners [m].
Kind kind_of(Formulation formulation, std::span<const Vec3<double>> X);

}  // namespace glisson::patches
