// Displacement gradient on a surface, its strain, and the forces that work on it.
#pragma once

#include <glisson/core/numbers/functions.hpp>
#include <glisson/shells/laws/plane.hpp>

namespace glisson::shells {

/// Where the position is linear in two differences of nodes, such as the sides of a triangle: unit tangents t
/// of the rest surface and the gradient of the differences along them, dx/ds_k = g[0][k] p + g[1][k] q.
template <class R>
struct SurfacePoint {
  Vec3<R> t[2];  ///< [-]
  R g[2][2];     ///< [1/m]
};

/// du/ds along both tangents.
template <class R>
struct SurfaceGradient {
  Vec3<R> h[2];
};

/// p, q: the differences of the displacement.
template <class R>
GLISSON_HD_INLINE SurfaceGradient<R> surface_gradient(const R (&g)[2][2], const Vec3<R>& p,
                                                      const Vec3<R>& q) {
  return {{g[0][0] * p + g[1][0] * q, g[0][1] * p + g[1][1] * q}};
}

/// c = C - I from t and du/ds: nothing nearly equal is subtracted.
template <class R>
GLISSON_HD_INLINE Plane<R> strain(const Vec3<R> (&t)[2], const SurfaceGradient<R>& g) {
  const auto& h = g.h;
  return {R(2) * dot(t[0], h[0]) + dot(h[0], h[0]), R(2) * dot(t[1], h[1]) + dot(h[1], h[1]),
          dot(t[0], h[1]) + dot(t[1], h[0]) + dot(h[0], h[1])};
}

/// What works on dx/ds_k: S_kl F_l.
template <class R>
GLISSON_HD_INLINE void first_pk(const Plane<R>& S, const Vec3<R> (&F)[2], Vec3<R> (&P)[2]) {
  P[0] = S.xx * F[0] + S.xy * F[1];
  P[1] = S.xy * F[0] + S.yy * F[1];
}
/// What works on the differences p and q.
template <class R>
GLISSON_HD_INLINE void on_differences(const R (&g)[2][2], const Vec3<R> (&P)[2], Vec3<R>& on_p,
                                      Vec3<R>& on_q) {
  on_p = g[0][0] * P[0] + g[0][1] * P[1];
  on_q = g[1][0] * P[0] + g[1][1] * P[1];
}

template <class R>
GLISSON_HD_INLINE Vec3<R> unit(const Vec3<R>& v) {
  return (R(1) / square_root(dot(v, v))) * v;
}

/// The point from the differences of the rest positions; the first axis is `along`, projected.
template <class R>
GLISSON_HD_INLINE SurfacePoint<R> surface_point(const Vec3<R>& X_p, const Vec3<R>& X_q,
                                                const Vec3<R>& along) {
  SurfacePoint<R> point{};
  const auto n = unit(cross(X_p, X_q));
  point.t[0] = unit(along - dot(along, n) * n);
  point.t[1] = cross(n, point.t[0]);
  const R a = dot(X_p, point.t[0]), b = dot(X_p, point.t[1]), c = dot(X_q, point.t[0]),
          d = dot(X_q, point.t[1]);
  const R one_over_det = R(1) / (a * d - b * c);
  point.g[0][0] = one_over_det * d, point.g[0][1] = R(0) - one_over_det * c;
  point.g[1][0] = R(0) - one_over_det * b, point.g[1][1] = one_over_det * a;
  return point;
}

}  // namespace glisson::shells
