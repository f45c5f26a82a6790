// Wrinkling of membranes: where a principal stress would be negative, the membrane folds and that stress is
// 0.
#pragma once

#include <glisson/shells/laws/plane.hpp>

namespace glisson::shells {

/// The strain that counts: along the principal axes c1 >= c2 the larger one at least 0 (slack below) and the
/// other at least the natural width of a strip at c1.
template <class R>
struct TensionField {
  Plane<R> c;  ///< c1, c2 that count, on the principal axes
  R a, b;      ///< projector on the first axis: (1 + a)/2, (1 - a)/2, b/2
};

template <class R, class L>
GLISSON_HD TensionField<R> tension_field(const L& law, const Plane<R>& c) {
  const R mean = R(0.5) * (c.xx + c.yy), half = R(0.5) * (c.xx - c.yy);
  const R tiny = R(1e-30);  // equal principal strains: no direction is needed, a = b = 0
  const R square = half * half + c.xy * c.xy, r = square_root(square + tiny);
  const R c1 = larger(mean + r, R(0));
  return {{c1, larger(mean - r, law.natural_width(c1)), R(0)}, half / r, c.xy / r};
}

/// Relaxed energy of Pipkin 1986: min over the fold of W; isotropic laws. Its derivative is the law's stress
/// at the strain that counts.
template <class R, class L>
GLISSON_HD Plane<R> tension_field_stress(const L& law, const Plane<R>& c) {
  const TensionField<R> field = tension_field(law, c);
  const Plane<R> S = law.second_pk(field.c);
  const R mean = R(0.5) * (S.xx + S.yy), half = R(0.5) * (S.xx - S.yy);
  return {mean + half * field.a, mean - half * field.a, half * field.b};
}

}  // namespace glisson::shells
