// The table of kernels that work with every law, for one width.
#pragma once

#include <glisson/cpu/simd/advance_rows.hpp>
#include <glisson/cpu/solids/hexahedra.hpp>
#include <glisson/cpu/solids/kernel_table.hpp>
#include <glisson/cpu/solids/node_sums.hpp>
#include <glisson/cpu/solids/tetrahedra.hpp>

namespace glisson::patches {

template <int W, Pack<W> (*function)(Pack<W>)>
void apply_function(const float* from, float* to) {
  function(Pack<W>::load(from)).store(to);
}

template <int W>
constexpr FormulationTable formulation_kernels() {
  FormulationTable k;
  k.width = W;
  k.load_displacements = load_displacements<W>;
  k.load_pressures = load_pressures<W>;
  k.sum_forces = sum_forces<W>;
  k.sum_pressures = sum_pressures<W>;
  k.pressures = tetrahedron_pressures<W>;
  k.forces[0] = tetrahedron_forces<W, AnyLaw<W>, false>;
  k.forces[1] = tetrahedron_forces<W, AnyLaw<W>, true>;
  k.forces[2] = k.forces[3] = hexahedron_forces<W, AnyLaw<W>, H8>;
  k.forces[4] = hexahedron_forces<W, AnyLaw<W>, H8Full>;
  k.forces[5] = hexahedron_forces<W, AnyLaw<W>, H8Parallelepiped>;
  k.strain_energy[0] = tetrahedron_energy<W, false>;
  k.strain_energy[1] = tetrahedron_energy<W, true>;
  k.strain_energy[2] = k.strain_energy[3] = hexahedron_energy<W, H8>;
  k.strain_energy[4] = hexahedron_energy<W, H8Full>;
  k.strain_energy[5] = hexahedron_energy<W, H8Parallelepiped>;
  k.hourglass_energy[2] = k.hourglass_energy[3] = hexahedron_hourglass_energy<W, H8>;
  k.hourglass_energy[5] = hexahedron_hourglass_energy<W, H8Parallelepiped>;
  k.nodes = {node_kernels_of<W, CentralDifference<float>>(), node_kernels_of<W, Newmark<float>>()};
  k.functions[0] = apply_function<W, rcbrt<W>>;
  k.functions[1] = apply_function<W, square_root<W>>;
  k.functions[2] = apply_function<W, log_1p<W>>;
  k.functions[3] = apply_function<W, exp_m1<W>>;
  return k;
}

}  // namespace glisson::patches
