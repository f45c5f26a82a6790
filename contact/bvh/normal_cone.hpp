// Cones that hold the surface normals of a patch: an edge-connected patch whose cone opens by less than pi
// does not touch itself, unless its border does (Volino & Magnenat-Thalmann 1994; Johnsen 2016, eq. 5.2-5.6).
#pragma once

#include <cmath>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

constexpr double full_turn = 6.283185307179586;

struct NormalCone {
  Vec3<double> axis;  ///< unit; of no meaning when the angle is a full turn or the cone is empty
  double angle = -1;  ///< opening angle, twice the largest angle to the axis [rad]; -1: empty
};

/// A cone that excludes nothing: of patches that are not connected or have facets without area.
GLISSON_HD constexpr NormalCone any_direction() { return {{}, full_turn}; }

enum class ConeRule {
  narrowest,        ///< Johnsen 2016, eq. 5.4-5.6, or one of the two if it holds the other
  provot,           ///< axis: the mean of both axes (Provot 1997), for comparison
  provot_or_child,  ///< the same, or one of the two if it holds the other, for comparison
};

namespace cones {

GLISSON_HD inline double length_of(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

/// Angle of unit vectors, exact for small angles too.
GLISSON_HD inline double angle_of(const Vec3<double>& a, const Vec3<double>& b) {
  return 2 * std::atan2(length_of(a - b), length_of(a + b));
}

/// Widens a cone by what rounding may have lost.
GLISSON_HD inline NormalCone safe(const Vec3<double>& axis, double angle) {
  const double wide = angle * (1 + 1e-12) + 1e-14;
  return wide < full_turn ? NormalCone{axis, wide} : any_direction();
}

GLISSON_HD inline double larger_of(double a, double b) { return a < b ? b : a; }

/// Of the mean axis.
GLISSON_HD inline NormalCone about_mean(const NormalCone& a, const NormalCone& b, double beta) {
  const Vec3<double> sum = a.axis + b.axis;
  const double length = length_of(sum);
  if (!(length > 1e-9)) return any_direction();
  return safe((1 / length) * sum, beta + larger_of(a.angle, b.angle));
}

/// Eq. 5.4 with 5.5; beta: angle between the axes.
GLISSON_HD inline NormalCone narrowest(const NormalCone& a, const NormalCone& b, double beta) {
  const double angle = beta + (a.angle + b.angle) / 2;
  if (angle >= full_turn) return any_direction();
  // eq. 5.6 as a rotation of a's axis by beta_1 towards b's, which does not divide by 1 - e^2
  const double beta_1 = (2 * beta - (a.angle - b.angle)) / 4;
  const Vec3<double> aside = b.axis - dot(a.axis, b.axis) * a.axis;
  const double length = length_of(aside);
  if (!(length > 1e-12))
    return beta < 1 ? safe(a.axis, 2 * beta + larger_of(a.angle, b.angle)) : any_direction();
  const Vec3<double> axis = std::cos(beta_1) * a.axis + (std::sin(beta_1) / length) * aside;
  return safe((1 / length_of(axis)) * axis, angle);
}

}  // namespace cones

/// The cone of one facet with the normal n of any length.
GLISSON_HD inline NormalCone cone_of(const Vec3<double>& n) {
  const double length = cones::length_of(n);
  return length > 0 ? NormalCone{(1 / length) * n, 0} : any_direction();
}

/// Holds both cones.
GLISSON_HD inline NormalCone merged(const NormalCone& a, const NormalCone& b,
                                    ConeRule rule = ConeRule::narrowest) {
  if (a.angle < 0) return b;
  if (b.angle < 0) return a;
  if (a.angle >= full_turn || b.angle >= full_turn) return any_direction();
  const double beta = cones::angle_of(a.axis, b.axis);
  if (rule != ConeRule::provot && beta + b.angle / 2 <= a.angle / 2) return a;
  if (rule != ConeRule::provot && beta + a.angle / 2 <= b.angle / 2) return b;
  return rule == ConeRule::narrowest ? cones::narrowest(a, b, beta) : cones::about_mean(a, b, beta);
}

}  // namespace glisson::contact
