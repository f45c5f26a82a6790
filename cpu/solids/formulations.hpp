// The table of kernels that work with every law, for one width.
#pragma once

#include <glisson/cpu/solids/kernel_table.hpp>
#include <glisson/cpu/solids/node_sums.hpp>
#include <glisson/cpu/solids/tetrahedra.hpp>

namespace glisson::detail {

template <int W, Pack<W> (*function)(Pack<W>)>
void apply_function(const float* from, float* to) {
  function(Pack<W>::load(from)).store(to);
}

template <int W>
constexpr FormulationKernels formulation_kernels() {
  FormulationKernels k;
  k.width = W;
  k.load_displacements = load_displacements<W>;
  k.load_pressures = load_pressures<W>;
  k.sum_forces = sum_forces<W>;
  k.sum_pressures = sum_pressures<W>;
  k.pressures = tetrahedron_pressures<W>;
  k.forces[0] = tetrahedron_forces<W, AnyLaw<W>, false>;
  k.forces[1] = tetrahedron_forces<W, AnyLaw<W>, true>;
  k.strain_energy[0] = tetrahedron_energy<W, false>;
  k.strain_energy[1] = tetrahedron_energy<W, true>;
  k.functions[0] = apply_function<W, rcbrt<W>>;
  k.functions[1] = apply_function<W, square_root<W>>;
  k.functions[2] = apply_function<W, log_1p<W>>;
  k.functions[3] = apply_function<W, exp_m1<W>>;
  return k;
}

}  // namespace glisson::detail
