// How kernels get the stress of a law: compiled in, or through a pointer that keeps the number of kernels small.
#pragma once

#include <glisson/core/materials/law.hpp>
#include <glisson/cpu/simd/math.hpp>
#include <glisson/cpu/solids/patch.hpp>

namespace glisson::detail {

template <int W, template <class> class Law>
GLISSON_INLINE Law<Pack<W>> load_law(const float* parameters) {
  Pack<W> p[Law<Pack<W>>::parameter_count];
  for (int k = 0; k < Law<Pack<W>>::parameter_count; ++k) p[k] = Pack<W>::load(parameters + k * W);
  return Law<Pack<W>>::load(p);
}

/// S <- S - sum of Y, Y <- a S_e + b Y: Prony terms by backward Euler (Taylor, Comas et al. 2009).
template <int W>
GLISSON_INLINE void relax(Sym3<Pack<W>>& S, const Sym3<Pack<W>>& elastic, const MaterialTile& tile, int first, int count) {
  for (int term = first; term < first + count; ++term) {
    const Pack<W> a(tile.pass.prony[2 * term]), b(tile.pass.prony[2 * term + 1]);
    float* history = tile.history + term * 6 * W;
    auto update = [&](int component, Pack<W>& sum, Pack<W> part) __attribute__((always_inline)) {
      const Pack<W> y = a * part + b * Pack<W>::load(history + component * W);
      if (tile.pass.advance) y.store(history + component * W);
      sum = sum - y;
    };
    update(0, S.xx, elastic.xx), update(1, S.yy, elastic.yy), update(2, S.zz, elastic.zz);
    update(3, S.xy, elastic.xy), update(4, S.yz, elastic.yz), update(5, S.xz, elastic.xz);
  }
}

/// P = F S = S + H S
template <int W>
GLISSON_INLINE Mat3<Pack<W>> first_pk_of(const Mat3<Pack<W>>& H, const Sym3<Pack<W>>& S) {
  const Pack<W> s[3][3] = {{S.xx, S.xy, S.xz}, {S.xy, S.yy, S.yz}, {S.xz, S.yz, S.zz}};
  Mat3<Pack<W>> P;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) P.m[i][k] = s[i][k] + H.m[i][0] * s[0][k] + H.m[i][1] * s[1][k] + H.m[i][2] * s[2][k];
  return P;
}

/// P is proportional to the parameters: they can be scaled by the volume, two products instead of nine.
template <template <class> class Law>
constexpr bool stress_scales_with_parameters = false;

/// A law that is compiled into the kernel. stress<true> gives V P.
template <int W, template <class> class Law>
struct Elastic {
  static constexpr bool gives_volume_times_stress = stress_scales_with_parameters<Law>;
  GLISSON_INLINE static void stress(const Mat3<Pack<W>>& H, const MaterialTile& tile, Pack<W> volume, Mat3<Pack<W>>& P) {
    Pack<W> p[Law<Pack<W>>::parameter_count];
    for (int k = 0; k < Law<Pack<W>>::parameter_count; ++k) p[k] = volume * Pack<W>::load(tile.parameters + k * W);
    P = Law<Pack<W>>::load(p).first_pk(H);
  }
  GLISSON_INLINE static void stress(const Mat3<Pack<W>>& H, const MaterialTile& tile, Mat3<Pack<W>>& P) {
    P = load_law<W, Law>(tile.parameters).first_pk(H);
  }
};

template <int W, template <class> class Law>
struct Viscous {
  static constexpr bool gives_volume_times_stress = false;
  GLISSON_INLINE static void stress(const Mat3<Pack<W>>& H, const MaterialTile& tile, Mat3<Pack<W>>& P) {
    const SplitStress<Pack<W>> part = load_law<W, Law>(tile.parameters).second_pk(H);
    Sym3<Pack<W>> S{part.isochoric.xx + part.volumetric.xx, part.isochoric.yy + part.volumetric.yy,
                    part.isochoric.zz + part.volumetric.zz, part.isochoric.xy + part.volumetric.xy,
                    part.isochoric.yz + part.volumetric.yz, part.isochoric.xz + part.volumetric.xz};
    relax<W>(S, part.isochoric, tile, 0, tile.pass.isochoric);
    relax<W>(S, part.volumetric, tile, tile.pass.isochoric, tile.pass.volumetric);
    P = first_pk_of<W>(H, S);
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

}  // namespace glisson::detail
