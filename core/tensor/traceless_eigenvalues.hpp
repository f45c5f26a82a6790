// Eigenvalues of a symmetric tensor without trace, in closed form and without a branch.
#pragma once

#include <glisson/core/numbers/functions.hpp>
#include <glisson/core/tensor/symmetric.hpp>

namespace glisson {

/// The eigenvalue that lies apart, and the other two: middle -+ half_gap with middle = -apart / 2. half_gap >
/// 0 even where the two meet, so that one may divide by it; it is known to the square root of the rounding
/// error only.
template <class R>
struct TracelessEigenvalues {
  R apart, middle, half_gap;
};

/// x = sqrt(q) Y with q = x:x / 6 turns the characteristic equation into y^3 - 3 y = 2 r, r = det Y / 2 in
/// [-1, 1] (Smith 1961). The root of the sign of r, |y| = 2 cos(acos |r| / 3), lies apart from the others: a
/// polynomial in |r| (error 1e-5) and two steps of Newton's method, whose slope 3 y^2 - 3 >= 6, find it to
/// rounding error.
template <class R>
GLISSON_HD TracelessEigenvalues<R> traceless_eigenvalues(const Sym3<R>& x) {
  // below the smallest strain that a float can show: equidistant numbers then stand for the eigenvalues
  const R q = contract(x, x) * R(1.0 / 6) + R(1e-30);
  const R root = square_root(q), scale = R(1) / root;
  const R half_det = R(0.5) * determinant(scale * x);
  const R r = select(half_det < R(0), R(R(0) - half_det), half_det);
  R y = R(1.73206086) + r * (R(0.33282344) + r * (R(-0.09184387) + r * (R(0.03502438) + r * R(-0.00807080))));
  for (int i = 0; i < 2; ++i) {
    const R square = y * y;
    y = (square * y + r) * R(2.0 / 3) / (square - R(1));
  }
  const R gap_square = R(3) - R(0.75) * y * y;  // the product of the roots is 2 r, their sum 0
  const R half_gap = square_root(select(gap_square > R(1e-20), gap_square, R(1e-20)));
  const R apart = root * select(half_det < R(0), R(R(0) - y), y);
  return {apart, R(-0.5) * apart, root * half_gap};
}

}  // namespace glisson
