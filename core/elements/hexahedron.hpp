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

/// Modes of the corners 0 .. 3 or 4 .. 7 of a hexahedron: sum, xi, eta, xi eta.
template <class R>
struct FaceModes {
  Vec3<R> sum, x, y, xy;
};

template <class R>
GLISSON_HD FaceModes<R> face_modes(const Vec3<R>* u) {
  const Vec3<R> s0 = u[0] + u[1], s1 = u[3] + u[2], d0 = u[1] - u[0], d1 = u[2] - u[3];
  return {s0 + s1, d0 + d1, s1 - s0, d1 - d0};
}

/// The transpose: nodal vectors of a face.
template <class R>
GLISSON_HD void face_nodes(const FaceModes<R>& m, Vec3<R>* f) {
  const Vec3<R> a0 = m.sum - m.y, a1 = m.sum + m.y, b0 = m.x - m.xy, b1 = m.x + m.xy;
  f[0] = a0 - b0, f[1] = a0 + b0, f[2] = a1 + b1, f[3] = a1 - b1;
}

/// Walsh-Hadamard transform of nodal vectors: d = linear modes, h = hourglass modes (eta zeta, xi zeta, xi
/// eta, xi eta zeta).
template <class R>
GLISSON_HD void hexahedron_modes(const FaceModes<R>& below, const FaceModes<R>& above, Vec3<R> (&d)[3],
                                 Vec3<R> (&h)[4]) {
  d[0] = below.x + above.x, d[1] = below.y + above.y, d[2] = above.sum - below.sum;
  h[0] = above.y - below.y, h[1] = above.x - below.x;
  h[2] = below.xy + above.xy, h[3] = above.xy - below.xy;
}
template <class R>
GLISSON_HD void hexahedron_modes(const Vec3<R> (&u)[8], Vec3<R> (&d)[3], Vec3<R> (&h)[4]) {
  hexahedron_modes(face_modes(u), face_modes(u + 4), d, h);
}

/// The transpose, without translation: what mode amplitudes mean for the faces.
template <class R>
GLISSON_HD FaceModes<R> modes_below(const Vec3<R> (&d)[3], const Vec3<R> (&h)[4]) {
  return {R(-1) * d[2], d[0] - h[1], d[1] - h[0], h[2] - h[3]};
}
template <class R>
GLISSON_HD FaceModes<R> modes_above(const Vec3<R> (&d)[3], const Vec3<R> (&h)[4]) {
  return {d[2], d[0] + h[1], d[1] + h[0], h[2] + h[3]};
}
template <class R>
GLISSON_HD void hexahedron_nodes(const Vec3<R> (&d)[3], const Vec3<R> (&h)[4], Vec3<R> (&f)[8]) {
  face_nodes(modes_below(d, h), f);
  face_nodes(modes_above(d, h), f + 4);
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
