// Neo-Hookean solid, the law most used for soft tissue.
#pragma once

#include <glisson/core/materials/kinematics.hpp>
#include <glisson/core/materials/law.hpp>

namespace glisson {

/// W = mu/2 (J^(-2/3) tr C - 3) + kappa/2 (J - 1)^2: Johnsen 2016, eq. 4.8. Valid for J > 0.
template <class R>
struct NeoHookean {
  static constexpr const char* name = "NH";
  static constexpr int parameter_count = 2;
  R mu, kappa;  ///< shear and bulk modulus at rest [Pa]

  GLISSON_HD static NeoHookean load(const R* p) { return {p[0], p[1]}; }
  GLISSON_HD R shear_modulus() const { return mu; }
  GLISSON_HD R bulk_modulus() const { return kappa; }
  GLISSON_HD R wave_modulus() const { return kappa + R(4.0 / 3) * mu; }

  /// P = a (F - tr C / 3 F^-T) + kappa (J - 1) cof F with a = mu J^(-2/3); with cof F = I + D this is
  /// a (H - D) + p (I + D), p = kappa (J - 1) - a (tr C / (3 J) - 1), where every difference is formed small.
  GLISSON_HD Mat3<R> first_pk(const Mat3<R>& H) const {
    Mat3<R> D, P;
    R j;
    volume_terms(H, D, j);
    R H_H = R(0);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) H_H = H_H + H.m[i][k] * H.m[i][k];
    const R y = rcbrt(j + R(1)), a = mu * y * y, I = trace(H);
    const R q = (I + I + H_H - R(3) * j) * (y * y * y) * R(1.0 / 3);  // tr C / (3 J) - 1
    const R p = kappa * j - a * q, b = p - a;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) P.m[i][k] = a * H.m[i][k] + b * D.m[i][k];
    for (int i = 0; i < 3; ++i) P.m[i][i] = P.m[i][i] + p;
    return P;
  }
  GLISSON_HD SplitStress<R> second_pk(const Mat3<R>& H) const;
  GLISSON_HD R energy(const Mat3<R>& H) const;
};

}  // namespace glisson
