// A few numbers that a core computes together, where every machine of its kind can: a number type for the
// geometry of contact on the host. Device code has threads for that.
#pragma once

#ifndef __CUDACC__

#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <glisson/core/numbers/functions.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

template <class R>
struct LaneTypes;
template <>
struct LaneTypes<float> {
  typedef float Vector __attribute__((vector_size(16)));
};
template <>
struct LaneTypes<double> {
  typedef double Vector __attribute__((vector_size(16)));
};

template <class R>
struct Lanes {
  static constexpr int width = 16 / int(sizeof(R));
  using Vector = typename LaneTypes<R>::Vector;
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
  friend Mask operator<=(Lanes a, Lanes b) { return a.v <= b.v; }
  friend Mask operator>=(Lanes a, Lanes b) { return a.v >= b.v; }
  friend Lanes select(Mask mask, Lanes a, Lanes b) { return mask ? a.v : b.v; }
  friend Lanes square_root(Lanes a) {
#if defined(__SSE2__)
    if constexpr (width == 4)
      return Lanes(Vector(_mm_sqrt_ps(__m128(a.v))));
    else
      return Lanes(Vector(_mm_sqrt_pd(__m128d(a.v))));
#else
    for (int l = 0; l < width; ++l) a.v[l] = glisson::square_root(a.v[l]);
    return a;
#endif
  }
};

/// x, y and z of the rows of as many nodes. Numbers that are stored one by one and read as a pack make the
/// core wait for the stores, so rows are read whole and turned.
template <class R>
Vec3<Lanes<R>> turned_rows(const Vec4<R>* const (&row)[Lanes<R>::width]) {
  using V = typename Lanes<R>::Vector;
  const auto part = [&](int l, int p) {
    V v;
    std::memcpy(&v, &row[l]->x + p * Lanes<R>::width, sizeof v);
    return v;
  };
  if constexpr (Lanes<R>::width == 4) {
    const V a = part(0, 0), b = part(1, 0), c = part(2, 0), d = part(3, 0);
    const V ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    return {__builtin_shufflevector(ab, cd, 0, 1, 4, 5), __builtin_shufflevector(ab, cd, 2, 3, 6, 7),
            __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 3, 7),
                                    __builtin_shufflevector(c, d, 2, 6, 3, 7), 0, 1, 4, 5)};
  } else {
    return {__builtin_shufflevector(part(0, 0), part(1, 0), 0, 2),
            __builtin_shufflevector(part(0, 0), part(1, 0), 1, 3),
            __builtin_shufflevector(part(0, 1), part(1, 1), 0, 2)};
  }
}

}  // namespace glisson::contact

#endif
