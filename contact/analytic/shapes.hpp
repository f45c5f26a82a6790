// Rigid bodies given by formulas: how deep a point lies in them and which way is out. `grown`: by how much a
// body is taken to be larger, for nodes of shells, which reach half of the thickness from their nodes [m].
#pragma once

#include <glisson/core/numbers/functions.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

/// Points are relative to the body's reference point. depth <= 0: no contact.
template <class R>
struct Penetration {
  R depth = R(0);  ///< [m]
  Vec3<R> out;     ///< unit, shortest way to the surface
};

/// Parallelogram a, b, c with the front along (b-a) x (c-a); Johnsen 2016, algorithm 4.3. A point behind the
/// plane is pushed to it when its projections on both edges lie between their ends. Reference point: a. The
/// plate has no back side, so points deeper than `reach` count as beyond it.
template <class R>
struct Plate {
  Vec3<R> normal, ab, ac;
  R ab_squared, ac_squared;  ///< [m^2]
  R reach;                   ///< [m]

  GLISSON_HD Penetration<R> operator()(const Vec3<R>& p, R grown = R(0)) const {
    const R depth = grown - dot(p, normal), along_ab = dot(p, ab), along_ac = dot(p, ac);
    const bool inside = depth > R(0) && depth <= reach + grown && along_ab >= R(0) &&
                        along_ab <= ab_squared && along_ac >= R(0) && along_ac <= ac_squared;
    return {inside ? depth : R(0), normal};
  }
};

/// Way out of a ball of radius `radius` from q relative to its centre (or, for q normal to an axis, out of a
/// cylinder). In the middle (within a millionth of the radius, where q is rounding) every way is as short,
/// and `side` is taken.
template <class R>
GLISSON_HD Penetration<R> out_of_circle(const Vec3<R>& q, R radius, const Vec3<R>& side) {
  const R r = square_root(dot(q, q));
  if (!(r < radius)) return {};
  return r > R(1e-6) * radius ? Penetration<R>{radius - r, (R(1) / r) * q} : Penetration<R>{radius, side};
}

/// The part of p normal to a unit axis; twice, because near the axis the first difference is mostly rounding.
template <class R>
GLISSON_HD Vec3<R> normal_to(const Vec3<R>& p, const Vec3<R>& axis, R along) {
  const Vec3<R> q = p - along * axis;
  return q - dot(q, axis) * axis;
}

/// Open cylinder: pushes radially where 0 < s < length along the axis. Reference point: the start of the
/// axis.
template <class R>
struct Cylinder {
  Vec3<R> axis, side;  ///< unit; side is normal to axis
  R radius, length;    ///< [m]

  GLISSON_HD Penetration<R> operator()(const Vec3<R>& p, R grown = R(0)) const {
    const R s = dot(p, axis);
    if (!(s > R(0) && s < length)) return {};
    return out_of_circle(normal_to(p, axis, s), radius + grown, side);
  }
};

/// Ultrasound probe: the cylinder, closed at s = length by a half sphere of the same radius.
template <class R>
struct Probe {
  Vec3<R> axis, side;
  R radius, length;

  GLISSON_HD Penetration<R> operator()(const Vec3<R>& p, R grown = R(0)) const {
    const R s = dot(p, axis);
    if (!(s > R(0))) return {};
    return s < length ? out_of_circle(normal_to(p, axis, s), radius + grown, side)
                      : out_of_circle(p - length * axis, radius + grown, axis);
  }
};

}  // namespace glisson::contact
