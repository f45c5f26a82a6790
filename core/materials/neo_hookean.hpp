// Neo-Hookean solid, the law most used for soft tissue.
#pragma once

#include <glisson/core/materials/isochoric.hpp>

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

  GLISSON_HD Mat3<R> first_pk(const Mat3<R>& H) const {
    Mat3<R> D;
    R j;
    volume_terms(H, D, j);
    const R y = rcbrt(j + R(1));
    return first_pk_of_I1(H, D, j, y, R(mu * y * y), R(kappa * j));
  }

  /// S_iso = mu J^(-2/3) (I - tr C / 3 C^-1), S_vol = kappa J (J - 1) C^-1.
  GLISSON_HD SplitStress<R> second_pk(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    return second_pk_from_mandel(k, (mu * k.y * k.y) * deviator(k.e), R(kappa * k.J_minus_1));
  }

  GLISSON_HD R energy(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    return R(0.5) * (mu * I1b_minus_3(distortion(k)) + kappa * k.J_minus_1 * k.J_minus_1);
  }
};

}  // namespace glisson
