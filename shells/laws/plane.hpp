// Strain and stress in the tangent plane of a membrane, in an orthonormal frame of the rest triangle.
#pragma once

#include <glisson/core/numbers/functions.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson::shells {

/// Symmetric 2 x 2 tensor. As a strain it is c = C - I (twice Green-Lagrange), as a stress the second
/// Piola-Kirchhoff S per rest volume. xy is the tensor component, not the engineering shear.
template <class R>
struct Plane {
  R xx{}, yy{}, xy{};
};

/// det C - 1, without cancellation.
template <class R>
GLISSON_HD R area_change(const Plane<R>& c) {
  return c.xx + c.yy + (c.xx * c.yy - c.xy * c.xy);
}

/// I - (1 + q) C^-1, without cancellation: 1 + q is the squared thickness stretch of a plane stress state.
template <class R>
GLISSON_HD Plane<R> against_thickness(const Plane<R>& c, const R& q) {
  const R d = area_change(c), s = R(1) / (R(1) + d), r = s * (R(1) + q);
  return {s * (d - c.yy - q * (R(1) + c.yy)), s * (d - c.xx - q * (R(1) + c.xx)), r * c.xy};
}

/// I1 - 3 of an incompressible membrane, C33 = 1 / det C: of second order in the strain, and formed so.
template <class R>
GLISSON_HD R first_invariant(const Plane<R>& c) {
  const R t = c.xx + c.yy, det = c.xx * c.yy - c.xy * c.xy;
  return (c.xx * c.xx + c.xx * c.yy + c.yy * c.yy + c.xy * c.xy + t * det) / (R(1) + area_change(c));
}

template <class R>
GLISSON_HD R larger(const R& a, const R& b) {
  return select(a > b, a, b);
}

}  // namespace glisson::shells
