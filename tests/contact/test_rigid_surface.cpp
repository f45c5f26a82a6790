// Rigid surface meshes: nodes end each step in front of them, friction, no tunnelling, motion, restart.
#include <numeric>
#include <random>

#include <glisson/contact/rate_distance.hpp>
#include <glisson/contact/surface/surface_overlap.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/core/mesh/surface.hpp>

#include "tests/contact/surface_scene.hpp"

namespace glisson::contact {
namespace {

using RigidSurfaces = BenchTest;
GLISSON_BENCH_CASES(RigidSurfaces);

using Scene = SurfaceScene;

TEST_P(RigidSurfaces, NodesFallOnAFloorAndStayOnIt) {
  Scene scene(GetParam(), {{1, 1, 0.3}, {2, 2, 0.1}, {3.3, 1.7, 0}, {5, 1, 0.1}, {1, 1, -3}}, floor_of());
  scene.gravity = {0, 0, -10};
  for (int n = 0; n < 100; ++n) scene.step(0.01);
  const double eps = 20 * scene.bench.tolerance();
  for (const int n : {0, 1, 2}) EXPECT_NEAR(scene.position(n).z, 0, eps) << n;
  for (const int n : {3, 4}) EXPECT_LT(scene.position(n).z, -4) << "beside and far below the floor";
  EXPECT_EQ(scene.report().node_count, 3);
  EXPECT_EQ(scene.report().search.candidates, 5);
  EXPECT_GT(scene.report().search.volumes, 32) << "boxes of as many facets";
  EXPECT_GT(scene.report().search.seconds, 0);
  expect_near(scene.report().force, {0, 0, 30}, 5000 * scene.bench.tolerance());
}

TEST_P(RigidSurfaces, ANodeSlipsOnASlopeExactlyAboveItsFrictionAngle) {
  const double slope = 0.4, tangent = std::tan(slope), length = 0.5;
  const Vec3<double> start{length * std::cos(slope), 1.3, -length * std::sin(slope)};
  for (const double mu : {1.001 * tangent, 0.999 * tangent, 0.5 * tangent}) {
    RigidSurface floor = floor_of(4, slope);
    floor.friction = mu;
    Scene scene(GetParam(), {start}, floor);
    scene.gravity = {0, 0, -10};
    const double dt = 0.005;
    const int steps = 100;
    for (int n = 0; n < steps; ++n) scene.step(dt);
    const Vec3<double> gone = scene.bench.u[0];
    const double slipped = gone.x * std::cos(slope) - gone.z * std::sin(slope), t = steps * dt;
    const double expected = mu > tangent ? 0 : 5 * (std::sin(slope) - mu * std::cos(slope)) * t * t;
    EXPECT_NEAR(slipped, expected, 0.002 * expected + 20 * scene.bench.tolerance()) << mu;
    EXPECT_NEAR(gone.x * std::sin(slope) + gone.z * std::cos(slope), 0, 20 * scene.bench.tolerance());
  }
}

TEST_P(RigidSurfaces, ASlidingNodeStopsAfterItsStoppingDistance) {
  RigidSurface floor = floor_of();
  floor.friction = 0.3;
  Scene scene(GetParam(), {{0.5, 1.3, 0}}, floor, 2.5);
  scene.gravity = {0, 0, -10};
  scene.bench.v[0] = {3, 0, 0};
  for (int n = 0; n < 1200; ++n) scene.step(0.001);
  EXPECT_NEAR(scene.bench.u[0].x, 3 * 3 / (2 * 0.3 * 10.0), 0.01 * 1.5);
  const double at_rest = scene.bench.u[0].x;
  for (int n = 0; n < 100; ++n) scene.step(0.001);
  EXPECT_NEAR(scene.bench.u[0].x, at_rest, 20 * scene.bench.tolerance());
}

/// Through a thin closed body in one step, 40 to 80 of its thicknesses far: stopped at the face that it
/// entered.
TEST_P(RigidSurfaces, AFastNodeDoesNotTunnel) {
  const Mesh slab = box_mesh({4, 4, 1}, {4, 4, 0.1}, Shape::hexahedron, 0);
  RigidSurface surface;
  surface.surface = {slab.X, outer_surface(slab)};
  Scene scene(GetParam(), {{1.01, 2.02, 1.5}, {3, 1, 4}, {1, 1, -1.3}}, surface);
  scene.bench.v = {{0, 0, -40}, {0, 0, -80}, {0, 0, 30}};
  for (int n = 0; n < 3; ++n) scene.step(0.1);
  const double eps = 50 * scene.bench.tolerance();
  EXPECT_NEAR(scene.position(0).z, 0.1, eps);
  EXPECT_NEAR(scene.position(1).z, 0.1, eps);
  EXPECT_NEAR(scene.position(2).z, 0, eps);
}

/// Eq. 5.19-5.22: within the rate distance a free approach keeps the share gap / distance of its speed, where
/// the gap is the one that it would reach; the node ends in front of the surface and rests.
TEST_P(RigidSurfaces, AnApproachIsSlowedInFrontOfTheSurface) {
  const double close = 0.1, dt = 0.01, v = 0.5;
  RigidSurface floor = floor_of();
  floor.distance = close;
  Scene scene(GetParam(), {{1, 1, 0.1075}}, floor);
  scene.bench.v[0] = {0.2, 0, -v};
  double gap = 0.1075, speed = v;
  for (int n = 0; n < 200; ++n) {
    const double predicted = gap - speed * dt;
    if (predicted < close) speed *= predicted / close;
    gap -= speed * dt;
    scene.step(dt);
    ASSERT_NEAR(scene.position(0).z, gap, 30 * scene.bench.tolerance()) << n;
  }
  EXPECT_GT(scene.position(0).z, 0);
  EXPECT_NEAR(scene.bench.v[0].x, 0.2, 20 * scene.bench.tolerance()) << "no friction";
  EXPECT_EQ(scene.report().largest_depth, 0);
}

/// A surface that rises at the node does the same as one that the node falls on; one that sinks pulls not.
TEST_P(RigidSurfaces, AMovingSurfaceSlowsWhatIsInFrontOfIt) {
  const double close = 0.1, dt = 0.01, v = 0.5;
  RigidSurface rising = floor_of();
  rising.distance = close;
  rising.displacement = {0, 0, v};
  Scene scene(GetParam(), {{1, 1, 0.1075}, {2, 2, 3}}, rising);
  double gap = 0.1075, speed = v;
  for (int n = 0; n < 90; ++n) {
    const double predicted = gap - speed * dt;
    if (predicted < close) speed *= predicted / close;
    gap -= speed * dt;
    scene.step(dt);
    ASSERT_NEAR(scene.position(0).z, gap + v * dt * (n + 1), 30 * scene.bench.tolerance()) << n;
  }
  EXPECT_EQ(scene.bench.u[1].z, 0);
  RigidSurface sinking = floor_of();
  sinking.distance = close;
  sinking.displacement = {0, 0, -v};
  Scene left(GetParam(), {{1, 1, 0.01}}, sinking);
  for (int n = 0; n < 90; ++n) left.step(dt);
  EXPECT_EQ(left.bench.u[0].z, 0);
}

/// At rest the node presses with its weight and sinks to the surface, never behind it; friction holds it.
TEST_P(RigidSurfaces, WhatIsSlowedPressesAndRubs) {
  RigidSurface floor = floor_of();
  floor.distance = 0.1;
  floor.friction = 0.3;
  Scene scene(GetParam(), {{1, 1, 0.05}}, floor, 2);
  scene.gravity = {2, 0, -10};
  double last = 1;
  for (int n = 0; n < 1000; ++n) {
    scene.step(0.01);
    ASSERT_LE(scene.position(0).z, last + scene.bench.tolerance());
    last = scene.position(0).z;
  }
  // the gap that slows is that at the end of a free step: a node rests where such a step ends at the surface
  const double rest = 10 * 0.01 * 0.01;
  EXPECT_NEAR(last, rest, 0.01 * rest);
  EXPECT_NEAR(scene.report().force.z, 20, 0.2);
  EXPECT_LT(scene.bench.u[0].x, 0.02) << "until it presses it slips a little; freely 25";
}

TEST_P(RigidSurfaces, AMovingSurfaceTakesNodesAlong) {
  RigidSurface turning = floor_of();
  turning.friction = 100;
  turning.angles = {0, 0, 1};
  turning.centre = {2, 2, 0};
  Scene scene(GetParam(), {{3, 2, 0}, {2, 3, 0}}, turning);
  scene.gravity = {0, 0, -1000};
  for (int n = 0; n < 100; ++n) scene.step(0.01);
  const double eps = 3e3 * scene.bench.tolerance() + 1e-4;
  expect_near(scene.position(0), {2 + std::cos(1.0), 2 + std::sin(1.0), 0}, eps);
  expect_near(scene.position(1), {2 - std::sin(1.0), 2 + std::cos(1.0), 0}, eps);

  RigidSurface rising = floor_of();
  rising.displacement = {0, 0, 0.5};
  Scene lift(GetParam(), {{1, 1, 0.1}}, rising);
  for (int n = 0; n < 100; ++n) lift.step(0.01);
  EXPECT_NEAR(lift.position(0).z, 0.5, 20 * lift.bench.tolerance());
  EXPECT_NEAR(lift.bench.v[0].z, 0.5, 2000 * lift.bench.tolerance());
}

TEST_P(RigidSurfaces, WorkIsTheEnergyOfTheNodes) {
  RigidSurface rough = floor_of();
  rough.friction = 0.2;
  rough.displacement = {0.3, 0, 0.5};
  Scene scene(GetParam(), {{1, 1, 0.1}, {2, 1.5, 0.2}}, rough, 2);
  scene.bench.v[1] = {0.5, 0, -1};
  expect_work_to_be_the_energy_of_the_nodes(scene, 50);
}

TEST_P(RigidSurfaces, RestartGivesTheSameBits) {
  RigidSurface rough = floor_of();
  rough.distance = 0.05;
  rough.friction = 0.2;
  rough.displacement = {0.3, 0, 0.5};
  const std::vector<Vec3<double>> X{{1, 1, 0.1}, {2, 1.5, 0.2}, {3, 3, 0.05}};
  expect_same_bits_after_restart(GetParam(), model_of(X, rough));
}

/// Around a whole sphere the signed distance has the right sign and size, in cavities too.
TEST(SurfaceShapes, TellInsideFromOutsideEverywhere) {
  const auto data = surface_data(surface_of(sphere({}, 1, 24, 32)).surface, {});
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    const Vec3<double> d = unit_or(Vec3<double>{normal(random), normal(random), normal(random)}, {});
    const double facet_sag = 0.02;  // how far the faces lie inside of the sphere
    for (const double r : {0.9, 0.95, 1.0001, 1.1}) {
      const auto p = data.shape()(r * d, r * d);
      if (r > 1)
        EXPECT_EQ(p.depth, 0);
      else
        EXPECT_NEAR(p.depth, 1 - r, facet_sag);
    }
  }
}

void expect_refused(const RigidSurface& surface, const std::vector<Vec3<double>>& X,
                    const std::string& word) {
  Mesh mesh;
  mesh.X = X;
  std::vector<int> nodes(X.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  try {
    start_depths(surface, surface_data(surface.surface, surface.centre), nodes, std::vector<double>(X.size()),
                 mesh);
    EXPECT_TRUE(word.empty()) << "taken, but: " << word;
  } catch (const Error& e) {
    EXPECT_FALSE(word.empty()) << "refused: " << e.what();
    EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
    EXPECT_EQ(e.place().element, surface.name);
  }
}
void expect_taken(const RigidSurface& surface, const std::vector<Vec3<double>>& X) {
  expect_refused(surface, X, "");
}
RigidSurface turned(RigidSurface surface) {
  for (Facet& facet : surface.surface.facets) std::swap(facet.nodes[0], facet.nodes[1]);
  return surface;
}

TEST(SurfaceStart, NodesBehindAreRefused) {
  const RigidSurface floor = floor_of();
  expect_taken(floor, {{1, 1, 0}, {1, 2, 1}});
  expect_refused(floor, {{1, 1, 0}, {1, 2, -0.2}}, "node 1 starts 0.2 behind");
  expect_taken(floor, {{1, 1, 1}, {6, 1, -0.1}});
  expect_taken(floor, {{1, 1, 1}, {1, 1, -30}});
}

/// Two facets may be far larger than what stands on them: how deep is too deep follows from its elements.
TEST(SurfaceStart, NodesDeepInALargeFloorAreRefused) {
  RigidSurface floor = floor_of(1);
  Mesh mesh = box_mesh({4, 4, 4}, {0.1, 0.1, 0.1}, Shape::hexahedron);
  const auto refused = [&](double depth) {
    Mesh moved = mesh;
    for (auto& X : moved.X) X = X + Vec3<double>{1, 1, -depth};
    std::vector<int> nodes(moved.X.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    try {
      start_depths(floor, surface_data(floor.surface, {}), nodes, std::vector<double>(nodes.size()), moved);
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("behind the surface"), std::string::npos) << e.what();
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refused(0.002));
  EXPECT_TRUE(refused(0.003));
  EXPECT_TRUE(refused(0.06));
}

/// A block of one layer, 0.1 thick, with edges of 0.2 above a floor: slowed from farther away than half of
/// its edges, its far side would be held too.
TEST(SurfaceStart, RateDistancesAreBoundedByTheBodysEdges) {
  Model model = model_of({}, floor_of(1));
  model.mesh = box_mesh({4, 4, 1}, {0.8, 0.8, 0.1}, Shape::hexahedron);
  const auto refused = [&]() -> std::string {
    try {
      EXPECT_EQ(rate_distances(model)[0], model.surfaces[0].distance.value_or(*model.contact.distance));
      return "";
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      return e.what();
    }
  };
  model.contact.distance = 0.099;
  EXPECT_EQ(refused(), "");
  model.contact.distance = 1;
  EXPECT_NE(
      refused().find("test surface: it slows approaches below 1 (RateConstraintDistance of SystemParams, "
                     "by default ten times ContactSafetyMargin), too much for surface edges of 0.2"),
      std::string::npos)
      << refused();
  model.surfaces[0].distance = 0.099;
  EXPECT_EQ(refused(), "");
  for (auto& X : model.mesh.X) X = X + Vec3<double>{1, 1, 1};
  model.surfaces[0].distance = 0.1;
  EXPECT_EQ(refused(), "") << "half of an edge, but for rounding";
  model.surfaces[0].distance = 0.101;
  EXPECT_NE(refused().find("below 0.101 (RateConstraintDistance), too much"), std::string::npos) << refused();
  model.surfaces[0].penalty = default_penalty;
  EXPECT_EQ(rate_distances(model)[0], 0) << "penalties do not slow what is in front";
}

/// A body that lies wholly behind would be thrown to the front when it comes near: at any distance.
TEST(SurfaceStart, SurfacesThatFaceAwayFromTheBodyAreRefused) {
  const RigidSurface floor = floor_of(), ball = surface_of(sphere({}, 1, 24, 32));
  for (const double far : {0.3, 5.0, 300.0}) {
    expect_refused(turned(floor), {{1, 1, far}, {1, 2, far + 1}}, "no node starts in front of it");
    expect_taken(turned(floor), {{1, 1, -far}, {1, 2, -far - 1}});
    expect_taken(ball, {{0, 0, 1 + far}, {0, 1, 1 + far}});
    expect_refused(turned(ball), {{0, 0, 1 + far}, {0, 1, 1 + far}}, "no node starts in front of it");
  }
}

TEST(SurfaceStart, AClosedSurfaceHasAnInsideAtAnyDepth) {
  const RigidSurface ball = surface_of(sphere({}, 10, 48, 64));  // far larger than its facets
  const std::vector<Vec3<double>> inside{{0, 0, 0.1}, {2, 1, 0}}, both{{0, 0, 0.1}, {20, 1, 0}};
  expect_refused(ball, inside, "no node starts in front of it");
  expect_refused(ball, both, "too deep to be let out");
  expect_taken(turned(ball), inside);
  expect_refused(turned(ball), both, "too deep to be let out");
}

/// Two cones whose tips are one node: beside the tips, and in the cones, the side is that of the nearer one.
TEST(SurfaceStart, PartsThatMeetAtANodeHaveTheirOwnSides) {
  TriangleSurface cones;
  cones.x.push_back({});
  for (const double side : {-1.0, 1.0}) {
    const int first = static_cast<int>(cones.x.size());
    for (int k = 0; k < 12; ++k) cones.x.push_back({std::cos(k * 0.5236), std::sin(k * 0.5236), side});
    for (int k = 0; k < 12; ++k) {
      const int a = first + k, b = first + (k + 1) % 12;
      cones.triangles.push_back(side < 0 ? Triangle{0, a, b} : Triangle{0, b, a});
    }
  }
  const auto data = surface_data(surface_of(cones).surface, {});
  for (const double far : {0.01, 0.2}) {
    EXPECT_EQ(data.shape()({far, 0.3 * far, 0.1 * far}, {far, 0.3 * far, 0.1 * far}).depth, 0);
    for (const double side : {-1.0, 1.0}) {
      const Vec3<double> in{0.1 * far, 0.05 * far, side * far};
      EXPECT_GT(data.shape()(in, in).depth, 0.4 * far);
    }
  }
}

}  // namespace
}  // namespace glisson::contact
