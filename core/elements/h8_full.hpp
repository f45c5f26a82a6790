// Hexahedron with 2x2x2 points and the mean dilatation, against volumetric locking.
#pragma once

#include <glisson/core/elements/hexahedron.hpp>
#include <glisson/core/materials/kinematics.hpp>

namespace glisson {

/// Every point sees Fbar = s F with s = (Jbar / J)^(1/3) and Jbar = mean of J over the element (Simo, Taylor
/// & Pister 1985, in the form of Moran, Ortiz & Shih 1990). Stress from the energy sum_p w_p W(Fbar_p), so
/// forces are its exact derivative:
///   P_p = s Pbar_p + (theta - s (Pbar:F) / (3 J))_p cof F_p,   theta = sum_q w_q s_q (Pbar:F)_q / (3 Jbar
///   V).
struct H8Full {
  static constexpr int node_count = 8;
  static constexpr int point_count = 8;
  static constexpr int constant_count = 80;

  template <class R>
  struct Constants {
    R inverse[8][3][3];  ///< dxi_j / dX_i at each point [1/m]
    R weight[8];         ///< volume of each point [m^3]
  };

  /// The seven modes of a nodal field that have derivatives.
  template <class R>
  struct Modes {
    Vec3<R> d[3], h[4];
  };

  /// Coordinate of point p along an axis of the reference cube.
  GLISSON_HD static constexpr double coordinate(int p, int axis) {
    return corner_sign(p, axis) * 0.57735026918962576451;
  }

  /// du / dX at point p. In modes, 8 du/dxi = d_0 + eta h_2 + zeta h_1 + eta zeta h_3, and so on.
  template <class R>
  GLISSON_HD static Mat3<R> gradient(const Constants<R>& c, const Modes<R>& u, int p) {
    const R x = R(coordinate(p, 0)), y = R(coordinate(p, 1)), z = R(coordinate(p, 2)), eighth = R(0.125);
    const Vec3<R> local[3] = {eighth * (u.d[0] + y * u.h[2] + z * (u.h[1] + y * u.h[3])),
                              eighth * (u.d[1] + x * u.h[2] + z * (u.h[0] + x * u.h[3])),
                              eighth * (u.d[2] + x * u.h[1] + y * (u.h[0] + x * u.h[3]))};
    Mat3<R> H;
    for (int i = 0; i < 3; ++i) {
      const R *w0 = c.inverse[p][0], *w1 = c.inverse[p][1], *w2 = c.inverse[p][2];
      H.m[0][i] = local[0].x * w0[i] + local[1].x * w1[i] + local[2].x * w2[i];
      H.m[1][i] = local[0].y * w0[i] + local[1].y * w1[i] + local[2].y * w2[i];
      H.m[2][i] = local[0].z * w0[i] + local[1].z * w1[i] + local[2].z * w2[i];
    }
    return H;
  }

  /// Adds w P dN in modes: the transpose of gradient().
  template <class R>
  GLISSON_HD static void add_forces(const Constants<R>& c, const Mat3<R>& P, int p, Modes<R>& f) {
    const R x = R(coordinate(p, 0)), y = R(coordinate(p, 1)), z = R(coordinate(p, 2)),
            w = R(0.125) * c.weight[p];
    Vec3<R> local[3];
    for (int j = 0; j < 3; ++j) {
      auto row = [&](int i) {
        return w * (P.m[i][0] * c.inverse[p][j][0] + P.m[i][1] * c.inverse[p][j][1] +
                    P.m[i][2] * c.inverse[p][j][2]);
      };
      local[j] = {row(0), row(1), row(2)};
      f.d[j] = f.d[j] + local[j];
    }
    f.h[0] = f.h[0] + z * local[1] + y * local[2];
    f.h[1] = f.h[1] + z * local[0] + x * local[2];
    f.h[2] = f.h[2] + y * local[0] + x * local[1];
    f.h[3] = f.h[3] + y * z * local[0] + x * z * local[1] + x * y * local[2];
  }

  /// J_p - 1 at all points and their mean over the element.
  template <class R>
  GLISSON_HD static R dilatations(const Constants<R>& c, const Modes<R>& u, R (&J_minus_1)[8], R& volume) {
    R sum = R(0);
    volume = R(0);
    for (int p = 0; p < 8; ++p) {
      Mat3<R> D;
      volume_terms(gradient(c, u, p), D, J_minus_1[p]);
      sum = sum + c.weight[p] * J_minus_1[p];
      volume = volume + c.weight[p];
    }
    return sum / volume;
  }

  /// s - 1 = z / (1 + s + s^2), z = (Jbar - J) / J, without cancellation.
  template <class R>
  GLISSON_HD static R stretch_minus_1(R mean, R J_minus_1) {
    const R z = (mean - J_minus_1) / (J_minus_1 + R(1));
    const R s = R(1) / rcbrt(z + R(1));
    return z / (R(1) + s + s * s);
  }

  template <class R>
  GLISSON_HD static Mat3<R> averaged(const Mat3<R>& H, R t) {
    Mat3<R> A;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) A.m[i][j] = H.m[i][j] + t * H.m[i][j];
    for (int i = 0; i < 3; ++i) A.m[i][i] = A.m[i][i] + t;
    return A;
  }

  template <class R>
  GLISSON_HD static void clear(Modes<R>& f) {
    for (auto& a : f.d) a = {R(0), R(0), R(0)};
    for (auto& a : f.h) a = {R(0), R(0), R(0)};
  }

  template <class R, class Stress>
  GLISSON_HD static void forces(const Constants<R>& c, const Vec3<R> (&u)[8], const Stress& stress,
                                Vec3<R> (&f)[8]) {
    R J_minus_1[8], volume, theta = R(0);
    Modes<R> modes, own_part, g;  // g: what theta multiplies, sum_p w cof F dN
    hexahedron_modes(u, modes.d, modes.h);
    clear(own_part);
    clear(g);
    const R mean = dilatations(c, modes, J_minus_1, volume);
    for (int p = 0; p < 8; ++p) {
      const Mat3<R> H = gradient(c, modes, p);
      const R t = stretch_minus_1(mean, J_minus_1[p]), s = t + R(1);
      const Mat3<R> P = stress(averaged(H, t), p);
      R P_F = trace(P);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) P_F = P_F + P.m[i][j] * H.m[i][j];
      const R third = R(1.0 / 3) * s * P_F, pressure = third / (J_minus_1[p] + R(1));
      theta = theta + c.weight[p] * third;
      Mat3<R> D, own;
      R unused;
      volume_terms(H, D, unused);
      for (int i = 0; i < 3; ++i) D.m[i][i] = D.m[i][i] + R(1);  // cof F
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) own.m[i][j] = s * P.m[i][j] - pressure * D.m[i][j];
      add_forces(c, own, p, own_part);
      add_forces(c, D, p, g);
    }
    theta = theta / ((mean + R(1)) * volume);
    for (int i = 0; i < 3; ++i) own_part.d[i] = R(-1) * (own_part.d[i] + theta * g.d[i]);
    for (int m = 0; m < 4; ++m) own_part.h[m] = R(-1) * (own_part.h[m] + theta * g.h[m]);
    hexahedron_nodes(own_part.d, own_part.h, f);
  }

  template <class R, class Visit>
  GLISSON_HD static void points(const Constants<R>& c, const Vec3<R> (&u)[8], const Visit& visit) {
    R J_minus_1[8], volume;
    Modes<R> modes;
    hexahedron_modes(u, modes.d, modes.h);
    const R mean = dilatations(c, modes, J_minus_1, volume);
    for (int p = 0; p < 8; ++p)
      visit(averaged(gradient(c, modes, p), stretch_minus_1(mean, J_minus_1[p])), c.weight[p], p);
  }
  template <class R>
  GLISSON_HD static R hourglass_energy(const Constants<R>&, const Vec3<R> (&)[8]) {
    return R(0);
  }

  static Constants<double> make(const Vec3<double> (&X)[8], double /*hourglass stiffness*/ = 0) {
    Constants<double> c{};
    for (int p = 0; p < 8; ++p) {
      double point[3];
      gauss_point(p, point);
      Mat3<double> J{};
      for (int a = 0; a < 8; ++a)
        for (int j = 0; j < 3; ++j) {
          double dN = 0.125 * corner_sign(a, j);
          for (int k = 0; k < 3; ++k)
            if (k != j) dN *= 1 + corner_sign(a, k) * point[k];
          J.m[0][j] += X[a].x * dN;
          J.m[1][j] += X[a].y * dN;
          J.m[2][j] += X[a].z * dN;
        }
      const Mat3<double> cof = cofactor(J);
      const double det = determinant(J);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c.inverse[p][j][i] = cof.m[i][j] / det;
      c.weight[p] = det;
    }
    return c;
  }
};

}  // namespace glisson
