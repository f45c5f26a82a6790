// Algebra of symmetric tensors, as far as constitutive laws need it.
#pragma once

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

template <class R>
GLISSON_HD Sym3<R> operator+(const Sym3<R>& a, const Sym3<R>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.xz + b.xz};
}
template <class R>
GLISSON_HD Sym3<R> operator-(const Sym3<R>& a, const Sym3<R>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.xz - b.xz};
}
template <class R>
GLISSON_HD Sym3<R> operator*(const R& s, const Sym3<R>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.xz};
}

template <class R>
GLISSON_HD R trace(const Sym3<R>& a) {
  return a.xx + a.yy + a.zz;
}

/// a + s I
template <class R>
GLISSON_HD Sym3<R> add_to_diagonal(const Sym3<R>& a, const R& s) {
  return {a.xx + s, a.yy + s, a.zz + s, a.xy, a.yz, a.xz};
}

/// a - tr(a)/3 I, from differences of the diagonal, so that its trace vanishes to rounding of the deviator
/// itself.
template <class R>
GLISSON_HD Sym3<R> deviator(const Sym3<R>& a) {
  const R third = R(1.0 / 3), p = a.xx - a.yy, q = a.yy - a.zz, r = a.zz - a.xx;
  return {third * (p - r), third * (q - p), third * (r - q), a.xy, a.yz, a.xz};
}

/// a : b
template <class R>
GLISSON_HD R contract(const Sym3<R>& a, const Sym3<R>& b) {
  const R off = a.xy * b.xy + a.yz * b.yz + a.xz * b.xz;
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + (off + off);
}

template <class R>
GLISSON_HD R determinant(const Sym3<R>& a) {
  return a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.xz) +
         a.xz * (a.xy * a.yz - a.yy * a.xz);
}

/// a b of two tensors with common eigenvectors: the product is symmetric.
template <class R>
GLISSON_HD Sym3<R> commuting_product(const Sym3<R>& a, const Sym3<R>& b) {
  return {a.xx * b.xx + a.xy * b.xy + a.xz * b.xz, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
          a.xz * b.xz + a.yz * b.yz + a.zz * b.zz, a.xx * b.xy + a.xy * b.yy + a.xz * b.yz,
          a.xy * b.xz + a.yy * b.yz + a.yz * b.zz, a.xx * b.xz + a.xy * b.yz + a.xz * b.zz};
}

/// v . a v
template <class R>
GLISSON_HD R quadratic(const Sym3<R>& a, const Vec3<R>& v) {
  const R off = a.xy * (v.x * v.y) + a.yz * (v.y * v.z) + a.xz * (v.x * v.z);
  return a.xx * (v.x * v.x) + a.yy * (v.y * v.y) + a.zz * (v.z * v.z) + (off + off);
}

/// v v^T
template <class R>
GLISSON_HD Sym3<R> dyad(const Vec3<R>& v) {
  return {v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.y * v.z, v.x * v.z};
}

template <class R>
GLISSON_HD Mat3<R> full(const Sym3<R>& a) {
  return {{{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}}};
}

/// (I + H) S, small terms kept apart from S: with H = du/dX and S the second Piola-Kirchhoff stress, this is
/// P.
template <class R>
GLISSON_HD Mat3<R> push_first(const Mat3<R>& H, const Sym3<R>& S) {
  const Mat3<R> s = full(S);
  Mat3<R> P = H * s;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) P.m[i][k] = P.m[i][k] + s.m[i][k];
  return P;
}

}  // namespace glisson
