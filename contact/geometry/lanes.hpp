// A few numbers that a core computes together, where every machine of its kind can: a number type for the
// geometry of contact on the host. Device code has threads for that, and a plain number is one lane.
#pragma once

#include <cstring>

#if defined(__SSE2__) && !defined(__CUDACC__)
#include <immintrin.h>
#endif

#include <glisson/core/numbers/functions.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

template <class L>
constexpr int lane_count = 1;

/// The number whose lane l is get(l).
template <class L, class Get>
requires(lane_count<L> == 1) GLISSON_HD L each_lane(const Get& get) { return get(0); }
template <class R>
GLISSON_HD R lane(R a, int) {
  return a;
}
/// Lanes in memory, one after the other.
template <class L, class R>
GLISSON_HD void put_lanes(const L& a, R* to) {
  for (int l = 0; l < lane_count<L>; ++l) to[l] = lane(a, l);
}
template <class L, class R>
requires(lane_count<L> == 1) GLISSON_HD L lanes_at(const R* from) { return *from; }
/// Bit l of a mask is that of lane l.
GLISSON_HD inline unsigned bits_of(bool mask) { return mask ? 1u : 0u; }
/// x, y and z of as many rows.
template <class L, class R>
requires(lane_count<L> == 1) GLISSON_HD Vec3<L> turned_rows(const Vec4<R>* const (&row)[1]) {
  return {row[0]->x, row[0]->y, row[0]->z};
}
/// The other way round, with w = 0.
template <class R>
GLISSON_HD void put_rows(const Vec3<R>& a, Vec4<R>* to) {
  *to = {a.x, a.y, a.z, R(0)};
}

#ifndef __CUDACC__

template <class R, int W>
struct LaneTypes {
  typedef R Vector __attribute__((vector_size(W * sizeof(R))));
};

/// As many as every machine of its kind has, if W is not given.
template <class R, int W = 16 / int(sizeof(R))>
struct Lanes {
  static constexpr int width = W;
  using Vector = typename LaneTypes<R, W>::Vector;
  using Mask = decltype(Vector{} < Vector{});

  Vector v{};

  Lanes() = default;
  Lanes(Vector lanes) : v(lanes) {}
  explicit Lanes(R same) : v(same - Vector{}) {}

  friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  friend Mask operator<(Lanes a, Lanes b) { return a.v < b.v; }
  friend Mask operator>(Lanes a, Lanes b) { return a.v > b.v; }
  friend Mask operator!=(Lanes a, Lanes b) { return a.v != b.v; }
  friend Mask operator<=(Lanes a, Lanes b) { return a.v <= b.v; }
  friend Mask operator>=(Lanes a, Lanes b) { return a.v >= b.v; }
  friend Lanes select(Mask mask, Lanes a, Lanes b) { return mask ? a.v : b.v; }
  friend Lanes square_root(Lanes a) {
#if defined(__AVX__)
    if constexpr (sizeof(Vector) == 32 && sizeof(R) == 4) return Lanes(Vector(_mm256_sqrt_ps(__m256(a.v))));
#endif
#if defined(__SSE2__)
    if constexpr (sizeof(Vector) == 16 && sizeof(R) == 4) return Lanes(Vector(_mm_sqrt_ps(__m128(a.v))));
    if constexpr (sizeof(Vector) == 16 && sizeof(R) == 8) return Lanes(Vector(_mm_sqrt_pd(__m128d(a.v))));
#endif
    for (int l = 0; l < width; ++l) a.v[l] = glisson::square_root(a.v[l]);
    return a;
  }
};

template <class R, int W>
constexpr int lane_count<Lanes<R, W>> = W;

template <class L, class Get>
requires(lane_count<L> > 1) L each_lane(const Get& get) {
  L a;
  for (int l = 0; l < lane_count<L>; ++l) a.v[l] = get(l);
  return a;
}
template <class R, int W>
R lane(Lanes<R, W> a, int l) {
  return a.v[l];
}
template <class R, int W>
void put_lanes(const Lanes<R, W>& a, R* to) {
  std::memcpy(to, &a.v, sizeof a.v);
}
template <class L, class R>
requires(lane_count<L> > 1) L lanes_at(const R* from) {
  L a;
  std::memcpy(&a.v, from, sizeof a.v);
  return a;
}
template <class Mask>
requires(sizeof(Mask) >= 16) unsigned bits_of(Mask mask) {
#if defined(__AVX__)
  if constexpr (sizeof(Mask) == 32 && sizeof(mask[0]) == 4) return unsigned(_mm256_movemask_ps(__m256(mask)));
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(Mask) == 16 && sizeof(mask[0]) == 4) return unsigned(_mm_movemask_ps(__m128(mask)));
  if constexpr (sizeof(Mask) == 16 && sizeof(mask[0]) == 8) return unsigned(_mm_movemask_pd(__m128d(mask)));
#endif
  unsigned bits = 0;
  for (unsigned l = 0; l < sizeof(mask) / sizeof(mask[0]); ++l) bits |= mask[l] ? 1u << l : 0u;
  return bits;
}

/// x, y and z of rows of which part(l, p) is the part p of that of lane l.
template <class L, class Part>
requires(lane_count<L> > 1) Vec3<L> turned_parts(const Part& part) {
  if constexpr (lane_count<L> == 8) {  // two turns of four rows side by side
    const auto two = [&](int l) {
      return __builtin_shufflevector(part(l, 0), part(l + 4, 0), 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const auto low = [](auto a, auto b) { return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13); };
    const auto high = [](auto a, auto b) {
      return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    };
    const auto a = two(0), b = two(1), c = two(2), d = two(3), ab = low(a, b), cd = low(c, d);
    return {__builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(high(a, b), high(c, d), 0, 1, 8, 9, 4, 5, 12, 13)};
  } else if constexpr (lane_count<L> == 4) {
    const auto a = part(0, 0), b = part(1, 0), c = part(2, 0), d = part(3, 0);
    const auto ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    return {__builtin_shufflevector(ab, cd, 0, 1, 4, 5), __builtin_shufflevector(ab, cd, 2, 3, 6, 7),
            __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 3, 7),
                                    __builtin_shufflevector(c, d, 2, 6, 3, 7), 0, 1, 4, 5)};
  } else {
    return {__builtin_shufflevector(part(0, 0), part(1, 0), 0, 2),
            __builtin_shufflevector(part(0, 0), part(1, 0), 1, 3),
            __builtin_shufflevector(part(0, 1), part(1, 1), 0, 2)};
  }
}

/// Numbers that are stored one by one and read as a pack make the core wait for the stores, so rows are read
/// whole and turned.
template <class L, class R>
requires(lane_count<L> > 1) Vec3<L> turned_rows(const Vec4<R>* const (&row)[lane_count<L>]) {
  return turned_parts<L>([&](int l, int p) {
    typename Lanes<R>::Vector v;
    std::memcpy(&v, &row[l]->x + p * Lanes<R>::width, sizeof v);
    return v;
  });
}
/// The other way round, with w = 0.
template <class R, int W>
void put_rows(const Vec3<Lanes<R, W>>& a, Vec4<R>* to) {
  const typename Lanes<R, W>::Vector x = a.x.v, y = a.y.v, z = a.z.v, w{};
  const auto put = [&](int l, int p, const auto& v) {
    std::memcpy(&to[l].x + p * Lanes<R>::width, &v, sizeof v);
  };
  if constexpr (W == 8) {
    const auto low = [](auto u, auto v) { return __builtin_shufflevector(u, v, 0, 8, 1, 9, 4, 12, 5, 13); };
    const auto high = [](auto u, auto v) {
      return __builtin_shufflevector(u, v, 2, 10, 3, 11, 6, 14, 7, 15);
    };
    const auto four = [&](int l, auto xy, auto zw) {
      const auto one = __builtin_shufflevector(xy, zw, 0, 1, 8, 9, 4, 5, 12, 13);
      const auto next = __builtin_shufflevector(xy, zw, 2, 3, 10, 11, 6, 7, 14, 15);
      put(l, 0, __builtin_shufflevector(one, one, 0, 1, 2, 3));
      put(l + 1, 0, __builtin_shufflevector(next, next, 0, 1, 2, 3));
      put(l + 4, 0, __builtin_shufflevector(one, one, 4, 5, 6, 7));
      put(l + 5, 0, __builtin_shufflevector(next, next, 4, 5, 6, 7));
    };
    four(0, low(x, y), low(z, w));
    four(2, high(x, y), high(z, w));
  } else if constexpr (W == 4) {
    const auto two = [&](int l, auto xy, auto zw) {
      put(l, 0, __builtin_shufflevector(xy, zw, 0, 1, 4, 5));
      put(l + 1, 0, __builtin_shufflevector(xy, zw, 2, 3, 6, 7));
    };
    two(0, __builtin_shufflevector(x, y, 0, 4, 1, 5), __builtin_shufflevector(z, w, 0, 4, 1, 5));
    two(2, __builtin_shufflevector(x, y, 2, 6, 3, 7), __builtin_shufflevector(z, w, 2, 6, 3, 7));
  } else {
    put(0, 0, __builtin_shufflevector(x, y, 0, 2));
    put(0, 1, __builtin_shufflevector(z, w, 0, 2));
    put(1, 0, __builtin_shufflevector(x, y, 1, 3));
    put(1, 1, __builtin_shufflevector(z, w, 1, 3));
  }
}

/// What looks at a few facets or edges at a time has one of these for each.
template <class R>
using FacetLanes = Lanes<R>;
#else
template <class R>
using FacetLanes = R;
#endif

}  // namespace glisson::contact
