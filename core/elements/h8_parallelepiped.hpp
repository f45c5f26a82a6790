// The one-point hexahedron whose rest shape is a parallelepiped, as in every mesh made of voxels.
#pragma once

#include <algorithm>

#include <glisson/core/elements/h8.hpp>

namespace glisson {

/// H8 with eta = chi = 0: opposite edges are equal, so that the hourglass vectors of the rest shape vanish,
/// its gradient is constant and q_m = h_m . u. A third of the constants and two thirds of the arithmetic;
/// H8::make and H8::make_fixed agree on it.
struct H8Parallelepiped {
  static constexpr int node_count = 8;
  static constexpr int point_count = 1;
  static constexpr int constant_count = 11;

  template <class R>
  struct Constants {
    R beta[3][3];  ///< [1/m]
    R volume;      ///< [m^3]
    R hourglass;   ///< k [N/m]
  };

  /// chi below the rounding of coordinates in single precision: treating it as 0 changes no more than
  /// rounding does.
  static bool fits(const Vec3<double> (&X)[8]) {
    Vec3<double> d[3], h[4];
    hexahedron_modes(X, d, h);
    double size = 0, skew = 0;
    for (const auto& a : d) size = std::max(size, dot(a, a));
    for (const auto& a : h) skew = std::max(skew, dot(a, a));
    constexpr double tolerance = 1.2e-7;
    return skew <= tolerance * tolerance * size;
  }
  static Constants<double> make(const Vec3<double> (&X)[8], double stiffness) {
    const H8::Constants<double> general = H8::make_fixed(X, stiffness);
    Constants<double> c{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) c.beta[i][j] = general.beta[i][j];
    c.volume = general.volume;
    c.hourglass = general.hourglass;
    return c;
  }

  template <class R>
  GLISSON_HD static Mat3<R> gradient_of_modes(const Constants<R>& c, const Vec3<R> (&d)[3]) {
    Mat3<R> H;
    for (int j = 0; j < 3; ++j) {
      H.m[0][j] = d[0].x * c.beta[0][j] + d[1].x * c.beta[1][j] + d[2].x * c.beta[2][j];
      H.m[1][j] = d[0].y * c.beta[0][j] + d[1].y * c.beta[1][j] + d[2].y * c.beta[2][j];
      H.m[2][j] = d[0].z * c.beta[0][j] + d[1].z * c.beta[1][j] + d[2].z * c.beta[2][j];
    }
    return H;
  }

  template <class R, class Stress>
  GLISSON_HD static void forces(const Constants<R>& c, const Vec3<R> (&u)[8], const Stress& stress,
                                Vec3<R> (&f)[8]) {
    Vec3<R> d[3], h[4];
    hexahedron_modes(u, d, h);
    mode_forces(c, stress, d, h);
    hexahedron_nodes(d, h, f);
  }

  template <class R, class Stress>
  GLISSON_HD static void mode_forces(const Constants<R>& c, const Stress& stress, Vec3<R> (&d)[3],
                                     Vec3<R> (&h)[4]) {
    const R k = R(0) - c.hourglass;
    for (int m = 0; m < 4; ++m) h[m] = k * h[m];
    const Mat3<R> P = stress(gradient_of_modes(c, d), 0);
    const R weight = R(0) - c.volume;
    for (int i = 0; i < 3; ++i) {
      const R w[3] = {weight * c.beta[i][0], weight * c.beta[i][1], weight * c.beta[i][2]};
      auto row = [&](int r) { return P.m[r][0] * w[0] + P.m[r][1] * w[1] + P.m[r][2] * w[2]; };
      d[i] = {row(0), row(1), row(2)};
    }
  }

  template <class R, class Visit>
  GLISSON_HD static void points(const Constants<R>& c, const Vec3<R> (&u)[8], const Visit& visit) {
    Vec3<R> d[3], h[4];
    hexahedron_modes(u, d, h);
    visit(gradient_of_modes(c, d), c.volume, 0);
  }

  template <class R>
  GLISSON_HD static R hourglass_energy(const Constants<R>& c, const Vec3<R> (&u)[8]) {
    Vec3<R> d[3], h[4];
    hexahedron_modes(u, d, h);
    return R(0.5) * c.hourglass * (dot(h[0], h[0]) + dot(h[1], h[1]) + dot(h[2], h[2]) + dot(h[3], h[3]));
  }
};

}  // namespace glisson
