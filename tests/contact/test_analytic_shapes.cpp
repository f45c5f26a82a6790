// Geometry of plate, cylinder and probe, edge cases included.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <glisson/contact/analytic/rigid_motion.hpp>
#include <glisson/core/base/error.hpp>

namespace glisson::contact {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

RigidBody cylinder_body(Vec3<double> axis = {0, 0, 2}) {
  RigidBody body;
  body.shape = RigidShape::cylinder;
  body.axis = axis;
  body.radius = 1;
  body.length = 3;
  return body;
}
RigidBody plate_body() {
  RigidBody body;  // z = 0, 2 x 1, front along +z
  body.corners = {{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}};
  return body;
}
void expect_out(const Penetration<double>& p, double depth, Vec3<double> out) {
  EXPECT_NEAR(p.depth, depth, 1e-15);
  EXPECT_NEAR(p.out.x, out.x, 1e-15);
  EXPECT_NEAR(p.out.y, out.y, 1e-15);
  EXPECT_NEAR(p.out.z, out.z, 1e-15);
}

TEST(PlateShape, PushesToItsFrontWithinItsBounds) {
  const auto plate = RigidMotion(plate_body()).plate();
  expect_out(plate({0.5, 0.5, -0.1}), 0.1, {0, 0, 1});
  expect_out(plate({0, 0, -0.1}), 0.1, {0, 0, 1});  // at a corner and on the far edges: still on it
  expect_out(plate({2, 1, -0.1}), 0.1, {0, 0, 1});
  for (const Vec3<double>& p : {Vec3<double>{0.5, 0.5, 0.1},
                                {0.5, 0.5, 0},
                                {-0.01, 0.5, -0.1},
                                {2.01, 0.5, -0.1},
                                {0.5, -0.01, -0.1},
                                {0.5, 1.01, -0.1},
                                {0.5, 0.5, -2.01},
                                {nan, 0, -0.1}})
    EXPECT_LE(plate(p).depth, 0);
}

TEST(CylinderShape, PushesRadiallyBetweenItsEnds) {
  const RigidMotion motion(cylinder_body());
  const auto cylinder = motion.cylinder(0);
  expect_out(cylinder({0.25, 0, 1}), 0.75, {1, 0, 0});
  expect_out(cylinder({0, -0.5, 2.99}), 0.5, {0, -1, 0});
  for (const Vec3<double>& p : {Vec3<double>{0.5, 0, 0},
                                {0.5, 0, 3},
                                {0.5, 0, -0.1},
                                {0.5, 0, 3.1},
                                {1, 0, 1},
                                {2, 0, 1},
                                {0.1, nan, 1}})
    EXPECT_FALSE(cylinder(p).depth > 0);
}

TEST(CylinderShape, ANodeOnTheAxisGoesSideways) {
  for (const Vec3<double>& axis :
       {Vec3<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, -1, 1}, {1e-20, 0, 1e-20}}) {
    const auto cylinder = RigidMotion(cylinder_body(axis)).cylinder(0);
    const auto p = cylinder(1.5 * cylinder.axis);
    EXPECT_NEAR(p.depth, 1, 1e-12);
    EXPECT_NEAR(dot(p.out, p.out), 1, 1e-12);
    EXPECT_NEAR(dot(p.out, cylinder.axis), 0, 1e-12);
  }
}

TEST(ProbeShape, HasAHalfSphereAtItsTip) {
  Probe<double> probe;
  shape_at(RigidMotion(cylinder_body()), 0, probe);
  expect_out(probe({0.5, 0, 1}), 0.5, {1, 0, 0});
  expect_out(probe({0.5, 0, 3}), 0.5, {1, 0, 0});  // where both meet, both agree
  expect_out(probe({0, 0, 3.75}), 0.25, {0, 0, 1});
  expect_out(probe({0, 0.3, 3.4}), 0.5, {0, 0.6, 0.8});
  expect_out(probe({0, 0, std::nextafter(3.0, 4.0)}), 1, {0, 0, 1});
  for (const Vec3<double>& p : {Vec3<double>{0, 0, 4}, {0, 0, -0.1}, {0.1, 0, 0}, {0.8, 0, 3.7}, {1, 0, 2}})
    EXPECT_LE(probe(p).depth, 1e-15);
}

TEST(RigidMotionTest, BodiesMoveAndGrowAlongTheirCurve) {
  RigidBody body = cylinder_body();
  body.displacement = {4, 0, -2};
  body.radius_change = -2;
  body.motion = {LoadShape::ramp, 1, 3};
  const RigidMotion motion(body);
  EXPECT_EQ(motion.shift(0).x, 0);
  EXPECT_EQ(motion.shift(2).x, 2);
  EXPECT_EQ(motion.shift(9).z, -2);
  EXPECT_EQ(motion.radius(1.5), 0.5);
  EXPECT_FALSE(motion.cylinder(3)({0, 0, 1}).depth > 0);  // shrunk to nothing
}

TEST(RigidMotionTest, RefusesBodiesWithoutExtent) {
  RigidBody flat = plate_body();
  flat.corners[2] = {1, 0, 0};
  EXPECT_THROW(RigidMotion{flat}, Error);
  for (const double bad : {0.0, -1.0, nan}) {
    RigidBody body = cylinder_body();
    body.radius = bad;
    EXPECT_THROW(RigidMotion{body}, Error);
    body = cylinder_body({bad > 0 ? 0 : bad, 0, 0});
    body.length = bad;
    EXPECT_THROW(RigidMotion{body}, Error);
  }
  EXPECT_THROW(RigidMotion{cylinder_body({0, 0, 0})}, Error);
}

}  // namespace
}  // namespace glisson::contact
