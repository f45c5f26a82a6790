// W floats that are computed together: a number type for laws and elements. Only for kernel files: each
// instruction set compiles its own width, so that no function of one set can be linked into another.
#pragma once

#include <cstdint>
#include <type_traits>

#include <glisson/cpu/simd/inline.hpp>

namespace glisson {

template <int W>
struct PackTypes {
  typedef float Floats __attribute__((vector_size(4 * W), may_alias));
  typedef std::int32_t Ints __attribute__((vector_size(4 * W), may_alias));
};

/// Result of a comparison: all bits of a lane set, or none.
template <int W>
struct Mask {
  typename PackTypes<W>::Ints bits;

  friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
  friend Mask operator&&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator||(Mask a, Mask b) { return {a.bits | b.bits}; }
  friend Mask operator!(Mask a) { return {~a.bits}; }
};

template <int W>
struct Pack {
  using Floats = typename PackTypes<W>::Floats;
  using Ints = typename PackTypes<W>::Ints;
  static constexpr int width = W;

  Floats v{};

  Pack() = default;
  Pack(Floats lanes) : v(lanes) {}
  /// The same value in all lanes. Subtracting 0 changes no value, so that the compiler can drop it.
  template <class T>
  requires std::is_arithmetic_v<T>
  explicit Pack(T value) : v(static_cast<float>(value) - Floats{}) {}

  static Pack load(const float* aligned) { return *reinterpret_cast<const Floats*>(aligned); }
  void store(float* aligned) const { *reinterpret_cast<Floats*>(aligned) = v; }

  friend Pack operator+(Pack a, Pack b) { return a.v + b.v; }
  friend Pack operator-(Pack a, Pack b) { return a.v - b.v; }
  friend Pack operator*(Pack a, Pack b) { return a.v * b.v; }
  friend Pack operator/(Pack a, Pack b) { return a.v / b.v; }
  friend Pack operator-(Pack a) { return -a.v; }
  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }
  Pack& operator*=(Pack b) { return *this = *this * b; }

  friend Mask<W> operator<(Pack a, Pack b) { return {a.v < b.v}; }
  friend Mask<W> operator>(Pack a, Pack b) { return {a.v > b.v}; }
  friend Mask<W> operator<=(Pack a, Pack b) { return {a.v <= b.v}; }
  friend Mask<W> operator>=(Pack a, Pack b) { return {a.v >= b.v}; }
  friend Mask<W> operator==(Pack a, Pack b) { return {a.v == b.v}; }
  friend Mask<W> operator!=(Pack a, Pack b) { return {a.v != b.v}; }
};

template <int W>
GLISSON_INLINE Pack<W> select(Mask<W> condition, Pack<W> a, Pack<W> b) {
  return condition.bits ? a.v : b.v;
}

}  // namespace glisson
