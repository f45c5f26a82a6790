// Strips of tetrahedra, one strip per lane.
#pragma once

#include <glisson/core/elements/t4.hpp>
#include <glisson/core/materials/kinematics.hpp>
#include <glisson/cpu/simd/nodes.hpp>
#include <glisson/cpu/solids/stress.hpp>

namespace glisson::patches {

/// Constants of T4 in memory: B row by row, volume; T4ANP adds 1 / bulk modulus.
template <bool averaged>
constexpr int tetrahedron_constants = T4::constant_count + (averaged ? 1 : 0);

template <int W>
GLISSON_INLINE T4::Constants<Pack<W>> load_tetrahedron(const float* constants) {
  T4::Constants<Pack<W>> c;
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k < 3; ++k) c.B[a][k] = Pack<W>::load(constants + (3 * a + k) * W);
  c.volume = Pack<W>::load(constants + 9 * W);
  return c;
}

/// Calls element(j, place, constants, H, sum of w of its nodes) for the tetrahedra j of strip tile `tile`,
/// which may then add to corners j .. j + 3; a corner is finished by done(corner) when no later tetrahedron
/// touches it.
template <int W, bool averaged, class Element, class Done>
GLISSON_INLINE void along_strip(const Patch& patch, const float* rows, int tile, Element&& element,
                                Done&& done) {
  using P = Pack<W>;
  constexpr int count = tetrahedron_constants<averaged>;
  const std::uint16_t* corner = patch.corner + tile * strip_corners * W;
  const float* constants = patch.constants + static_cast<std::size_t>(tile) * strip_length * count * W;
  prefetch(constants + prefetch_distance, strip_length * count * W * 4);
  Vec4<P> u[strip_corners];
  unrolled<3>([&](auto a) __attribute__((always_inline)) { u[a] = load_nodes<W>(rows, corner + a * W); });
  unrolled<strip_length>([&](auto j) __attribute__((always_inline)) {
    u[j + 3] = load_nodes<W>(rows, corner + (j + 3) * W);
    const float* place = constants + j * count * W;
    const T4::Constants<P> c = load_tetrahedron<W>(place);
    Vec3<P> nodes[4];
    for (int a = 0; a < 4; ++a) nodes[a] = {u[j + a].x, u[j + a].y, u[j + a].z};
    const Mat3<P> H = T4::displacement_gradient(c, nodes);
    element(j, place, c, H, u[j].w + u[j + 1].w + u[j + 2].w + u[j + 3].w);
    done(j);
  });
  unrolled<3>([&](auto a)
                  __attribute__((always_inline)) { done(std::integral_constant<int, strip_length + a>()); });
}

/// H of F scaled to the volume of the averaged pressure: F <- s F, s^3 = J_mean / J, without cancellation at
/// small strain and with one division. Joldes et al. 2009: J_mean - 1 = mean pressure / bulk modulus.
template <int W>
GLISSON_INLINE Mat3<Pack<W>> scaled_to_volume(const Mat3<Pack<W>>& H, Pack<W> mean_J_minus_1) {
  using P = Pack<W>;
  Mat3<P> D;
  P J_minus_1;
  volume_terms(H, D, J_minus_1);
  const P one(1), y = rcbrt(J_minus_1 + one), mean_J = mean_J_minus_1 + one, z = rcbrt(mean_J);
  const P s = y * (mean_J * z * z), r = (mean_J_minus_1 - J_minus_1) * (y * y * y);  // r = s^3 - 1
  const P s_minus_1 = r / (s * s + s + one);
  Mat3<P> scaled;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) scaled.m[i][k] = s * H.m[i][k];
  for (int i = 0; i < 3; ++i) scaled.m[i][i] = scaled.m[i][i] + s_minus_1;
  return scaled;
}

/// The sum of `pressure` (a quarter at each corner) over the bulk modulus, of which the inverse is stored; 0
/// in empty lanes.
template <int W>
GLISSON_INLINE Pack<W> mean_volume_change(const float* constants, Pack<W> pressure) {
  return pressure * Pack<W>::load(constants + 10 * W);
}

/// V P of T4ANP for the law, in closed form where there is one: Stress::averaged.
template <int W, class Stress>
GLISSON_INLINE Mat3<Pack<W>> weighted_stress_averaged(const Mat3<Pack<W>>& H, const MaterialTile& material,
                                                      Pack<W> volume, Pack<W> mean_J_minus_1,
                                                      Pack<W> pressure) {
  Mat3<Pack<W>> result;
  if constexpr (requires { Stress::averaged(H, material, volume, mean_J_minus_1, pressure); }) {
    result = Stress::averaged(H, material, volume, mean_J_minus_1, pressure);
  } else {
    Stress::stress(scaled_to_volume<W>(H, mean_J_minus_1), material, result);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) result.m[i][k] = volume * result.m[i][k];
  }
  return result;
}

template <int W, class Stress, bool averaged>
GLISSON_FLATTEN void tetrahedron_forces(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  const int history_stride = (pass.isochoric + pass.volumetric) * 6 * W;
  for (int tile = 0; tile < patch.tiles; ++tile) {
    Vec3<P> f[strip_corners];
    auto element = [&](auto j, const float* constants, const T4::Constants<P>& c, const Mat3<P>& H,
                       P pressure) __attribute__((always_inline)) {
      const int place = tile * strip_length + j;
      const MaterialTile material{patch.parameters + place * patch.parameter_stride,
                                  patch.history + place * history_stride, pass};
      Mat3<P> stress;
      T4::Constants<P> weighted = c;
      if constexpr (averaged) {
        stress = weighted_stress_averaged<W, Stress>(H, material, c.volume,
                                                     mean_volume_change<W>(constants, pressure), pressure);
        weighted.volume = P(1);
      } else if constexpr (Stress::gives_volume_times_stress) {
        Stress::stress(H, material, c.volume, stress);
        weighted.volume = P(1);
      } else {
        Stress::stress(H, material, stress);
      }
      Vec3<P> g[4];
      T4::nodal_forces(weighted, stress, g);
      for (int a = 0; a < 4; ++a) f[j + a] = f[j + a] + g[a];
    };
    float* rows = pass.force_rows + 16 + tile * strip_corners * 4 * W;
    along_strip<W, averaged>(
        patch, pass.local_rows, tile, element, [&](auto corner) __attribute__((always_inline)) {
          store_nodes<W>(rows + corner * 4 * W, f[corner]);
        });
  }
}

/// First sweep of T4ANP: kappa (J - 1) V at the corners.
template <int W>
GLISSON_FLATTEN void tetrahedron_pressures(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  for (int tile = 0; tile < patch.tiles; ++tile) {
    P sum[strip_corners];
    auto element = [&](auto j, const float* constants, const T4::Constants<P>& c, const Mat3<P>& H, P)
        __attribute__((always_inline)) {
      Mat3<P> D;
      P J_minus_1;
      volume_terms(H, D, J_minus_1);
      const P inverse_kappa = P::load(constants + 10 * W);
      const P part = J_minus_1 * c.volume / select(inverse_kappa > P(0), inverse_kappa, P(1));
      for (int a = 0; a < 4; ++a) sum[j + a] = sum[j + a] + part;
    };
    float* values = pass.force_rows + 16 + tile * strip_corners * W;
    along_strip<W, true>(
        patch, pass.local_rows, tile, element, [&](auto corner) __attribute__((always_inline)) {
          store_scalars<W>(values + corner * W, sum[corner]);
        });
  }
}

template <int W, bool averaged>
double tetrahedron_energy(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  double total = 0;
  for (int tile = 0; tile < patch.tiles; ++tile) {
    auto element = [&](auto j, const float* constants, const T4::Constants<P>& c, Mat3<P> H, P pressure)
        __attribute__((always_inline)) {
      P volumetric(0);
      if constexpr (averaged) {  // see AveragedEnergy of core/kernels/averaged_pressure.hpp
        const P mean = mean_volume_change<W>(constants, pressure);
        Mat3<P> D;
        P J_minus_1;
        volume_terms(H, D, J_minus_1);
        volumetric = P(0.5) * pressure * (J_minus_1 - mean);
        H = scaled_to_volume<W>(H, mean);
      }
      const int place = (tile * strip_length + j) * patch.parameter_stride;
      const MaterialTile material{patch.parameters + place, nullptr, pass};
      total += sum_of_lanes<W>((energy_of_any_law<W>(H, material) + volumetric) * c.volume);
    };
    along_strip<W, averaged>(patch, pass.local_rows, tile, element, [](auto) {});
  }
  return total;
}

}  // namespace glisson::patches
