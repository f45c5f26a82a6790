// Constant-strain triangle without bending stiffness.
#pragma once

#include <glisson/shells/elements/surface_gradient.hpp>

namespace glisson::shells {

/// Bonet et al. 2000, in total Lagrangian form with an orthonormal frame on the rest triangle.
struct Membrane {
  static constexpr int node_count = 3;

  template <class R>
  struct Constants {
    SurfacePoint<R, 3> point;
    R volume;  ///< at rest, area times thickness [m^3]
  };

  template <class R>
  GLISSON_HD static Plane<R> plane_strain(const Constants<R>& c, const Vec3<R> (&u)[3]) {
    return strain(c.point.t, surface_gradient(c.point, u));
  }
  /// f <- forces on the nodes; stress(c) gives S.
  template <class R, class Stress>
  GLISSON_HD static void forces(const Constants<R>& c, const Vec3<R> (&u)[3], const Stress& stress,
                                Vec3<R> (&f)[3]) {
    const SurfaceGradient<R> g = surface_gradient(c.point, u);
    const Plane<R> S = stress(strain(c.point.t, g));
    for (int a = 0; a < 3; ++a) f[a] = {};
    subtract_stress(c.point, g, S, c.volume, f);
  }
  template <class R>
  GLISSON_HD static R bending_energy(const Constants<R>&, const Vec3<R> (&)[3]) {
    return R(0);
  }

  /// along: direction of the first axis, not normal to the triangle.
  static Constants<double> make(const Vec3<double> (&X)[3], const Vec3<double>& along, double thickness) {
    constexpr double dN[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    const auto a = X[1] - X[0], b = X[2] - X[0], N = cross(a, b);
    return {surface_point<3>(a, b, dN, along), 0.5 * ::sqrt(dot(N, N)) * thickness};
  }
};

}  // namespace glisson::shells
