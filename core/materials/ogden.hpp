// Ogden solid with up to three terms in the principal stretches: brain, fat and other tissue that
// Mooney-Rivlin misses.
#pragma once

#include <glisson/core/materials/isochoric.hpp>
#include <glisson/core/numbers/remainders.hpp>
#include <glisson/core/tensor/eigen_symmetric.hpp>
#include <glisson/core/tensor/traceless_eigenvalues.hpp>

namespace glisson {

/// W = sum_i mu_i/alpha_i (l1^alpha_i + l2^alpha_i + l3^alpha_i - 3) + kappa/2 (J - 1)^2 with the isochoric
/// principal stretches l_k = J^(-1/3) lambda_k: Ogden 1972. The shear modulus at rest is sum mu_i
/// alpha_i / 2. Valid for J > 0. An unused term has mu = 0 and any alpha. Derivatives by dual numbers fail
/// where stretches are equal.
template <class R>
struct Ogden {
  static constexpr const char* name = "OG";
  static constexpr int parameter_count = 7;
  R mu1, alpha1, mu2, alpha2, mu3, alpha3;  ///< mu [Pa], exponent alpha [-]
  R kappa;                                  ///< bulk modulus [Pa]

  GLISSON_HD static Ogden load(const R* p) { return {p[0], p[1], p[2], p[3], p[4], p[5], p[6]}; }
  GLISSON_HD R shear_modulus() const { return R(0.5) * (mu1 * alpha1 + mu2 * alpha2 + mu3 * alpha3); }
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
  /// The logarithms L_k of the stretches sum to 0, so that sum l_k^alpha - 3 = sum (exp(alpha L_k) - 1 -
  /// alpha L_k).
  GLISSON_HD R energy(const Mat3<R>& H) const {
    const Kinematics<R> k = kinematics(H);
    R L[3];
    log_stretches(eigen_symmetric(k.e), k, L);
    return term(mu1, alpha1, L) + term(mu2, alpha2, L) + term(mu3, alpha3, L) +
           R(0.5) * kappa * k.J_minus_1 * k.J_minus_1;
  }

 private:
  /// L_k = log l_k from the eigenvalues of C - I; NaN for J <= 0.
  GLISSON_HD static void log_stretches(const EigenSymmetric<R>& e, const Kinematics<R>& k, R (&L)[3]) {
    const R l0 = log_1p(e.value[0]), l1 = log_1p(e.value[1]), l2 = log_1p(e.value[2]);
    const R p = l0 - l1, q = l1 - l2, r = l2 - l0, sixth = select(k.J_minus_1 > R(-1), R(1.0 / 6), R(NAN));
    L[0] = sixth * (p - r), L[1] = sixth * (q - p), L[2] = sixth * (r - q);
  }

  GLISSON_HD static R term(const R& mu, const R& alpha, const R (&L)[3]) {
    const R sum = exp_minus_linear(R(alpha * L[0])) + exp_minus_linear(R(alpha * L[1])) +
                  exp_minus_linear(R(alpha * L[2]));
    return mu * sum / select(alpha * alpha > R(0), alpha, R(1));
  }

  GLISSON_HD R sum_of_terms(const R& L, R (&e)[3]) const {
    e[0] = exp_m1(R(alpha1 * L)), e[1] = exp_m1(R(alpha2 * L)), e[2] = exp_m1(R(alpha3 * L));
    return mu1 * e[0] + mu2 * e[1] + mu3 * e[2];
  }

  /// M = dev t(C) with t(l) = sum_i mu_i (l^alpha_i - 1) is a polynomial of second degree in C = m (I + x),
  /// found from the values of t at the three eigenvalues of x by divided differences (Newton's form), without
  /// eigenvectors. The difference of the two values that may be close is a product, mu l^alpha (exp(alpha
  /// log ratio) - 1), so that nothing cancels where they meet; an error d of their distance changes M by
  /// d^2 only.
  GLISSON_HD Sym3<R> mandel(const Kinematics<R>& k) const {
    const Sym3<R> x = R(1) / (R(1) + trace(k.e) * R(1.0 / 3)) * deviator(k.e);
    const TracelessEigenvalues<R> v = traceless_eigenvalues(x);
    const R low = v.middle - v.half_gap, gap = v.half_gap + v.half_gap;
    const R above = log_1p(R(gap / (R(1) + low))), far = log_1p(v.apart) - log_1p(low), sixth = R(1.0 / 6);
    R at_apart[3], at_low[3], ratio[3];
    const R t_apart = sum_of_terms(R(sixth * (far + far - above)), at_apart);
    const R t_low = sum_of_terms(R(R(0) - sixth * (far + above)), at_low);
    sum_of_terms(R(R(0.5) * above), ratio);
    const R jump = mu1 * (ratio[0] + at_low[0] * ratio[0]) + mu2 * (ratio[1] + at_low[1] * ratio[1]) +
                   mu3 * (ratio[2] + at_low[2] * ratio[2]);
    const R slope = jump / gap, distance = v.apart - v.middle;
    const R bend = (t_apart - t_low - R(0.5) * jump - slope * distance) /
                   (distance * distance - v.half_gap * v.half_gap);
    return R(slope + bend * v.apart) * x + bend * deviator(commuting_product(x, x));
  }
};

}  // namespace glisson
