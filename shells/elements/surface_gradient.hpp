// Displacement gradient on a surface, its strain, and the nodal forces that work on it.
#pragma once

#include <glisson/core/numbers/functions.hpp>
#include <glisson/shells/laws/plane.hpp>

namespace glisson::shells {

/// Unit tangents t of the rest surface and the rest gradients of N shape functions along them.
template <class R, int N>
struct SurfacePoint {
  Vec3<R> t[2];  ///< [-]
  R dN[N][2];    ///< [1/m]
};

/// du/ds along both tangents.
template <class R>
struct SurfaceGradient {
  Vec3<R> h[2];
};

template <class R, int N>
GLISSON_HD SurfaceGradient<R> surface_gradient(const SurfacePoint<R, N>& p, const Vec3<R> (&u)[N]) {
  SurfaceGradient<R> g;
  for (int k = 0; k < 2; ++k)
    for (int a = 1; a < N; ++a) g.h[k] = g.h[k] + p.dN[a][k] * (u[a] - u[0]);
  return g;
}

/// c = C - I from t and du/ds: nothing nearly equal is subtracted.
template <class R>
GLISSON_HD Plane<R> strain(const Vec3<R> (&t)[2], const SurfaceGradient<R>& g) {
  const auto& h = g.h;
  return {R(2) * dot(t[0], h[0]) + dot(h[0], h[0]), R(2) * dot(t[1], h[1]) + dot(h[1], h[1]),
          dot(t[0], h[1]) + dot(t[1], h[0]) + dot(h[0], h[1])};
}

/// f_a -= weight S_kl F_k dN_a,l, F = t + h.
template <class R, int N>
GLISSON_HD void subtract_stress(const SurfacePoint<R, N>& p, const SurfaceGradient<R>& g, const Plane<R>& S,
                                const R& weight, Vec3<R> (&f)[N]) {
  const Vec3<R> F0 = p.t[0] + g.h[0], F1 = p.t[1] + g.h[1];
  const Vec3<R> P0 = (weight * S.xx) * F0 + (weight * S.xy) * F1;
  const Vec3<R> P1 = (weight * S.xy) * F0 + (weight * S.yy) * F1;
  for (int a = 0; a < N; ++a) f[a] = f[a] - (p.dN[a][0] * P0 + p.dN[a][1] * P1);
}

inline Vec3<double> unit(const Vec3<double>& v) { return (1 / ::sqrt(dot(v, v))) * v; }

/// The point from the rest tangents along two parameters and the shape functions' derivatives by them; the
/// first axis is `along`, projected.
template <int N>
SurfacePoint<double, N> surface_point(const Vec3<double>& X_xi, const Vec3<double>& X_eta,
                                      const double (&dN)[N][2], const Vec3<double>& along) {
  SurfacePoint<double, N> p{};
  const auto n = unit(cross(X_xi, X_eta));
  p.t[0] = unit(along - dot(along, n) * n);
  p.t[1] = cross(n, p.t[0]);
  const double a = dot(X_xi, p.t[0]), b = dot(X_xi, p.t[1]), c = dot(X_eta, p.t[0]), d = dot(X_eta, p.t[1]);
  const double det = a * d - b * c;
  for (int k = 0; k < N; ++k) {
    p.dN[k][0] = (d * dN[k][0] - b * dN[k][1]) / det;
    p.dN[k][1] = (a * dN[k][1] - c * dN[k][0]) / det;
  }
  return p;
}

}  // namespace glisson::shells
