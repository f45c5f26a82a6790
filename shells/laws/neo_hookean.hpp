// Neo-Hookean membranes: incompressible, and compressible in plane stress.
#pragma once

#include <glisson/core/materials/isochoric.hpp>
#include <glisson/shells/laws/plane.hpp>

namespace glisson::shells {

/// Bonet, Wood, Mahaney & Heywood 2000: W = mu/2 (tr C + 1/det C - 3), thickness stretch 1 / sqrt(det C).
template <class R>
struct NeoHookean {
  static constexpr const char* name = "NeoHookean";
  static constexpr int parameter_count = 1;
  R mu;  ///< [Pa]

  GLISSON_HD static NeoHookean load(const R* p) { return {p[0]}; }
  GLISSON_HD Plane<R> second_pk(const Plane<R>& c) const {
    const Plane<R> S = against_thickness(c, thickness_change(c));
    return {mu * S.xx, mu * S.yy, mu * S.xy};
  }
  GLISSON_HD R energy(const Plane<R>& c) const { return R(0.5) * mu * first_invariant(c); }
  GLISSON_HD R thickness_change(const Plane<R>& c) const {
    const R d = area_change(c);
    return R(0) - d / (R(1) + d);
  }
  GLISSON_HD R natural_width(const R& c1) const {  // C22 = C11^(-1/2) = r, r - 1 = -c1 / (C11 (r + 1))
    const R r = square_root(R(1) / (R(1) + c1));
    return R(0) - c1 / ((R(1) + c1) * (r + R(1)));
  }
};

/// The solid's law W = mu/2 (J^(-2/3) I1 - 3) + kappa/2 (J - 1)^2 with the thickness that makes S33 = 0. For
/// J this is g = mu/3 (2 J^2 / D - tr C) + kappa (J^(8/3) - J^(5/3)) = 0, D = det C: convex, so that Newton
/// from 1 comes from the right after one step at most. Ten steps reach rounding for kappa >= mu/3 and
/// stretches up to 3.
template <class R>
struct NeoHookeanCompressible {
  static constexpr const char* name = "NeoHookeanCompressible";
  static constexpr int parameter_count = 2;
  static constexpr int newton_steps = 10;
  R mu, kappa;  ///< [Pa]

  GLISSON_HD static NeoHookeanCompressible load(const R* p) { return {p[0], p[1]}; }

  /// J - 1, with g in a form without cancellation.
  GLISSON_HD R volume_change(const Plane<R>& c) const {
    const R d = area_change(c), t = c.xx + c.yy, w = R(1) / (R(1) + d);
    const R g0 = R(0) - w * (R(2) * d + t + t * d);  // 2 / D - tr C
    R j = R(0);
    for (int i = 0; i < newton_steps; ++i) {
      const R J = R(1) + j, J23 = J * rcbrt(J);
      const R g = mu * R(1.0 / 3) * (R(2) * w * j * (R(2) + j) + g0) + kappa * J * J23 * j;
      const R dg = mu * R(4.0 / 3) * w * J + kappa * R(1.0 / 3) * (R(8) * J - R(5)) * J23;
      j = larger(j - g / dg, R(-0.9));
    }
    return j;
  }
  GLISSON_HD Plane<R> second_pk(const Plane<R>& c) const {
    const R j = volume_change(c), y = rcbrt(R(1) + j), k = mu * y * y;
    const Plane<R> S = against_thickness(c, change_of_thickness(c, j));
    return {k * S.xx, k * S.yy, k * S.xy};
  }
  GLISSON_HD R energy(const Plane<R>& c) const {
    const R j = volume_change(c);
    return R(0.5) * (mu * distortion(c, change_of_thickness(c, j), rcbrt(R(1) + j)) + kappa * j * j);
  }
  GLISSON_HD R thickness_change(const Plane<R>& c) const { return change_of_thickness(c, volume_change(c)); }

  /// Uniaxial: C22 = C33 = J / l with l = sqrt(C11); g = mu/3 (J / l - C11) + kappa (J^(8/3) - J^(5/3)) = 0.
  GLISSON_HD R natural_width(const R& c1) const {
    const R C1 = R(1) + c1, w = square_root(R(1) / C1);
    const R l_minus_1 = c1 / (square_root(C1) + R(1));
    const R g0 = R(0) - l_minus_1 * w - c1;  // 1 / l - C11
    R j = R(0);
    for (int i = 0; i < newton_steps; ++i) {
      const R J = R(1) + j, y = rcbrt(J), J23 = J * y;
      const R g = mu * R(1.0 / 3) * (w * j + g0) + kappa * J * J23 * j;
      const R dg = mu * R(1.0 / 3) * w + kappa * R(1.0 / 3) * (R(8) * J - R(5)) * J23;
      j = larger(j - g / dg, R(-0.9));
    }
    return w * j - l_minus_1 * w;  // J / l - 1
  }

 private:
  GLISSON_HD static R change_of_thickness(const Plane<R>& c, const R& j) {  // J^2 / D - 1
    const R d = area_change(c);
    return (j * (R(2) + j) - d) / (R(1) + d);
  }
  /// J^(-2/3) I1 - 3 for C33 - 1 = q and y = J^(-1/3), as for solids: C = m (I + x), tr x = 0.
  GLISSON_HD static R distortion(const Plane<R>& c, const R& q, const R& y) {
    const R mean = R(1.0 / 3) * (c.xx + c.yy + q), one_over_m = R(1) / (R(1) + mean);
    const R xx = one_over_m * (c.xx - mean), yy = one_over_m * (c.yy - mean), zz = one_over_m * (q - mean),
            xy = one_over_m * c.xy;
    const R s = R(0.5) * (xx * xx + yy * yy + zz * zz) + xy * xy - (xx * yy - xy * xy) * zz;
    return three_over_z_minus_3(s, one_over_m / (y * y));
  }
};

}  // namespace glisson::shells
