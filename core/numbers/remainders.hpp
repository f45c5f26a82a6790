// What is left of log and exp after their linear part, with full relative accuracy: energies need it at small
// strain.
#pragma once

#include <glisson/core/numbers/functions.hpp>

namespace glisson {

/// x - log(1 + x) >= 0. For |x| < 1/4 by log(1 + x) = 2 atanh r, r = x / (2 + x): the difference is
/// r (x - 2 r^2 (1/3 + r^2/5 + r^4/7 + ...)); r^2 < 0.021, so nine terms reach double precision.
template <class R>
GLISSON_HD R linear_minus_log(const R& x) {
  const R r = x / (R(2) + x), r2 = r * r;
  R tail = R(1.0 / 19);
  for (int n = 17; n >= 3; n -= 2) tail = R(1.0 / n) + r2 * tail;
  return select(x * x < R(1.0 / 16), R(r * (x - R(2) * r2 * tail)), R(x - log_1p(x)));
}

/// exp(x) - 1 - x >= 0. For |x| < 1 by its Taylor polynomial; the first term left out is below 1e-16 of the
/// result.
template <class R>
GLISSON_HD R exp_minus_linear(const R& x) {
  R series = R(1);
  for (int n = 18; n >= 3; --n) series = R(1) + series * x * R(1.0 / n);
  return select(x * x < R(1), R(x * x * R(0.5) * series), R(exp_m1(x) - x));
}

}  // namespace glisson
