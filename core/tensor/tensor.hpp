// Plain tensors over a number type R (float, double, a SIMD pack, a dual number). No branch on R anywhere.
#pragma once

#include <glisson/core/base/host_device.hpp>

namespace glisson {

template <class R>
struct Vec3 {
  R x{}, y{}, z{};
};

/// Node data: one aligned 16-byte load in float. w carries a scalar that belongs to the node or is 0.
template <class R>
struct alignas(4 * sizeof(R)) Vec4 {
  R x{}, y{}, z{}, w{};
};

/// m[i][K]: row i spatial, column K material.
template <class R>
struct Mat3 {
  R m[3][3];
};

/// Symmetric tensor in the order that files use: 11 22 33 12 23 13.
template <class R>
struct Sym3 {
  R xx{}, yy{}, zz{}, xy{}, yz{}, xz{};
};

template <class R>
GLISSON_HD Vec3<R> operator+(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class R>
GLISSON_HD Vec3<R> operator-(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R>
GLISSON_HD Vec3<R> operator*(const R& s, const Vec3<R>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
/// Lane by lane, w included.
template <class R>
GLISSON_HD Vec4<R> operator+(const Vec4<R>& a, const Vec4<R>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
template <class R>
GLISSON_HD Vec4<R> operator-(const Vec4<R>& a, const Vec4<R>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
}
template <class R>
GLISSON_HD Vec4<R> operator*(const Vec4<R>& a, const Vec4<R>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w};
}
template <class R>
GLISSON_HD Vec4<R> operator*(const R& s, const Vec4<R>& a) {
  return {s * a.x, s * a.y, s * a.z, s * a.w};
}
template <class R>
GLISSON_HD R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class R>
GLISSON_HD Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// tr H
template <class R>
GLISSON_HD R trace(const Mat3<R>& H) {
  return H.m[0][0] + H.m[1][1] + H.m[2][2];
}

/// A B
template <class R>
GLISSON_HD Mat3<R> operator*(const Mat3<R>& A, const Mat3<R>& B) {
  Mat3<R> C;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      C.m[i][k] = A.m[i][0] * B.m[0][k] + A.m[i][1] * B.m[1][k] + A.m[i][2] * B.m[2][k];
  return C;
}

/// cof(H)_iK = the signed 2x2 minor, so that det H = sum_K H_0K cof_0K and H^-T = cof(H) / det H.
template <class R>
GLISSON_HD Mat3<R> cofactor(const Mat3<R>& H) {
  Mat3<R> c;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const int a = (i + 1) % 3, b = (i + 2) % 3, p = (k + 1) % 3, q = (k + 2) % 3;
      c.m[i][k] = H.m[a][p] * H.m[b][q] - H.m[a][q] * H.m[b][p];
    }
  return c;
}

template <class R>
GLISSON_HD R determinant(const Mat3<R>& H) {
  const Mat3<R> c = cofactor(H);
  return H.m[0][0] * c.m[0][0] + H.m[0][1] * c.m[0][1] + H.m[0][2] * c.m[0][2];
}

}  // namespace glisson
