// Linear plane stress on the Green-Lagrange strain, so that rotation gives no stress.
#pragma once

#include <glisson/shells/laws/plane.hpp>

namespace glisson::shells {

/// W = E / (2 (1 - nu^2)) (E11^2 + E22^2 + 2 nu E11 E22 + 2 (1 - nu) E12^2), for small strain.
template <class R>
struct Linear {
  static constexpr const char* name = "Linear";
  static constexpr int parameter_count = 2;
  R E, nu;  ///< [Pa, -]

  GLISSON_HD static Linear load(const R* p) { return {p[0], p[1]}; }
  GLISSON_HD Plane<R> second_pk(const Plane<R>& c) const {
    const R k = R(0.5) * E / (R(1) - nu * nu);
    return {k * (c.xx + nu * c.yy), k * (c.yy + nu * c.xx), k * (R(1) - nu) * c.xy};
  }
  GLISSON_HD R energy(const Plane<R>& c) const {
    const Plane<R> S = second_pk(c);
    return R(0.25) * (S.xx * c.xx + S.yy * c.yy + R(2) * S.xy * c.xy);
  }
  /// C33 - 1; it stays above -1, where the law has lost its meaning.
  GLISSON_HD R thickness_change(const Plane<R>& c) const {
    return larger(R(0) - nu / (R(1) - nu) * (c.xx + c.yy), R(-0.99));
  }
  /// c22 of a strip that is pulled to c11 and free to narrow.
  GLISSON_HD R natural_width(const R& c1) const { return R(0) - nu * c1; }
};

}  // namespace glisson::shells
