// Eigenvalues and eigenvectors of a symmetric tensor by a fixed number of rotations: no branch, so that packs
// may use it.
#pragma once

#include <glisson/core/numbers/functions.hpp>
#include <glisson/core/tensor/symmetric.hpp>

namespace glisson {

/// a = sum_k value[k] n_k n_k^T with n_k = column k of vectors; no order is promised.
template <class R>
struct EigenSymmetric {
  R value[3];
  Mat3<R> vectors;
};

namespace detail {

/// One Jacobi rotation that makes a[p][q] vanish; r is the third index. t = tan of the smaller of the two
/// angles (Golub & Van Loan 2013, sec. 8.5), written as 2 a_pq / (d + sign(d) sqrt(d^2 + 4 a_pq^2)), d =
/// a_qq - a_pp.
template <class R>
GLISSON_HD void jacobi_rotation(Mat3<R>& a, Mat3<R>& v, int p, int q, int r) {
  const R apq = a.m[p][q], twice = apq + apq, d = a.m[q][q] - a.m[p][p];
  const R root = square_root(d * d + twice * twice);
  const R den = select(d < R(0), R(d - root), R(d + root));
  const R t = twice / select(root > R(0), den, R(1));
  const R c = R(1) / square_root(R(1) + t * t), s = t * c;
  a.m[p][p] = a.m[p][p] - t * apq;
  a.m[q][q] = a.m[q][q] + t * apq;
  a.m[p][q] = a.m[q][p] = R(0);
  const R arp = a.m[r][p], arq = a.m[r][q];
  a.m[r][p] = a.m[p][r] = c * arp - s * arq;
  a.m[r][q] = a.m[q][r] = s * arp + c * arq;
  for (int i = 0; i < 3; ++i) {
    const R vp = v.m[i][p], vq = v.m[i][q];
    v.m[i][p] = c * vp - s * vq;
    v.m[i][q] = s * vp + c * vq;
  }
}

}  // namespace detail

/// Four cyclic sweeps; convergence is quadratic, and for 3 x 3 what is left off the diagonal is below
/// rounding in double (tested). Duals: the derivative does not exist where eigenvalues meet, and is NaN
/// there.
template <class R>
GLISSON_HD EigenSymmetric<R> eigen_symmetric(const Sym3<R>& tensor) {
  Mat3<R> a = full(tensor);
  EigenSymmetric<R> result;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) result.vectors.m[i][k] = R(i == k ? 1 : 0);
  for (int sweep = 0; sweep < 4; ++sweep) {
    detail::jacobi_rotation(a, result.vectors, 0, 1, 2);
    detail::jacobi_rotation(a, result.vectors, 0, 2, 1);
    detail::jacobi_rotation(a, result.vectors, 1, 2, 0);
  }
  for (int i = 0; i < 3; ++i) result.value[i] = a.m[i][i];
  return result;
}

}  // namespace glisson
