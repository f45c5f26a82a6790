// Tables of rigid poses: rotations against Rodrigues' formula, one axis and one speed between rows, the
// shorter way.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include <glisson/core/rigid_poses.hpp>

namespace glisson {
namespace {

constexpr double pi = std::numbers::pi;

/// R p = p cos a + (k x p) sin a + k (k . p) (1 - cos a), the formula of Rodrigues without quaternions.
Vec3<double> turned(const Vec3<double>& v, const Vec3<double>& p) {
  const double a = std::sqrt(dot(v, v));
  if (a == 0) return p;
  const Vec3<double> k = (1 / a) * v;
  return std::cos(a) * p + std::sin(a) * cross(k, p) + ((1 - std::cos(a)) * dot(k, p)) * k;
}
Vec3<double> times(const Mat3<double>& a, const Vec3<double>& v) {
  return {a.m[0][0] * v.x + a.m[0][1] * v.y + a.m[0][2] * v.z,
          a.m[1][0] * v.x + a.m[1][1] * v.y + a.m[1][2] * v.z,
          a.m[2][0] * v.x + a.m[2][1] * v.y + a.m[2][2] * v.z};
}
double distance(const Vec3<double>& a, const Vec3<double>& b) {
  const Vec3<double> d = a - b;
  return std::sqrt(dot(d, d));
}

TEST(RigidPoses, RotationVectorsTurnAsRodriguesSays) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-4, 4);
  for (int i = 0; i < 1000; ++i) {
    const double size = i % 3 == 0 ? 1e-9 : 1;
    const Vec3<double> v = size * Vec3<double>{number(random), number(random), number(random)};
    const Vec3<double> p{number(random), number(random), number(random)};
    EXPECT_LT(distance(times(matrix_of(quaternion_of(v)), p), turned(v, p)), 1e-14);
  }
  const Vec3<double> y = times(matrix_of(quaternion_of({0, 0, pi / 2})), {1, 0, 0});
  EXPECT_LT(distance(y, {0, 1, 0}), 1e-15) << "a right-handed turn about z takes x to y";
}

/// R(s) = R(axis, s angle) R_0 between two rows, from tiny angles up to nearly half a turn.
TEST(RigidPoses, BetweenRowsOneAxisAndOneSpeed) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (const double angle : {1e-12, 1e-7, 2e-6, 1e-3, 1.0, 3.0, pi - 1e-5})
    for (int i = 0; i < 100; ++i) {
      const Vec3<double> first{normal(random), normal(random), normal(random)};
      Vec3<double> axis{normal(random), normal(random), normal(random)};
      axis = (1 / std::sqrt(dot(axis, axis))) * axis;
      const Quaternion a = quaternion_of(first), d = quaternion_of(angle * axis);
      const Quaternion b{d[0] * a[0] - d[1] * a[1] - d[2] * a[2] - d[3] * a[3],
                         d[0] * a[1] + d[1] * a[0] + d[2] * a[3] - d[3] * a[2],
                         d[0] * a[2] - d[1] * a[3] + d[2] * a[0] + d[3] * a[1],
                         d[0] * a[3] + d[1] * a[2] - d[2] * a[1] + d[3] * a[0]};
      const Quaternion same{-b[0], -b[1], -b[2], -b[3]};
      EXPECT_NEAR(angle_between(a, b), angle, 1e-14);
      const Vec3<double> p{1, 2, -1};
      for (const auto& end : {b, same})
        for (const double s : {0.0, 0.2, 0.5, 0.9}) {
          const std::vector<RigidPose> table{{2, {1, 0, 0}, a}, {4, {3, 0, 1}, end}};
          const RigidPose pose = pose_in(table, 2 + 2 * s);
          EXPECT_LT(distance(times(matrix_of(pose.turn), p), turned(s * angle * axis, turned(first, p))),
                    1e-9 * angle + 2e-14);
          EXPECT_LT(distance(pose.shift, {1 + 2 * s, 0, s}), 1e-15);
        }
    }
}

TEST(RigidPoses, RowsAreMetExactlyAndTheEndsHold) {
  const std::vector<RigidPose> table{{1, {1, 2, 3}, quaternion_of({0.1, 0, 0})},
                                     {2, {4, 5, 6}, quaternion_of({0, 0.2, 0})},
                                     {4, {7, 8, 9}, quaternion_of({0, 0, 0.3})}};
  for (const double t : {-1.0, 0.0, 1.0}) EXPECT_EQ(pose_in(table, t).shift.x, 1);
  EXPECT_EQ(pose_in(table, 2).shift.y, 5);
  EXPECT_LT(angle_between(pose_in(table, 2).turn, table[1].turn), 1e-15);
  for (const double t : {4.0, 5.0, 1e9}) {
    EXPECT_EQ(pose_in(table, t).shift.z, 9);
    EXPECT_EQ(pose_in(table, t).turn, table[2].turn);
  }
}

/// From 170 to -170 degrees about z: through 180, not back through 0.
TEST(RigidPoses, TakesTheShorterWay) {
  const double a = 170 * pi / 180;
  const std::vector<RigidPose> table{{0, {}, quaternion_of({0, 0, a})}, {1, {}, quaternion_of({0, 0, -a})}};
  const Vec3<double> x = times(matrix_of(pose_in(table, 0.5).turn), {1, 0, 0});
  EXPECT_LT(distance(x, {-1, 0, 0}), 1e-15);
}

}  // namespace
}  // namespace glisson
