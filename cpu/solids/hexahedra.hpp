// Hexahedra, one per lane, with the element functions of core/elements.
#pragma once

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/h8_parallelepiped.hpp>
#include <glisson/cpu/simd/nodes.hpp>
#include <glisson/cpu/solids/stress.hpp>

namespace glisson::patches {

/// Calls visit(constants, u of the corners, tile of elements) for every tile.
template <int W, class E, class Visit>
GLISSON_INLINE void over_hexahedra(const Patch& patch, const float* rows, Visit&& visit) {
  using P = Pack<W>;
  using Constants = typename E::template Constants<P>;
  static_assert(sizeof(Constants) == E::constant_count * sizeof(P));
  const auto* constants = reinterpret_cast<const Constants*>(patch.constants);
  for (int tile = 0; tile < patch.tiles; ++tile) {
    prefetch(reinterpret_cast<const float*>(constants + tile) + prefetch_distance, sizeof(Constants));
    const std::uint16_t* corner = patch.corner + tile * 8 * W;
    Vec3<P> u[8];
    unrolled<8>([&](auto a) __attribute__((always_inline)) {
      const Vec4<P> row = load_nodes<W>(rows, corner + a * W);
      u[a] = {row.x, row.y, row.z};
    });
    visit(constants[tile], u, tile);
  }
}

template <int W, class E>
GLISSON_INLINE MaterialTile material_of_point(const Patch& patch, const Pass& pass, int tile, int point) {
  const int per_point = (pass.isochoric + pass.volumetric) * 6 * W;
  return {patch.parameters + tile * patch.parameter_stride,
          patch.history +
              static_cast<std::size_t>(tile * E::point_count + point) * static_cast<std::size_t>(per_point),
          pass};
}

template <int W, class Stress, class E>
GLISSON_FLATTEN void hexahedron_forces(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  float* rows = pass.force_rows + 16;
  over_hexahedra<W, E>(patch, pass.local_rows, [&](const auto& constants, const Vec3<P>(&u)[8], int tile) {
    auto stress = [&](const Mat3<P>& H, int point) {
      Mat3<P> result;
      Stress::stress(H, material_of_point<W, E>(patch, pass, tile, point), result);
      return result;
    };
    Vec3<P> f[8];
    E::forces(constants, u, stress, f);
    for (int a = 0; a < 8; ++a) store_nodes<W>(rows + (tile * 8 + a) * 4 * W, f[a]);
  });
}

template <int W, class E>
double hexahedron_energy(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  double total = 0;
  over_hexahedra<W, E>(patch, pass.local_rows, [&](const auto& constants, const Vec3<P>(&u)[8], int tile) {
    const MaterialTile material{patch.parameters + tile * patch.parameter_stride, nullptr, pass};
    E::points(constants, u, [&](const Mat3<P>& H, P weight, int) {
      // In empty lanes the mean dilatation of H8Full is 0 / 0.
      total += sum_of_lanes<W>(select(weight > P(0), energy_of_any_law<W>(H, material) * weight, P(0)));
    });
  });
  return total;
}

template <int W, class E>
double hexahedron_hourglass_energy(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  double total = 0;
  over_hexahedra<W, E>(patch, pass.local_rows, [&](const auto& constants, const Vec3<P>(&u)[8], int) {
    total += sum_of_lanes<W>(E::hourglass_energy(constants, u));
  });
  return total;
}

}  // namespace glisson::patches
