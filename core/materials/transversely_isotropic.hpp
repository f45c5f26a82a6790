// Neo-Hookean solid with one family of fibres.
#pragma once

#include <glisson/core/materials/isochoric.hpp>

namespace glisson {

/// W = mu/2 (I1b - 3) + eta/4 (I4b - 1)^2 + kappa/2 (J - 1)^2, I4b = J^(-2/3) a.C a: after Weiss, Maker &
/// Govindjee 1996, with the quadratic fibre term. Fibres act in compression as in tension. Valid for J > 0; a
/// = 0 gives NaN.
template <class R>
struct TransverselyIsotropic {
  static constexpr const char* name = "TI";
  static constexpr int parameter_count = 6;
  R mu, kappa;  ///< shear and bulk modulus of the ground substance at rest [Pa]
  R eta;        ///< stiffness of the fibres [Pa]
  Vec3<R> a;    ///< unit vector along the fibres at rest [-]

  /// The direction p[3..5] may have any length but 0.
  GLISSON_HD static TransverselyIsotropic load(const R* p) {
    const Vec3<R> direction{p[3], p[4], p[5]};
    return {p[0], p[1], p[2], R(R(1) / square_root(dot(direction, direction))) * direction};
  }
  GLISSON_HD R shear_modulus() const { return mu; }
  GLISSON_HD R bulk_modulus() const { return kappa; }
  /// At rest the fibres add eta (A : dev strain)^2 to the energy. A wave along n with amplitude m gets 2 eta
  /// (m.dev(A) n)^2 from it, at most 2 eta (2/3)^2, reached for m = n = a, where the ground substance reaches
  /// its maximum too.
  GLISSON_HD R wave_modulus() const { return kappa + R(4.0 / 3) * mu + R(8.0 / 9) * eta; }

  /// Fibres: P = w (F a a^T - I4/3 F^-T), w = eta J^(-2/3) (I4b - 1), I4 = a.C a; the second term joins the
  /// pressure.
  GLISSON_HD Mat3<R> first_pk(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    R I4;
    const R w = fibre_factor(k, I4);
    const R U1 = kappa * k.J_minus_1 - w * I4 * (k.y * k.y * k.y) * R(1.0 / 3);
    Mat3<R> P = first_pk_of_I1(H, k.D, k.J_minus_1, k.y, R(mu * k.y * k.y), U1);
    const R direction[3] = {a.x, a.y, a.z};
    for (int i = 0; i < 3; ++i) {
      const R Fa = direction[i] + (H.m[i][0] * a.x + H.m[i][1] * a.y + H.m[i][2] * a.z);
      for (int c = 0; c < 3; ++c) P.m[i][c] = P.m[i][c] + w * Fa * direction[c];
    }
    return P;
  }

  /// The fibres' S = w (a a^T - I4/3 C^-1) is isochoric.
  GLISSON_HD SplitStress<R> second_pk(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    SplitStress<R> S = second_pk_from_mandel(k, (mu * k.y * k.y) * deviator(k.e), R(kappa * k.J_minus_1));
    R I4;
    const R w = fibre_factor(k, I4);
    S.isochoric = S.isochoric + w * (dyad(a) - (I4 * R(1.0 / 3)) * inverse_of_C(k));
    return S;
  }

  GLISSON_HD R energy(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    const R i4 = I4b_minus_1(k, quadratic(k.e, a));
    return R(0.5) *
           (mu * I1b_minus_3(distortion(k)) + R(0.5) * eta * i4 * i4 + kappa * k.J_minus_1 * k.J_minus_1);
  }

 private:
  /// (y^2 - 1) + y^2 a.e a, where y - 1 = -(J - 1) y^3 / (1 + y + y^2).
  GLISSON_HD static R I4b_minus_1(const Kinematics<R>& k, const R& a_e_a) {
    const R y = k.y, y_minus_1 = -(k.J_minus_1 * (y * y * y)) / (R(1) + y + y * y);
    return y_minus_1 * (y + R(1)) + y * y * a_e_a;
  }
  GLISSON_HD R fibre_factor(const Kinematics<R>& k, R& I4) const {
    const R a_e_a = quadratic(k.e, a);
    I4 = R(1) + a_e_a;
    return eta * k.y * k.y * I4b_minus_1(k, a_e_a);
  }
};

}  // namespace glisson
