// Constant-strain triangle without bending stiffness.
#pragma once

#include <glisson/shells/elements/surface_gradient.hpp>

namespace glisson::shells {

/// Bonet et al. 2000, in total Lagrangian form with an orthonormal frame on the rest triangle.
struct Membrane {
  static constexpr int node_count = 3;

  template <class R>
  struct Constants {
    SurfacePoint<R> point;  ///< differences: nodes 1 and 2 less node 0
    R volume;               ///< at rest, area times thickness [m^3]
  };

  template <class R>
  GLISSON_HD_INLINE static Plane<R> plane_strain(const Constants<R>& c, const Vec3<R> (&u)[3]) {
    return strain(c.point.t, surface_gradient(c.point.g, u[1] - u[0], u[2] - u[0]));
  }
  /// f <- forces on the nodes of given stress S [Pa] where the gradient is g.
  template <class R>
  GLISSON_HD_INLINE static void forces_of(const Constants<R>& c, const SurfaceGradient<R>& g,
                                          const Plane<R>& S, Vec3<R> (&f)[3]) {
    const Vec3<R> F[2] = {c.point.t[0] + g.h[0], c.point.t[1] + g.h[1]};
    const R V = R(0) - c.volume;
    Vec3<R> P[2];
    first_pk(Plane<R>{V * S.xx, V * S.yy, V * S.xy}, F, P);
    on_differences(c.point.g, P, f[1], f[2]);
    f[0] = Vec3<R>{} - f[1] - f[2];
  }
  /// f <- forces on the nodes; stress(c) gives S.
  template <class R, class Stress>
  GLISSON_HD_INLINE static void forces(const Constants<R>& c, const Vec3<R> (&u)[3], const Stress& stress,
                                       Vec3<R> (&f)[3]) {
    const SurfaceGradient<R> g = surface_gradient(c.point.g, u[1] - u[0], u[2] - u[0]);
    forces_of(c, g, stress(strain(c.point.t, g)), f);
  }
  template <class R>
  GLISSON_HD_INLINE static R bending_energy(const Constants<R>&, const Vec3<R> (&)[3]) {
    return R(0);
  }

  /// along: direction of the first axis, not normal to the triangle. X from any origin near by.
  template <class R>
  GLISSON_HD_INLINE static Constants<R> make(const Vec3<R> (&X)[3], const Vec3<R>& along,
                                             const R& thickness) {
    const auto a = X[1] - X[0], b = X[2] - X[0], N = cross(a, b);
    return {surface_point(a, b, along), R(0.5) * square_root(dot(N, N)) * thickness};
  }
};

}  // namespace glisson::shells
