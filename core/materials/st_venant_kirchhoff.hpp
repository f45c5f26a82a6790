// St Venant-Kirchhoff solid: the linear law in Green-Lagrange strain. For large rotation, not for large
// strain.
#pragma once

#include <glisson/core/materials/isochoric.hpp>

namespace glisson {

/// W = lambda/2 (tr E)^2 + mu E:E, E = (C - I)/2: Bonet & Wood 2008, ch. 6. Valid for small strain: it
/// softens in compression and loses ellipticity at a stretch of 1/sqrt(3) in one direction. J <= 0 gives NaN.
template <class R>
struct StVenantKirchhoff {
  static constexpr const char* name = "LE";
  static constexpr int parameter_count = 2;
  R lambda, mu;  ///< Lame parameters [Pa]

  /// p: Young's modulus [Pa], Poisson's ratio [-] below 1/2.
  GLISSON_HD static StVenantKirchhoff load(const R* p) {
    const R two_mu = p[0] / (R(1) + p[1]);
    return {two_mu * p[1] / (R(2) * (R(0.5) - p[1])), R(0.5) * two_mu};  // 1/2 - nu is exact near 1/2
  }
  GLISSON_HD R shear_modulus() const { return mu; }
  GLISSON_HD R bulk_modulus() const { return lambda + R(2.0 / 3) * mu; }
  GLISSON_HD R wave_modulus() const { return lambda + mu + mu; }

  GLISSON_HD Mat3<R> first_pk(const Mat3<R>& H) const {
    const Sym3<R> e = strain(H);
    return push_first(H, add_to_diagonal(mu * e, R(R(0.5) * lambda * trace(e))));
  }

  /// The split of small strain: S_iso = 2 mu dev E, S_vol = kappa tr(E) I.
  GLISSON_HD SplitStress<R> second_pk(const Mat3<R>& H) const {
    const Sym3<R> e = strain(H);
    const R p = R(0.5) * bulk_modulus() * trace(e);
    return {mu * deviator(e), {p, p, p, R(0), R(0), R(0)}};
  }

  GLISSON_HD R energy(const Mat3<R>& H) const {
    const Sym3<R> e = strain(H);
    const R tr = trace(e);
    return R(0.125) * lambda * tr * tr + R(0.25) * mu * contract(e, e);
  }

 private:
  /// 2 E, or NaN for J <= 0: the law itself would take an inverted element for a healthy one.
  GLISSON_HD static Sym3<R> strain(const Mat3<R>& H) {
    Mat3<R> D;
    R j;
    volume_terms(H, D, j);
    const Sym3<R> e = twice_green_lagrange(H);
    return add_to_diagonal(e, select(j > R(-1), R(0), R(NAN)));
  }
};

}  // namespace glisson
