// What the hexahedral elements share: corner signs, the eight modes, gradients and volumes of the rest shape.
#pragma once

#include <cmath>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// Corner a of the reference cube lies at (xi, eta, zeta) = +-1 in standard brick order.
GLISSON_HD constexpr int corner_sign(int a, int axis) {
  const int x = (a == 1 || a == 2 || a == 5 || a == 6) ? 1 : -1;
  const int y = (a == 2 || a == 3 || a == 6 || a == 7) ? 1 : -1;
  return axis == 0 ? x : axis == 1 ? y : (a >= 4 ? 1 : -1);
}

/// Value at corner a of mode 0..2: xi, eta, zeta; 3..6: eta zeta, xi zeta, xi eta, xi eta zeta.
constexpr int mode_sign(int mode, int a) {
  const int x = corner_sign(a, 0), y = corner_sign(a, 1), z = corner_sign(a, 2);
  switch (mode) {
    case 0:
      return x;
    case 1:
      return y;
    case 2:
      return z;
    case 3:
      return y * z;
    case 4:
      return x * z;
    case 5:
      return x * y;
    default:
      return x * y * z;
  }
}

inline double hexahedron_mode(int mode, const double (&values)[8]) {
  double sum = 0;
  for (int a = 0; a < 8; ++a) sum += mode_sign(mode, a) * values[a];
  return sum;
}

/// Walsh-Hadamard transform of nodal vectors: d = linear modes, h = hourglass modes (eta zeta, xi zeta, xi
/// eta, xi eta zeta).
template <class R>
GLISSON_HD void hexahedron_modes(const Vec3<R> (&u)[8], Vec3<R> (&d)[3], Vec3<R> (&h)[4]) {
  const Vec3<R> s0 = u[0] + u[1], s1 = u[3] + u[2], s2 = u[4] + u[5], s3 = u[7] + u[6];
  const Vec3<R> d0 = u[1] - u[0], d1 = u[2] - u[3], d2 = u[5] - u[4], d3 = u[6] - u[7];
  const Vec3<R> ss0 = s0 + s1, ds0 = s1 - s0, sd0 = d0 + d1, dd0 = d1 - d0;
  const Vec3<R> ss1 = s2 + s3, ds1 = s3 - s2, sd1 = d2 + d3, dd1 = d3 - d2;
  d[0] = sd0 + sd1, d[1] = ds0 + ds1, d[2] = ss1 - ss0;
  h[0] = ds1 - ds0, h[1] = sd1 - sd0, h[2] = dd0 + dd1, h[3] = dd1 - dd0;
}

/// The transpose: nodal vectors from mode amplitudes (no translation).
template <class R>
GLISSON_HD void hexahedron_nodes(const Vec3<R> (&d)[3], const Vec3<R> (&h)[4], Vec3<R> (&f)[8]) {
  const Vec3<R> x0 = d[0] - h[1], x1 = d[0] + h[1], y0 = d[1] - h[0], y1 = d[1] + h[0];
  const Vec3<R> xy0 = h[2] - h[3], xy1 = h[2] + h[3];
  const Vec3<R> zero{R(0), R(0), R(0)};
  const Vec3<R> a0 = zero - d[2] - y0, a1 = y0 - d[2], b0 = x0 - xy0, b1 = x0 + xy0;
  f[0] = a0 - b0, f[1] = a0 + b0, f[2] = a1 + b1, f[3] = a1 - b1;
  const Vec3<R> c0 = d[2] - y1, c1 = d[2] + y1, e0 = x1 - xy1, e1 = x1 + xy1;
  f[4] = c0 - e0, f[5] = c0 + e0, f[6] = c1 + e1, f[7] = c1 - e1;
}

struct HexahedronGradient {
  double B[8][3];  ///< dN_a/dX_j [1/m]
  double volume;   ///< weight that belongs to it [m^3]
};

/// Derivatives of the shape functions at a point of the reference cube; volume = 8 det J.
inline HexahedronGradient gradient_at(const Vec3<double> (&X)[8], const double (&point)[3]) {
  double dN[8][3];
  for (int a = 0; a < 8; ++a)
    for (int j = 0; j < 3; ++j) {
      dN[a][j] = 0.125 * corner_sign(a, j);
      for (int k = 0; k < 3; ++k)
        if (k != j) dN[a][j] *= 1 + corner_sign(a, k) * point[k];
    }
  Mat3<double> J{};  // J_ij = dX_i / dxi_j
  for (int a = 0; a < 8; ++a)
    for (int j = 0; j < 3; ++j) {
      J.m[0][j] += X[a].x * dN[a][j];
      J.m[1][j] += X[a].y * dN[a][j];
      J.m[2][j] += X[a].z * dN[a][j];
    }
  const Mat3<double> cof = cofactor(J);
  const double det = determinant(J);
  HexahedronGradient gradient{};
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) gradient.B[a][i] += cof.m[i][j] / det * dN[a][j];
  gradient.volume = 8 * det;
  return gradient;
}

inline HexahedronGradient centre_gradient(const Vec3<double> (&X)[8]) { return gradient_at(X, {0, 0, 0}); }

/// Gauss point p of 2x2x2, each with weight 1; gradient_at(...).volume / 8 is its share of the volume.
inline void gauss_point(int p, double (&point)[3]) {
  for (int j = 0; j < 3; ++j) point[j] = corner_sign(p, j) / std::sqrt(3.0);
}

/// Exact volume and volume-averaged gradient (Flanagan & Belytschko 1981): 2x2x2 points integrate det J dN
/// exactly.
inline HexahedronGradient mean_gradient(const Vec3<double> (&X)[8]) {
  HexahedronGradient mean{};
  for (int p = 0; p < 8; ++p) {
    double point[3];
    gauss_point(p, point);
    const HexahedronGradient g = gradient_at(X, point);
    mean.volume += g.volume / 8;
    for (int a = 0; a < 8; ++a)
      for (int j = 0; j < 3; ++j) mean.B[a][j] += g.volume / 8 * g.B[a][j];
  }
  for (auto& row : mean.B)
    for (double& b : row) b /= mean.volume;
  return mean;
}

}  // namespace glisson
