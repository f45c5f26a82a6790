// What most laws need of H = du/dX, formed without subtracting nearly equal numbers, so that float stays good
// at any strain.
#pragma once

#include <glisson/core/numbers/functions.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

template <class R>
struct Kinematics {
  Mat3<R> D;    ///< cof F - I = tr(H) I - H^T + cof H
  R J_minus_1;  ///< det F - 1 = tr H + tr cof H + det H
  R y;          ///< J^(-1/3)
  Sym3<R> e;    ///< C - I = H + H^T + H^T H (twice Green-Lagrange)
};

template <class R>
GLISSON_HD Sym3<R> twice_green_lagrange(const Mat3<R>& H) {
  const auto& h = H.m;
  auto column = [&](int a, int b) { return h[0][a] * h[0][b] + h[1][a] * h[1][b] + h[2][a] * h[2][b]; };
  return {h[0][0] + h[0][0] + column(0, 0), h[1][1] + h[1][1] + column(1, 1),
          h[2][2] + h[2][2] + column(2, 2), h[0][1] + h[1][0] + column(0, 1),
          h[1][2] + h[2][1] + column(1, 2), h[0][2] + h[2][0] + column(0, 2)};
}

/// D = cof F - I and J - 1, without cancellation.
template <class R>
GLISSON_HD void volume_terms(const Mat3<R>& H, Mat3<R>& D, R& J_minus_1) {
  D = cofactor(H);
  const R I = trace(H), II = trace(D);
  const R III = H.m[0][0] * D.m[0][0] + H.m[0][1] * D.m[0][1] + H.m[0][2] * D.m[0][2];
  J_minus_1 = I + II + III;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) D.m[i][k] = D.m[i][k] - H.m[k][i];
  for (int i = 0; i < 3; ++i) D.m[i][i] = D.m[i][i] + I;
}

template <class R>
GLISSON_HD Kinematics<R> kinematics(const Mat3<R>& H) {
  Kinematics<R> k;
  volume_terms(H, k.D, k.J_minus_1);
  k.y = rcbrt(k.J_minus_1 + R(1));
  k.e = twice_green_lagrange(H);
  return k;
}

}  // namespace glisson
