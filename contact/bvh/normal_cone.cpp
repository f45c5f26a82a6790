#include <glisson/contact/bvh/normal_cone.hpp>

#include <algorithm>
#include <cmath>

namespace glisson::contact {
namespace {

double length_of(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

/// Angle of unit vectors, exact for small angles too.
double angle_of(const Vec3<double>& a, const Vec3<double>& b) {
  return 2 * std::atan2(length_of(a - b), length_of(a + b));
}

/// Widens a cone by what rounding may have lost.
NormalCone safe(const Vec3<double>& axis, double angle) {
  const double wide = angle * (1 + 1e-12) + 1e-14;
  return wide < full_turn ? NormalCone{axis, wide} : any_direction;
}

}  // namespace

NormalCone cone_of(const Vec3<double>& n) {
  const double length = length_of(n);
  return length > 0 ? NormalCone{(1 / length) * n, 0} : any_direction;
}

NormalCone merged(const NormalCone& a, const NormalCone& b, ConeRule rule) {
  if (a.angle < 0) return b;
  if (b.angle < 0) return a;
  if (a.angle >= full_turn || b.angle >= full_turn) return any_direction;
  const double beta = angle_of(a.axis, b.axis);
  if (rule != ConeRule::provot && beta + b.angle / 2 <= a.angle / 2) return a;
  if (rule != ConeRule::provot && beta + a.angle / 2 <= b.angle / 2) return b;
  if (rule != ConeRule::narrowest) {
    const Vec3<double> sum = a.axis + b.axis;
    const double length = length_of(sum);
    if (!(length > 1e-9)) return any_direction;
    return safe((1 / length) * sum, beta + std::max(a.angle, b.angle));
  }
  const double angle = beta + (a.angle + b.angle) / 2;  // eq. 5.4 with 5.5
  if (angle >= full_turn) return any_direction;
  // eq. 5.6 as a rotation of a's axis by beta_1 towards b's, which does not divide by 1 - e^2
  const double beta_1 = (2 * beta - (a.angle - b.angle)) / 4;
  const Vec3<double> aside = b.axis - dot(a.axis, b.axis) * a.axis;
  const double length = length_of(aside);
  if (!(length > 1e-12))
    return beta < 1 ? safe(a.axis, 2 * beta + std::max(a.angle, b.angle)) : any_direction;
  const Vec3<double> axis = std::cos(beta_1) * a.axis + (std::sin(beta_1) / length) * aside;
  return safe((1 / length_of(axis)) * axis, angle);
}

}  // namespace glisson::contact
