// Polynomial solid of second order in both invariants; with c20 = c02 = c11 = 0 it is the Mooney-Rivlin
// solid.
#pragma once

#include <glisson/core/materials/isochoric.hpp>

namespace glisson {

/// W = c10 i1 + c01 i2 + c20 i1^2 + c02 i2^2 + c11 i1 i2 + kappa/2 (J - 1)^2, i1 = I1b - 3, i2 = I2b - 3:
/// Rivlin & Saunders 1951, with the isochoric invariants of Cb = J^(-2/3) C. Valid for J > 0; stable at rest
/// if c10 + c01 > 0.
template <class R>
struct Polynomial {
  static constexpr const char* name = "PY";
  static constexpr int parameter_count = 6;
  R c10, c01, c20, c02, c11;  ///< coefficients [Pa]
  R kappa;                    ///< bulk modulus [Pa]

  GLISSON_HD static Polynomial load(const R* p) { return {p[0], p[1], p[2], p[3], p[4], p[5]}; }
  GLISSON_HD R shear_modulus() const { return R(2) * (c10 + c01); }
  GLISSON_HD R bulk_modulus() const { return kappa; }
  GLISSON_HD R wave_modulus() const { return kappa + R(4.0 / 3) * shear_modulus(); }

  GLISSON_HD Mat3<R> first_pk(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    return first_pk_from_mandel(k, mandel(k), R(kappa * k.J_minus_1));
  }
  GLISSON_HD SplitStress<R> second_pk(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    return second_pk_from_mandel(k, mandel(k), R(kappa * k.J_minus_1));
  }
  GLISSON_HD R energy(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    const Distortion<R> c = distortion(k);
    const R i1 = I1b_minus_3(c), i2 = I2b_minus_3(c);
    return i1 * (c10 + c20 * i1 + c11 * i2) + i2 * (c01 + c02 * i2) +
           R(0.5) * kappa * k.J_minus_1 * k.J_minus_1;
  }

 private:
  /// M = 2 w1 J^(-2/3) dev e + 2 w2 J^(-4/3) dev((1 + tr e) e - e e), w = dW/dI1b, dW/dI2b.
  GLISSON_HD Sym3<R> mandel(const Kinematics<R>& k) const {
    const Distortion<R> c = distortion(k);
    const R i1 = I1b_minus_3(c), i2 = I2b_minus_3(c), y2 = k.y * k.y;
    const R w1 = c10 + R(2) * c20 * i1 + c11 * i2, w2 = c01 + R(2) * c02 * i2 + c11 * i1;
    const Sym3<R> second = (R(1) + trace(k.e)) * k.e - commuting_product(k.e, k.e);
    return (R(2) * w1 * y2) * deviator(k.e) + (R(2) * w2 * y2 * y2) * deviator(second);
  }
};

}  // namespace glisson
