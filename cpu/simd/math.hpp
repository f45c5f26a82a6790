// The functions of core/numbers/functions.hpp for packs, to a few units in the last place.
#pragma once

#include <limits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <glisson/cpu/simd/pack.hpp>

namespace glisson {
namespace detail {

/// The float with these bits, the bits of a float; both free.
template <int W>
GLISSON_INLINE Pack<W> as_floats(typename Pack<W>::Ints bits) {
  return reinterpret_cast<typename Pack<W>::Floats>(bits);
}
template <int W>
GLISSON_INLINE typename Pack<W>::Ints as_ints(Pack<W> x) {
  return reinterpret_cast<typename Pack<W>::Ints>(x.v);
}
template <int W>
GLISSON_INLINE Pack<W> to_floats(typename Pack<W>::Ints integers) {
  return __builtin_convertvector(integers, typename Pack<W>::Floats);
}
template <int W>
GLISSON_INLINE typename Pack<W>::Ints truncated(Pack<W> x) {
  return __builtin_convertvector(x.v, typename Pack<W>::Ints);
}
template <int W>
GLISSON_INLINE Pack<W> not_a_number() {
  return Pack<W>(std::numeric_limits<float>::quiet_NaN());
}

/// a - b modulo 2^32: signed numbers must not overflow, also where the result is thrown away.
template <int W>
GLISSON_INLINE typename Pack<W>::Ints wrapped_difference(typename Pack<W>::Ints a, unsigned b) {
  typedef unsigned Unsigned __attribute__((vector_size(4 * W)));
  return reinterpret_cast<typename Pack<W>::Ints>(reinterpret_cast<Unsigned>(a) - b);
}

/// 2^k for -126 <= k <= 127.
template <int W>
GLISSON_INLINE Pack<W> power_of_two(typename Pack<W>::Ints k) {
  return as_floats<W>((k + 127) << 23);
}

}  // namespace detail

/// x^(-1/3) for x > 0, NaN otherwise. The seed divides the exponent by -3 through the bits read as an integer
/// (error 4 %). x^(-1/3) = y (1 - r)^(-1/3) with r = 1 - x y^3: the series to r^3 leaves 2e-5, one more term
/// rounding. Kernels wait for this value, so its chain of dependent operations is kept short.
template <int W>
GLISSON_INLINE Pack<W> rcbrt(Pack<W> x) {
  const Pack<W> bits = detail::to_floats<W>(detail::as_ints(x));
  Pack<W> y = detail::as_floats<W>(detail::truncated(Pack<W>(1419853098.0f) - bits * Pack<W>(1.0 / 3)));
  Pack<W> r = Pack<W>(1) - (y * y) * (x * y);
  y = y + (y * r) * (Pack<W>(1.0 / 3) + r * (Pack<W>(2.0 / 9) + r * Pack<W>(14.0 / 81)));
  r = Pack<W>(1) - (y * y) * (x * y);
  y = y + (y * Pack<W>(1.0 / 3)) * r;
  return select(x > Pack<W>(0), y, detail::not_a_number<W>());
}

template <int W>
GLISSON_INLINE Pack<W> square_root(Pack<W> x) {
#if defined(__AVX512F__)
  if constexpr (W == 16) return _mm512_sqrt_ps(x.v);
#endif
#if defined(__AVX__)
  if constexpr (W == 8) return _mm256_sqrt_ps(x.v);
#endif
#if defined(__SSE2__)
  if constexpr (W == 4) return _mm_sqrt_ps(x.v);
#endif
  Pack<W> y;
  for (int lane = 0; lane < W; ++lane) y.v[lane] = __builtin_sqrtf(x.v[lane]);
  return y;
}

/// ln(1 + x) for x > -1, -inf at -1, NaN below. 1 + x = 2^k (1 + f) with 1 + f in [1/sqrt 2, sqrt 2); the
/// rounding error of 1 + x comes back as a correction, and f = x where k = 0. ln(1 + f) = 2 artanh(s), s = f
/// / (2 + f): its series in s^2 < 0.03.
template <int W>
GLISSON_INLINE Pack<W> log_1p(Pack<W> x) {
  using P = Pack<W>;
  const P one(1), u = one + x;
  const auto shifted = detail::wrapped_difference<W>(detail::as_ints(u), 0x3f3504f3u);  // bits of 1/sqrt 2
  const auto k = shifted >> 23;
  const P k_float = detail::to_floats<W>(k);
  const P m = detail::as_floats<W>((shifted & 0x007fffff) + 0x3f3504f3);
  const Mask<W> near_one{k == 0};
  const P f = select(near_one, x, m - one);
  const P lost = select(x > one, one - (u - x), x - (u - one));
  const P correction = select(near_one, P(0), lost / u);
  const P s = f / (P(2) + f), z = s * s, half_square = P(0.5) * f * f;
  const P series = z * (P(2.0 / 3) + z * (P(2.0 / 5) + z * (P(2.0 / 7) + z * P(2.0 / 9))));
  const P ln2_high(0.693359375), ln2_low(-2.12194440e-4);  // k ln2_high is exact
  const P value = k_float * ln2_high -
                  ((half_square - (s * (half_square + series) + (k_float * ln2_low + correction))) - f);
  const P infinity(std::numeric_limits<float>::infinity());
  const P edge = select(x == -one, -infinity, select(x == infinity, infinity, detail::not_a_number<W>()));
  return select((x > -one) & (x < infinity), value, edge);
}

/// e^x - 1. x = k ln 2 + r, |r| < 0.35: (e^r - 1) by its series, then 2^k (e^r - 1) + (2^k - 1). inf
/// above 88.73.
template <int W>
GLISSON_INLINE Pack<W> exp_m1(Pack<W> x) {
  using P = Pack<W>;
  // NaN is clamped too: k - 1 below would overflow for the integer that it becomes
  const P clamped = select(x > P(89), P(89), select(x > P(-40), x, P(-40)));
  const P scaled = clamped * P(1.44269504088896341);
  const auto k = detail::truncated(scaled + select(scaled < P(0), P(-0.5), P(0.5)));
  const P k_float = detail::to_floats<W>(k);
  const P r = (clamped - k_float * P(0.693359375)) - k_float * P(-2.12194440e-4);
  const P tail =
      P(1.0 / 2) +
      r * (P(1.0 / 6) +
           r * (P(1.0 / 24) +
                r * (P(1.0 / 120) + r * (P(1.0 / 720) + r * (P(1.0 / 5040) + r * P(1.0 / 40320))))));
  const P e = r + r * r * tail;
  const P half_power = detail::power_of_two<W>(k - 1);  // 2^128 does not fit
  const P value = (half_power * e + (half_power - P(0.5))) * P(2);
  return select(x == x, value, x);
}

}  // namespace glisson
