#include <glisson/core/rigid_poses.hpp>

#include <algorithm>
#include <cmath>

namespace glisson {
namespace {

Quaternion sum(double s, const Quaternion& a, double t, const Quaternion& b) {
  Quaternion c;
  for (std::size_t i = 0; i < 4; ++i) c[i] = s * a[i] + t * b[i];
  return c;
}

/// b, or its negative, which is the same rotation: the one nearer to a.
Quaternion nearer(const Quaternion& a, const Quaternion& b) {
  double along = 0;
  for (std::size_t i = 0; i < 4; ++i) along += a[i] * b[i];
  return sum(0, a, along < 0 ? -1 : 1, b);
}

/// Of the arc between unit vectors; exact for small and large ones (Kahan 2006).
double arc(const Quaternion& a, const Quaternion& b) {
  return 2 * std::atan2(length_of(sum(1, a, -1, b)), length_of(sum(1, a, 1, b)));
}

Quaternion slerp(const Quaternion& a, const Quaternion& b, double s) {
  const Quaternion near = nearer(a, b);
  const double angle = arc(a, near), whole = std::sin(angle);
  // below 1e-6 the chord is the arc to rounding
  const Quaternion q = angle < 1e-6
                           ? sum(1 - s, a, s, near)
                           : sum(std::sin((1 - s) * angle) / whole, a, std::sin(s * angle) / whole, near);
  return sum(1 / length_of(q), q, 0, q);
}

}  // namespace

Quaternion quaternion_of(const Vec3<double>& v) {
  const double angle = std::sqrt(dot(v, v));
  const double share = angle > 0 ? std::sin(0.5 * angle) / angle : 0.5;
  return {std::cos(0.5 * angle), share * v.x, share * v.y, share * v.z};
}

Mat3<double> matrix_of(const Quaternion& q) {
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

double length_of(const Quaternion& q) {
  return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

double angle_between(const Quaternion& a, const Quaternion& b) { return 2 * arc(a, nearer(a, b)); }

RigidPose pose_in(const std::vector<RigidPose>& table, double t) {
  const auto after = std::upper_bound(table.begin(), table.end(), t,
                                      [](double time, const RigidPose& pose) { return time < pose.time; });
  if (after == table.begin()) return table.front();
  if (after == table.end()) return table.back();
  const RigidPose &a = *(after - 1), &b = *after;
  const double s = (t - a.time) / (b.time - a.time);
  return {t, (1 - s) * a.shift + s * b.shift, slerp(a.turn, b.turn, s)};
}

}  // namespace glisson
