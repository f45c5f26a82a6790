// How kernels get the stress of a law: compiled in, or through a pointer that keeps the number of kernels
// small.
#pragma once

#include <glisson/core/materials/neo_hookean.hpp>
#include <glisson/core/materials/prony.hpp>
#include <glisson/cpu/simd/math.hpp>
#include <glisson/cpu/solids/patch.hpp>

namespace glisson::patches {

template <int W, template <class> class Law>
GLISSON_INLINE Law<Pack<W>> load_law(const float* parameters) {
  Pack<W> p[Law<Pack<W>>::parameter_count];
  for (int k = 0; k < Law<Pack<W>>::parameter_count; ++k) p[k] = Pack<W>::load(parameters + k * W);
  return Law<Pack<W>>::load(p);
}

/// P is proportional to the parameters: they can be scaled by the volume, two products instead of nine.
template <template <class> class Law>
constexpr bool stress_scales_with_parameters = false;
template <>
inline constexpr bool stress_scales_with_parameters<NeoHookean> = true;

/// A law that is compiled into the kernel.
template <int W, template <class> class Law>
struct Elastic {
  static constexpr bool gives_volume_times_stress = stress_scales_with_parameters<Law>;
  GLISSON_INLINE static void stress(const Mat3<Pack<W>>& H, const MaterialTile& tile, Mat3<Pack<W>>& P) {
    P = load_law<W, Law>(tile.parameters).first_pk(H);
  }
  /// V P
  GLISSON_INLINE static void stress(const Mat3<Pack<W>>& H, const MaterialTile& tile, Pack<W> volume,
                                    Mat3<Pack<W>>& P) {
    Pack<W> p[Law<Pack<W>>::parameter_count];
    for (int k = 0; k < Law<Pack<W>>::parameter_count; ++k)
      p[k] = volume * Pack<W>::load(tile.parameters + k * W);
    P = Law<Pack<W>>::load(p).first_pk(H);
  }
};

/// The same as relaxed of core/materials/prony.hpp, component by component, so that no array of packs is left
/// in memory.
template <int W>
GLISSON_INLINE Sym3<Pack<W>> relaxed(Sym3<Pack<W>> S, const MaterialTile& tile, int first, int count) {
  const Sym3<Pack<W>> elastic = S;
  for (int term = first; term < first + count; ++term) {
    const Pack<W> alpha(tile.pass.prony[term].alpha), rate(tile.pass.prony[term].rate);
    float* history = tile.history + term * 6 * W;
    auto update = [&](int component, Pack<W>& left, Pack<W> part) __attribute__((always_inline)) {
      const Pack<W> before = Pack<W>::load(history + component * W),
                    Y = before + rate * (alpha * part - before);
      if (tile.pass.advance) Y.store(history + component * W);
      left = left - Y;
    };
    update(0, S.xx, elastic.xx), update(1, S.yy, elastic.yy), update(2, S.zz, elastic.zz);
    update(3, S.xy, elastic.xy), update(4, S.yz, elastic.yz), update(5, S.xz, elastic.xz);
  }
  return S;
}

template <int W, template <class> class Law>
struct Viscous {
  static constexpr bool gives_volume_times_stress = false;
  GLISSON_INLINE static void stress(const Mat3<Pack<W>>& H, const MaterialTile& tile, Mat3<Pack<W>>& P) {
    const Pass& pass = tile.pass;
    const SplitStress<Pack<W>> elastic = load_law<W, Law>(tile.parameters).second_pk(H);
    P = push_first(H, relaxed<W>(elastic.isochoric, tile, 0, pass.isochoric) +
                          relaxed<W>(elastic.volumetric, tile, pass.isochoric, pass.volumetric));
  }
};

/// The closed form of T4ANP: with s^3 = J_mean / J, F_mean = s F, its stress F_mean S(F_mean) is
/// mu J^(-2/3) / s (F - tr C / 3 F^-T) + pressure s^2 cof F; y = J^(-1/3), z = J_mean^(-1/3) give J^(-2/3) /
/// s = y z.
template <int W>
struct ElasticNeoHookean : Elastic<W, NeoHookean> {
  GLISSON_INLINE static Mat3<Pack<W>> averaged(const Mat3<Pack<W>>& H, const MaterialTile& tile,
                                               Pack<W> volume, Pack<W> mean_J_minus_1, Pack<W> pressure) {
    using P = Pack<W>;
    Mat3<P> D;
    P J_minus_1;
    volume_terms(H, D, J_minus_1);
    const P y = rcbrt(J_minus_1 + P(1)), mean_J = mean_J_minus_1 + P(1), z = rcbrt(mean_J),
            s = y * (mean_J * z * z);
    const P mu = P::load(tile.parameters);
    return first_pk_of_I1(H, D, J_minus_1, y, P(volume * mu * y * z), P(volume * pressure * s * s));
  }
};

template <int W>
struct AnyLaw {
  static constexpr bool gives_volume_times_stress = false;
  GLISSON_INLINE static void stress(const Mat3<Pack<W>>& H, const MaterialTile& tile, Mat3<Pack<W>>& P) {
    tile.pass.law(&H, &tile, &P);
  }
};

/// W [Pa] of Pass::law.
template <int W>
GLISSON_INLINE Pack<W> energy_of_any_law(const Mat3<Pack<W>>& H, const MaterialTile& tile) {
  Pack<W> energy;
  tile.pass.law(&H, &tile, &energy);
  return energy;
}

/// Sum over lanes in double, always in the same order.
template <int W>
GLISSON_INLINE double sum_of_lanes(Pack<W> x) {
  double sum = 0;
  for (int lane = 0; lane < W; ++lane) sum += static_cast<double>(x.v[lane]);
  return sum;
}

/// f(0), f(1), ... with constant arguments, so that arrays of packs become registers.
template <int... I, class F>
GLISSON_INLINE void unrolled(std::integer_sequence<int, I...>, F&& f) {
  (f(std::integral_constant<int, I>()), ...);
}
template <int count, class F>
GLISSON_INLINE void unrolled(F&& f) {
  unrolled(std::make_integer_sequence<int, count>(), f);
}

/// The next bytes of a stream that the hardware loses at each page: see doc/developer/cpu-backend.md.
GLISSON_INLINE void prefetch(const float* start, int bytes) {
  for (int i = 0; i < bytes; i += 64) __builtin_prefetch(reinterpret_cast<const char*>(start) + i, 0, 2);
}
constexpr int prefetch_distance = 8192 / 4;  ///< [floats]

}  // namespace glisson::patches
