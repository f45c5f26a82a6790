// Exponential law of skin and capsules, incompressible and isotropic.
#pragma once

#include <glisson/shells/laws/plane.hpp>

namespace glisson::shells {

/// W = mu / (2 b) (exp(b (I1 - 3)) - 1): Fung 1967 in the isotropic form of Demiray 1972.
template <class R>
struct Fung {
  static constexpr const char* name = "Fung";
  static constexpr int parameter_count = 2;
  R mu, b;  ///< shear modulus at rest [Pa], stiffening [-]

  GLISSON_HD static Fung load(const R* p) { return {p[0], p[1]}; }
  GLISSON_HD Plane<R> second_pk(const Plane<R>& c) const {
    const Plane<R> S = against_thickness(c, thickness_change(c));
    const R k = mu * (R(1) + exp_m1(b * first_invariant(c)));
    return {k * S.xx, k * S.yy, k * S.xy};
  }
  GLISSON_HD R energy(const Plane<R>& c) const { return R(0.5) * mu / b * exp_m1(b * first_invariant(c)); }
  GLISSON_HD R thickness_change(const Plane<R>& c) const {
    const R d = area_change(c);
    return R(0) - d / (R(1) + d);
  }
  GLISSON_HD R natural_width(const R& c1) const {
    const R r = square_root(R(1) / (R(1) + c1));
    return R(0) - c1 / ((R(1) + c1) * (r + R(1)));
  }
};

}  // namespace glisson::shells
