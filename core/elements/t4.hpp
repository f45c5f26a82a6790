// Linear tetrahedron: constant gradient, one point.
#pragma once

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// Johnsen 2016, eq. 4.11. Stored: the inverse rest edge matrix and the volume, 10 numbers (they beat 12
/// shape derivatives).
struct T4 {
  static constexpr int node_count = 4;
  static constexpr int point_count = 1;
  static constexpr int constant_count = 10;

  template <class R>
  struct Constants {
    R B[3][3];  ///< B[a][K] = dN_(a+1)/dX_K [1/m]; dN_0 = -(sum)
    R volume;   ///< [m^3]
  };

  /// H_iK = sum_a (u_a - u_0)_i B_aK
  template <class R>
  GLISSON_HD static Mat3<R> displacement_gradient(const Constants<R>& c, const Vec3<R> (&u)[4]) {
    Vec3<R> d[3];
    for (int a = 0; a < 3; ++a) d[a] = u[a + 1] - u[0];
    Mat3<R> H;
    for (int K = 0; K < 3; ++K) {
      H.m[0][K] = d[0].x * c.B[0][K] + d[1].x * c.B[1][K] + d[2].x * c.B[2][K];
      H.m[1][K] = d[0].y * c.B[0][K] + d[1].y * c.B[1][K] + d[2].y * c.B[2][K];
      H.m[2][K] = d[0].z * c.B[0][K] + d[1].z * c.B[1][K] + d[2].z * c.B[2][K];
    }
    return H;
  }

  /// f_a = -V P dN_a: the force of the element on its nodes.
  template <class R>
  GLISSON_HD static void nodal_forces(const Constants<R>& c, const Mat3<R>& P, Vec3<R> (&f)[4]) {
    Mat3<R> T;  // -V P
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) T.m[i][k] = R(0) - c.volume * P.m[i][k];
    forces_of(c, T, f);
  }
  /// f_a = T dN_a
  template <class R>
  GLISSON_HD static void forces_of(const Constants<R>& c, const Mat3<R>& T, Vec3<R> (&f)[4]) {
    for (int a = 0; a < 3; ++a) {
      auto row = [&](int i) { return T.m[i][0] * c.B[a][0] + T.m[i][1] * c.B[a][1] + T.m[i][2] * c.B[a][2]; };
      f[a + 1] = {row(0), row(1), row(2)};
    }
    f[0] = R(-1) * (f[1] + f[2] + f[3]);
  }

  /// f <- forces on the nodes; stress(H, point) gives P.
  template <class R, class Stress>
  GLISSON_HD static void forces(const Constants<R>& c, const Vec3<R> (&u)[4], const Stress& stress,
                                Vec3<R> (&f)[4]) {
    nodal_forces(c, stress(displacement_gradient(c, u), 0), f);
  }
  /// visit(H, weight [m^3], point) for each integration point.
  template <class R, class Visit>
  GLISSON_HD static void points(const Constants<R>& c, const Vec3<R> (&u)[4], const Visit& visit) {
    visit(displacement_gradient(c, u), c.volume, 0);
  }
  template <class R>
  GLISSON_HD static R hourglass_energy(const Constants<R>&, const Vec3<R> (&)[4]) {
    return R(0);
  }

  /// From rest positions.
  template <class R>
  GLISSON_HD static Constants<R> rest_constants(const Vec3<R> (&X)[4], R /*hourglass stiffness*/ = R(0),
                                                bool /*gradient of the centre*/ = false) {
    const Vec3<R> a = X[1] - X[0], b = X[2] - X[0], c = X[3] - X[0];
    const Vec3<R> rows[3] = {cross(b, c), cross(c, a), cross(a, b)};
    const R six_volumes = dot(rows[2], c), inverse = R(1) / six_volumes;
    Constants<R> constants;
    for (int i = 0; i < 3; ++i) {
      constants.B[i][0] = inverse * rows[i].x;
      constants.B[i][1] = inverse * rows[i].y;
      constants.B[i][2] = inverse * rows[i].z;
    }
    constants.volume = six_volumes * R(1.0 / 6);
    return constants;
  }
  static Constants<double> make(const Vec3<double> (&X)[4], double stiffness = 0) {
    return rest_constants(X, stiffness);
  }
};

}  // namespace glisson
