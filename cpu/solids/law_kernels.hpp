// The functions of one law for one width, and the kernels that have the law compiled in.
#pragma once

#include <glisson/cpu/solids/hexahedra.hpp>
#include <glisson/cpu/solids/kernel_table.hpp>
#include <glisson/cpu/solids/tetrahedra.hpp>

namespace glisson::patches {

template <int W, class Stress>
GLISSON_FLATTEN void stress_function(const void* H, const void* tile, void* P) {
  Stress::stress(*static_cast<const Mat3<Pack<W>>*>(H), *static_cast<const MaterialTile*>(tile),
                 *static_cast<Mat3<Pack<W>>*>(P));
}

template <int W, template <class> class Law>
void energy_function(const void* H, const void* tile, void* energy) {
  *static_cast<Pack<W>*>(energy) = load_law<W, Law>(static_cast<const MaterialTile*>(tile)->parameters)
                                       .energy(*static_cast<const Mat3<Pack<W>>*>(H));
}

template <int W, template <class> class Law>
struct CompiledIn {
  using Type = Elastic<W, Law>;
};
template <int W>
struct CompiledIn<W, NeoHookean> {
  using Type = ElasticNeoHookean<W>;
};

/// compiled_in: also kernels of its own, which avoid a call and a trip through memory per tile.
template <int W, template <class> class Law, bool compiled_in>
constexpr LawTable law_kernels() {
  LawTable k;
  k.name = Law<Pack<W>>::name;
  k.parameter_count = Law<Pack<W>>::parameter_count;
  k.elastic = stress_function<W, Elastic<W, Law>>;
  k.viscous = stress_function<W, Viscous<W, Law>>;
  k.energy = energy_function<W, Law>;
  if constexpr (compiled_in) {
    using Stress = typename CompiledIn<W, Law>::Type;
    k.forces[0] = tetrahedron_forces<W, Stress, false>;
    k.forces[1] = tetrahedron_forces<W, Stress, true>;
    k.forces[2] = k.forces[3] = hexahedron_forces<W, Stress, H8>;
    k.forces[5] = hexahedron_forces<W, Stress, H8Parallelepiped>;
    k.viscous_forces[0] = tetrahedron_forces<W, Viscous<W, Law>, false>;
  }
  return k;
}

}  // namespace glisson::patches
