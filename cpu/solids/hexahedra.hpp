// Hexahedra with the element functions of core/elements: columns of them, one column per lane, or one per
// lane.
#pragma once

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/h8_parallelepiped.hpp>
#include <glisson/cpu/simd/nodes.hpp>
#include <glisson/cpu/solids/stress.hpp>

namespace glisson::patches {

/// Hexahedra that a lane holds one after the other: those that know their modes come in columns.
template <class E>
constexpr int hexahedra_per_item = column_length;
template <>
inline constexpr int hexahedra_per_item<H8Full> = 1;

template <int W, class E>
GLISSON_INLINE const auto& constants_of(const Patch& patch, int place) {
  using Constants = typename E::template Constants<Pack<W>>;
  static_assert(sizeof(Constants) == E::constant_count * sizeof(Pack<W>));
  const auto* constants = reinterpret_cast<const Constants*>(patch.constants) + place;
  prefetch(reinterpret_cast<const float*>(constants) + prefetch_distance, sizeof(Constants));
  return *constants;
}

template <int W, int count>
GLISSON_INLINE void load_corners(const float* rows, const std::uint16_t* corner, Vec3<Pack<W>>* u) {
  unrolled<count>([&](auto a) __attribute__((always_inline)) {
    const Vec4<Pack<W>> row = load_nodes<W>(rows, corner + a * W);
    u[a] = {row.x, row.y, row.z};
  });
}

/// Calls visit(constants, u of the corners, place of the tile of elements) for every tile of elements.
template <int W, class E, class Visit>
GLISSON_INLINE void over_hexahedra(const Patch& patch, const float* rows, Visit&& visit) {
  constexpr int per_item = hexahedra_per_item<E>, corners = 4 * (per_item + 1);
  for (int place = 0; place < patch.tiles * per_item; ++place) {
    const int first = place / per_item * corners + place % per_item * 4;
    Vec3<Pack<W>> u[8];
    load_corners<W, 8>(rows, patch.corner + first * W, u);
    visit(constants_of<W, E>(patch, place), u, place);
  }
}

template <int W, class E>
GLISSON_INLINE MaterialTile material_of_point(const Patch& patch, const Pass& pass, int place, int point) {
  const int per_point = (pass.isochoric + pass.volumetric) * 6 * W;
  return {patch.parameters + place * patch.parameter_stride,
          patch.history +
              static_cast<std::size_t>(place * E::point_count + point) * static_cast<std::size_t>(per_point),
          pass};
}

/// Along columns: each face is read, transformed and written once.
template <int W, class E, class StressAt>
GLISSON_INLINE void column_forces(const Patch& patch, const Pass& pass, StressAt&& stress_at) {
  using P = Pack<W>;
  for (int tile = 0; tile < patch.tiles; ++tile) {
    const std::uint16_t* corner = patch.corner + tile * column_corners * W;
    float* rows = pass.force_rows + 16 + tile * column_corners * 4 * W;
    Vec3<P> nodes[4];
    load_corners<W, 4>(pass.local_rows, corner, nodes);
    FaceModes<P> below = face_modes(nodes), force{};  // of the face between two hexahedra
    auto store = [&](int face) __attribute__((always_inline)) {
      face_nodes(force, nodes);
      for (int a = 0; a < 4; ++a) store_nodes<W>(rows + (face * 4 + a) * 4 * W, nodes[a]);
    };
    for (int j = 0; j < column_length; ++j) {
      const int place = tile * column_length + j;
      load_corners<W, 4>(pass.local_rows, corner + (j + 1) * 4 * W, nodes);
      const FaceModes<P> above = face_modes(nodes);
      Vec3<P> d[3], h[4];
      hexahedron_modes(below, above, d, h);
      E::mode_forces(constants_of<W, E>(patch, place), stress_at(place), d, h);
      const FaceModes<P> part = modes_below(d, h);
      force = {force.sum + part.sum, force.x + part.x, force.y + part.y, force.xy + part.xy};
      store(j);
      force = modes_above(d, h);
      below = above;
    }
    store(column_length);
  }
}

template <int W, class Stress, class E>
GLISSON_FLATTEN void hexahedron_forces(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  auto stress_at = [&](int place) {
    return [&patch, &pass, place](const Mat3<P>& H, int point) {
      Mat3<P> result;
      Stress::stress(H, material_of_point<W, E>(patch, pass, place, point), result);
      return result;
    };
  };
  if constexpr (hexahedra_per_item < E >> 1) {
    column_forces<W, E>(patch, pass, stress_at);
  } else {
    float* rows = pass.force_rows + 16;
    over_hexahedra<W, E>(patch, pass.local_rows, [&](const auto& constants, const Vec3<P>(&u)[8], int tile) {
      Vec3<P> f[8];
      E::forces(constants, u, stress_at(tile), f);
      for (int a = 0; a < 8; ++a) store_nodes<W>(rows + (tile * 8 + a) * 4 * W, f[a]);
    });
  }
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
