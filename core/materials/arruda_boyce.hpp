// Arruda-Boyce solid: chains of limited extensibility, so that the tissue stiffens as its stretch nears
// lambda_m.
#pragma once

#include <glisson/core/materials/isochoric.hpp>
#include <glisson/core/numbers/remainders.hpp>

namespace glisson {

/// W = mu sum_{i=1..5} c_i / lambda_m^(2i-2) (I1b^i - 3^i) + kappa/2 ((J^2 - 1)/2 - ln J): Arruda & Boyce
/// 1993, the first five terms of the inverse Langevin function. Valid for J > 0 and I1b well below 3
/// lambda_m^2.
template <class R>
struct ArrudaBoyce {
  static constexpr const char* name = "AB";
  static constexpr int parameter_count = 3;
  R mu;        ///< factor of the energy [Pa]; the shear modulus at rest is larger, see shear_modulus()
  R lambda_m;  ///< stretch at which the chains lock [-]
  R kappa;     ///< bulk modulus at rest [Pa]

  GLISSON_HD static ArrudaBoyce load(const R* p) { return {p[0], p[1], p[2]}; }
  GLISSON_HD R shear_modulus() const { return R(2) * dW_dI1b(R(3)); }
  GLISSON_HD R bulk_modulus() const { return kappa; }
  GLISSON_HD R wave_modulus() const { return kappa + R(4.0 / 3) * shear_modulus(); }

  GLISSON_HD Mat3<R> first_pk(const Mat3<R>& H) const {
    Mat3<R> D;
    R j;
    volume_terms(H, D, j);
    const R y = rcbrt(j + R(1));
    return first_pk_of_I1(H, D, j, y, mandel_factor(twice_green_lagrange(H), y), pressure(j, y));
  }

  GLISSON_HD SplitStress<R> second_pk(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    return second_pk_from_mandel(k, mandel_factor(k.e, k.y) * deviator(k.e), pressure(k.J_minus_1, k.y));
  }

  /// I1b^i - 3^i = (I1b - 3) q_i with q_1 = 1, q_(i+1) = I1b q_i + 3^i.
  GLISSON_HD R energy(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    const R j = k.J_minus_1, d = I1b_minus_3(distortion(k)), I = d + R(3), x = R(1) / (lambda_m * lambda_m);
    const R q2 = I + R(3), q3 = I * q2 + R(9), q4 = I * q3 + R(27), q5 = I * q4 + R(81);
    const R sum = R(c1) + x * (R(c2) * q2 + x * (R(c3) * q3 + x * (R(c4) * q4 + x * (R(c5) * q5))));
    return mu * d * sum + R(0.5) * kappa * (R(0.5) * j * j + linear_minus_log(j));
  }

 private:
  static constexpr auto c1 = 1.0 / 2, c2 = 1.0 / 20, c3 = 11.0 / 1050, c4 = 19.0 / 7000, c5 = 519.0 / 673750;

  GLISSON_HD R dW_dI1b(const R& I) const {
    const R x = I / (lambda_m * lambda_m);
    return mu * (R(c1) + x * (R(2 * c2) + x * (R(3 * c3) + x * (R(4 * c4) + x * R(5 * c5)))));
  }
  /// 2 J^(-2/3) dW/dI1b
  GLISSON_HD R mandel_factor(const Sym3<R>& e, const R& y) const {
    const R y2 = y * y;
    return R(2) * y2 * dW_dI1b(R(y2 * (R(3) + trace(e))));
  }
  /// U'(J) = kappa/2 (J - 1/J)
  GLISSON_HD R pressure(const R& j, const R& y) const {
    return R(0.5) * kappa * j * (j + R(2)) * (y * y * y);
  }
};

}  // namespace glisson
