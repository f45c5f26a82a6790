// Penalty response of rigid surfaces with free nodes, against what is known in closed form.
#include "tests/contact/surface_scene.hpp"

namespace glisson::contact {
namespace {

using SurfacePenalties = BenchTest;
GLISSON_BENCH_CASES(SurfacePenalties);

RigidSurface soft_floor(double share, double slope = 0) {
  RigidSurface floor = floor_of(4, slope);
  floor.penalty = share;
  return floor;
}

/// A node at rest carries its weight at the depth g dt^2 (1 / s - 1), none at s = 1, whatever its mass.
TEST_P(SurfacePenalties, ANodeRestsAtTheDepthOfItsWeight) {
  const double dt = 0.01, g = 10;
  for (const double share : {0.1, 0.5, 1.0})
    for (const double mass : {0.01, 3.0}) {
      SurfaceScene scene(GetParam(), {{1, 1, 0.01}}, soft_floor(share), mass);
      scene.gravity = {0, 0, -g};
      for (int n = 0; n < 1000; ++n) scene.step(dt);
      EXPECT_NEAR(scene.position(0).z, -g * dt * dt * (1 / share - 1), 1e3 * scene.bench.tolerance());
      EXPECT_NEAR(scene.report().force.z, mass * g, 1e4 * mass * scene.bench.tolerance());
    }
}

/// x(n+1) = (1 - s)(2 x(n) - x(n-1)) below the floor: the node comes back slower by what its damping takes.
TEST_P(SurfacePenalties, AnImpactLosesWhatTheLawSays) {
  const double share = 0.2, dt = 0.01, v = 1;
  SurfaceScene scene(GetParam(), {{1, 1, 0.5 * v * dt}}, soft_floor(share));
  scene.bench.v[0] = {0, 0, -v};
  double before = 0.5 * v * dt, x = (1 - share) * (before - v * dt);
  while (x < 0) {
    const double next = 2 * x - before;
    before = x;
    x = next < 0 ? (1 - share) * next : next;
  }
  const double bounce = (x - before) / dt;
  for (int n = 0; n < 60; ++n) scene.step(dt);
  EXPECT_GT(bounce, 0.3);
  EXPECT_LT(bounce, 0.9);
  EXPECT_NEAR(scene.bench.v[0].z, bounce, 100 * scene.bench.tolerance());
  EXPECT_GT(scene.position(0).z, 0);
}

TEST_P(SurfacePenalties, ANodeSlipsOnASlopeAboveItsFrictionAngleOnly) {
  const double slope = 0.4, tangent = std::tan(slope), length = 0.5;
  const Vec3<double> start{length * std::cos(slope), 1.3, -length * std::sin(slope)};
  for (const double mu : {1.2 * tangent, 0.5 * tangent}) {
    RigidSurface floor = soft_floor(0.3, slope);
    floor.friction = mu;
    SurfaceScene scene(GetParam(), {start}, floor);
    scene.gravity = {0, 0, -10};
    const double dt = 0.005;
    for (int n = 0; n < 100; ++n) scene.step(dt);
    const Vec3<double> gone = scene.bench.u[0];
    const double slipped = gone.x * std::cos(slope) - gone.z * std::sin(slope), t = 100 * dt;
    const double expected = mu > tangent ? 0 : 5 * (std::sin(slope) - mu * std::cos(slope)) * t * t;
    // until the force has built up it slips a little
    EXPECT_NEAR(slipped, expected, 0.01 * expected + 1e-3) << mu;
    const double again = slipped;
    for (int n = 0; mu > tangent && n < 100; ++n) scene.step(dt);
    const Vec3<double> later = scene.bench.u[0];
    if (mu > tangent) {
      EXPECT_NEAR(later.x * std::cos(slope) - later.z * std::sin(slope), again,
                  1e2 * scene.bench.tolerance());
    }
  }
}

TEST_P(SurfacePenalties, WorkIsTheEnergyOfTheNodes) {
  RigidSurface rough = soft_floor(0.4);
  rough.friction = 0.2;
  rough.displacement = {0.3, 0, 0.5};
  SurfaceScene scene(GetParam(), {{1, 1, 0.1}, {2, 1.5, 0.2}}, rough, 2);
  scene.bench.v[1] = {0.5, 0, -1};
  expect_work_to_be_the_energy_of_the_nodes(scene, 50);
}

TEST_P(SurfacePenalties, RestartGivesTheSameBits) {
  RigidSurface rough = soft_floor(0.4);
  rough.friction = 0.2;
  rough.displacement = {0.3, 0, 0.5};
  const std::vector<Vec3<double>> X{{1, 1, 0.1}, {2, 1.5, 0.2}, {3, 3, 0.05}};
  expect_same_bits_after_restart(GetParam(), model_of(X, rough));
}

}  // namespace
}  // namespace glisson::contact
