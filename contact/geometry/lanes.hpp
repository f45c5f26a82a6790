// A few numbers that a core computes together, where every machine of its kind can: a number type for the
// geometry of contact on the host. Device code has threads for that.
#pragma once

#ifndef __CUDACC__

#include <glisson/core/numbers/functions.hpp>

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
    for (int l = 0; l < width; ++l) a.v[l] = glisson::square_root(a.v[l]);
    return a;
  }
};

}  // namespace glisson::contact

#endif
