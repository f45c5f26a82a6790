// Rigid surfaces that follow a table of poses: nodes go where the rows take them, on every backend.
#include <numbers>

#include <glisson/run/model_hash.hpp>

#include "tests/contact/surface_scene.hpp"

namespace glisson::contact {
namespace {

using SurfacePoses = BenchTest;
GLISSON_BENCH_CASES(SurfacePoses);

RigidPose at(double time, const Vec3<double>& shift, const Vec3<double>& turn = {}) {
  return {time, shift, quaternion_of(turn)};
}

/// A turn by three quarters in four rows: a rough floor takes the nodes along the arc, not along chords.
TEST_P(SurfacePoses, ARoughFloorTurnsWhatLiesOnIt) {
  RigidSurface turning = floor_of();
  turning.friction = 100;
  turning.centre = {2, 2, 0};
  const double whole = 1.5 * std::numbers::pi;
  for (int i = 0; i < 4; ++i) turning.poses.push_back(at(i / 3.0, {}, {0, 0, whole * i / 3}));
  SurfaceScene scene(GetParam(), {{3, 2, 0}, {2, 3.5, 0}}, turning);
  scene.gravity = {0, 0, -1000};
  const double eps = 1e4 * scene.bench.tolerance() + 2e-4;
  for (int n = 1; n <= 200; ++n) {
    scene.step(0.005);
    const double a = whole * n / 200;
    expect_near(scene.position(0), {2 + std::cos(a), 2 + std::sin(a), 0}, eps);
    expect_near(scene.position(1), {2 - 1.5 * std::sin(a), 2 + 1.5 * std::cos(a), 0}, eps);
  }
}

/// Friction acts on the motion relative to the surface: at the speed of the rows a node that lies on it
/// neither slips nor is pushed; against a standing floor it would lose mu g t.
TEST_P(SurfacePoses, FrictionSeesTheSpeedOfTheRows) {
  RigidSurface belt = floor_of();
  belt.friction = 0.3;
  belt.poses = {at(0, {}), at(0.5, {0.5, 0, 0}), at(1, {0.5, 0.5, 0})};
  SurfaceScene scene(GetParam(), {{1, 1, 0}}, belt);
  scene.gravity = {0, 0, -10};
  scene.bench.v[0] = {1, 0, 0};
  for (int n = 0; n < 50; ++n) scene.step(0.01);
  const double eps = 1e3 * scene.bench.tolerance();
  EXPECT_NEAR(scene.bench.v[0].x, 1, eps);
  EXPECT_NEAR(scene.bench.v[0].y, 0, eps);
  // then the belt leaves sideways: relative speed (1, -1), deceleration mu g along it
  for (int n = 0; n < 10; ++n) scene.step(0.01);
  const double lost = 0.3 * 10 * 0.1 / std::sqrt(2.0);
  EXPECT_NEAR(scene.bench.v[0].x, 1 - lost, 0.02 + eps);
  EXPECT_NEAR(scene.bench.v[0].y, lost, 0.02 + eps);
}

/// Before the first and after the last row it stands; the lift is that of the rows in between.
TEST_P(SurfacePoses, ItLiftsByTheRowsAndStandsOutsideOfThem) {
  RigidSurface lift = floor_of();
  lift.poses = {at(0.2, {}), at(0.4, {0, 0, 0.1}), at(0.5, {0, 0, 0.4})};
  SurfaceScene scene(GetParam(), {{1, 1, 0}}, lift);
  scene.gravity = {0, 0, -200};
  const double eps = 50 * scene.bench.tolerance();
  for (int n = 0; n < 100; ++n) {
    scene.step(0.01);
    const double t = 0.01 * (n + 1);
    const double z = t < 0.2 ? 0 : t < 0.4 ? 0.5 * (t - 0.2) : t < 0.5 ? 0.1 + 3 * (t - 0.4) : 0.4;
    if (t > 0.505 && t < 0.56) continue;  // it flies off at the stop
    EXPECT_NEAR(scene.position(0).z, z, eps) << t;
  }
}

TEST_P(SurfacePoses, WorkIsTheEnergyOfTheNodes) {
  RigidSurface rough = floor_of();
  rough.friction = 0.2;
  rough.poses = {at(0, {}), at(0.5, {0.1, 0, 0.25}, {0.1, 0, 0.2}), at(1, {0.3, 0, 0.5}, {0, 0.1, 0.4})};
  SurfaceScene scene(GetParam(), {{1, 1, 0.1}, {2, 1.5, 0.2}}, rough, 2);
  scene.bench.v[1] = {0.5, 0, -1};
  expect_work_to_be_the_energy_of_the_nodes(scene, 50);
}

TEST_P(SurfacePoses, RestartGivesTheSameBits) {
  RigidSurface rough = floor_of();
  rough.friction = 0.2;
  rough.poses = {at(0, {}), at(0.5, {0.1, 0, 0.25}, {0.1, 0, 0.2}), at(1, {0.3, 0, 0.5}, {0, 0.1, 0.4})};
  const std::vector<Vec3<double>> X{{1, 1, 0.1}, {2, 1.5, 0.2}, {3, 3, 0.05}};
  expect_same_bits_after_restart(GetParam(), model_of(X, rough));
}

/// A checkpoint of another motion must not be taken.
TEST(SurfacePoseHash, EveryNumberOfTheTableCounts) {
  Model model = model_of({{1, 1, 1}}, floor_of());
  const auto none = model_hash(model);
  model.surfaces[0].poses = {at(0, {}), at(1, {1, 0, 0})};
  const auto hash = model_hash(model);
  EXPECT_NE(hash, none);
  for (const auto spoil : {+[](RigidPose& p) { p.time = 2; }, +[](RigidPose& p) { p.shift.y = 1e-9; },
                           +[](RigidPose& p) {
                             p.turn = quaternion_of({0, 0, 1e-9});
                           }}) {
    Model other = model;
    spoil(other.surfaces[0].poses[1]);
    EXPECT_NE(model_hash(other), hash);
  }
}

}  // namespace
}  // namespace glisson::contact
