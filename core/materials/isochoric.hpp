// What laws with a split energy W = W_iso(Cb) + U(J), Cb = J^(-2/3) C, share: stresses and invariants without
// cancellation. The stress is carried as Mandel stress M = C S = F^T P, which is small where the strain is
// small.
#pragma once

#include <glisson/core/materials/kinematics.hpp>
#include <glisson/core/materials/law.hpp>
#include <glisson/core/tensor/symmetric.hpp>

namespace glisson {

/// C^-1 = (cof F)^T cof F / J^2 with cof F = I + D.
template <class R>
GLISSON_HD Sym3<R> inverse_of_C(const Kinematics<R>& k) {
  Mat3<R> G = k.D;
  for (int i = 0; i < 3; ++i) G.m[i][i] = G.m[i][i] + R(1);
  auto column = [&](int a, int b) {
    return G.m[0][a] * G.m[0][b] + G.m[1][a] * G.m[1][b] + G.m[2][a] * G.m[2][b];
  };
  const R y3 = k.y * k.y * k.y;
  return (y3 * y3) *
         Sym3<R>{column(0, 0), column(1, 1), column(2, 2), column(0, 1), column(1, 2), column(0, 2)};
}

/// P = F^-T M + U'(J) cof F = (I + D)(M / J + U' I), for a symmetric Mandel stress M of the isochoric part.
template <class R>
GLISSON_HD Mat3<R> first_pk_from_mandel(const Kinematics<R>& k, const Sym3<R>& M, const R& U1) {
  const Mat3<R> N = full(add_to_diagonal((k.y * k.y * k.y) * M, U1));
  Mat3<R> P = k.D * N;
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) P.m[i][c] = P.m[i][c] + N.m[i][c];
  return P;
}

/// S_iso = C^-1 M and S_vol = U'(J) J C^-1.
template <class R>
GLISSON_HD SplitStress<R> second_pk_from_mandel(const Kinematics<R>& k, const Sym3<R>& M, const R& U1) {
  const Sym3<R> C_inverse = inverse_of_C(k);
  return {commuting_product(C_inverse, M), (U1 * (k.J_minus_1 + R(1))) * C_inverse};
}

/// P = a (F - tr C / 3 F^-T) + U'(J) cof F, a = 2 J^(-2/3) dW/dI1b: for energies of I1b alone. With cof F = I
/// + D this is a (H - D) + p (I + D), p = U' - a (tr C / (3 J) - 1), where every difference is formed small.
template <class R>
GLISSON_HD Mat3<R> first_pk_of_I1(const Mat3<R>& H, const Mat3<R>& D, const R& J_minus_1, const R& y,
                                  const R& a, const R& U1) {
  R H_H = R(0);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) H_H = H_H + H.m[i][k] * H.m[i][k];
  const R I = trace(H);
  const R q = (I + I + H_H - R(3) * J_minus_1) * (y * y * y) * R(1.0 / 3);  // tr C / (3 J) - 1
  const R p = U1 - a * q, b = p - a;
  Mat3<R> P;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) P.m[i][k] = a * H.m[i][k] + b * D.m[i][k];
  for (int i = 0; i < 3; ++i) P.m[i][i] = P.m[i][i] + p;
  return P;
}

/// C up to its mean: C = m (I + x) with tr x = 0, m = tr C / 3. Then J^2 = m^3 (1 - s), s = x:x / 2 - det x,
/// and I1b = 3 / z, z = (1 - s)^(1/3): the distance of Cb from I without subtracting numbers near 1.
template <class R>
struct Distortion {
  Sym3<R> x;
  R s, z;
};

template <class R>
GLISSON_HD Distortion<R> distortion(const Kinematics<R>& k) {
  const R one_over_m = R(1) / (R(1) + trace(k.e) * R(1.0 / 3));
  const Sym3<R> x = one_over_m * deviator(k.e);
  return {x, contract(x, x) * R(0.5) - determinant(x), one_over_m / (k.y * k.y)};
}

/// 3 / z - 3 = 3 s / (z (1 + z + z^2)) for z^3 = 1 - s.
template <class R>
GLISSON_HD R three_over_z_minus_3(const R& s, const R& z) {
  return R(3) * s / (z * (R(1) + z + z * z));
}

/// tr Cb - 3 >= 0, with full relative accuracy at any strain.
template <class R>
GLISSON_HD R I1b_minus_3(const Distortion<R>& c) {
  return three_over_z_minus_3(c.s, c.z);
}

/// tr Cb^-1 - 3 >= 0: the same formula for C^-1, which is parallel to cof(I + x) = (1 - x:x/6) I - x + dev(x
/// x).
template <class R>
GLISSON_HD R I2b_minus_3(const Distortion<R>& c) {
  const R one_over_m = R(1) / (R(1) - contract(c.x, c.x) * R(1.0 / 6));
  const Sym3<R> x = one_over_m * (deviator(commuting_product(c.x, c.x)) - c.x);
  return three_over_z_minus_3(contract(x, x) * R(0.5) - determinant(x), c.z * c.z * one_over_m);
}

}  // namespace glisson
