// Two families of fibres in an incompressible neo-Hookean matrix.
#pragma once

#include <glisson/shells/laws/plane.hpp>

namespace glisson::shells {

/// Holzapfel, Gasser & Ogden 2000: W = mu/2 (I1 - 3) + sum k1 / (2 k2) (exp(k2 (I4 - 1)^2) - 1) over the
/// fibres at +angle and -angle from the first local axis; a fibre works in tension only, I4 > 1.
template <class R>
struct TwoFibre {
  static constexpr const char* name = "TwoFibre";
  static constexpr int parameter_count = 4;
  R mu, k1, k2;    ///< [Pa, Pa, -]
  R cos_a, sin_a;  ///< of the fibres' angle to the first axis [-]

  GLISSON_HD static TwoFibre load(const R* p) {
    // the angle is a parameter of the section, a built-in number; sine and cosine by their series
    const R x = p[3] * R(0.017453292519943295);
    return {p[0], p[1], p[2], cosine(x), sine(x)};
  }
  GLISSON_HD Plane<R> second_pk(const Plane<R>& c) const {
    const Plane<R> S = against_thickness(c, thickness_change(c));
    const R plus = pull(stretch(c, sin_a)), minus = pull(stretch(c, R(0) - sin_a)), sum = plus + minus;
    return {mu * S.xx + sum * cos_a * cos_a, mu * S.yy + sum * sin_a * sin_a,
            mu * S.xy + (plus - minus) * cos_a * sin_a};
  }
  GLISSON_HD R energy(const Plane<R>& c) const {
    const R e = larger(stretch(c, sin_a), R(0)), g = larger(stretch(c, R(0) - sin_a), R(0));
    return R(0.5) * (mu * first_invariant(c) + k1 / k2 * (exp_m1(k2 * e * e) + exp_m1(k2 * g * g)));
  }
  GLISSON_HD R thickness_change(const Plane<R>& c) const {
    const R d = area_change(c);
    return R(0) - d / (R(1) + d);
  }
  /// Not isotropic: no tension field (validate() refuses it).
  GLISSON_HD R natural_width(const R& c1) const { return R(0) * c1; }

 private:
  /// I4 - 1
  GLISSON_HD R stretch(const Plane<R>& c, const R& s) const {
    return cos_a * cos_a * c.xx + s * s * c.yy + R(2) * cos_a * s * c.xy;
  }
  /// 2 dW/dI4
  GLISSON_HD R pull(const R& stretched) const {
    const R e = larger(stretched, R(0));
    return R(2) * k1 * e * (R(1) + exp_m1(k2 * e * e));
  }
  GLISSON_HD static R sine(const R& x) {  // |x| <= pi/2: error below 1e-16
    R term = x, sum = x;
    for (int k = 1; k < 11; ++k) term = R(0) - term * x * x / R(2 * k * (2 * k + 1)), sum = sum + term;
    return sum;
  }
  GLISSON_HD static R cosine(const R& x) {
    R term = R(1), sum = R(1);
    for (int k = 1; k < 11; ++k) term = R(0) - term * x * x / R(2 * k * (2 * k - 1)), sum = sum + term;
    return sum;
  }
};

}  // namespace glisson::shells
