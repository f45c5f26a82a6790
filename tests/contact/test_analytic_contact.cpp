// Rigid bodies as providers: nodes end each step on the surface, with work, report and restart.
#include <glisson/contact/analytic/body_overlap.hpp>

#include <cmath>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/box_mesh.hpp>

#include "tests/contact/free_nodes.hpp"

namespace glisson::contact {
namespace {

using RigidContacts = BenchTest;
GLISSON_BENCH_CASES(RigidContacts);

using Scene = FreeNodes;

RigidBody pressing_plate() {  // front along -z, comes down from z = 1 to z = 0.5
  RigidBody plate;
  plate.name = "compression plate";
  plate.corners = {{{0, 0, 1}, {0, 4, 1}, {4, 0, 1}}};
  plate.displacement = {0, 0, -0.5};
  plate.motion = {LoadShape::ramp, 0, 1};
  plate.nodes = {0, 1, 2};
  return plate;
}

TEST_P(RigidContacts, NodesEndEachStepOnTheMovingPlate) {
  Model model;
  model.mesh.X = {
      {1, 1, 0.97}, {2, 1, 0.2}, {5, 1, 0.97}, {1, 2, 0.97}};  // touched, too low, beside it, not listed
  model.bodies = {pressing_plate()};
  Scene scene(GetParam(), model, 0.125);
  const double eps = 4 * scene.bench.tolerance();
  for (int n = 1; n <= 10; ++n) {
    scene.step(0.1);
    // once touched, the node keeps the plate's speed and stays on it
    EXPECT_NEAR(scene.position(0).z, std::min(0.97, 1 - 0.05 * n), eps);
    EXPECT_NEAR(scene.bench.v[0].z, n == 1 ? -0.2 : -0.5, 10 * eps);
  }
  for (const int n : {1, 2, 3}) expect_near(scene.bench.u[std::size_t(n)], {}, 0);
}

RigidBody upright_probe(std::vector<int> nodes) {  // radius 1, centre of the tip at z = 3
  RigidBody probe;
  probe.shape = RigidShape::probe;
  probe.axis = {0, 0, 1};
  probe.radius = 1;
  probe.length = 3;
  probe.nodes = std::move(nodes);
  return probe;
}

TEST_P(RigidContacts, TheProbePushesNodesToItsSurface) {
  Model model;
  model.mesh.X = {{0.3, 0.4, 2}, {0, 0.1, 3.5}, {0, 0, 3}, {3, 3, 3}};
  model.bodies = {upright_probe({0, 1, 2, 3})};
  Scene scene(GetParam(), model, 3);
  const double eps = 4 * scene.bench.tolerance();
  scene.step(0.1);
  expect_near(scene.position(0), {0.6, 0.8, 2}, eps);
  const auto tip = scene.position(1) - Vec3<double>{0, 0, 3};
  EXPECT_NEAR(std::sqrt(dot(tip, tip)), 1, eps);
  expect_near(scene.position(3), {3, 3, 3}, 0);
  EXPECT_EQ(scene.report().node_count, 3);
  EXPECT_NEAR(scene.report().depth, 1, eps);  // of the state before the step: the node on the axis
  scene.step(0.1);
  EXPECT_LT(scene.report().depth, eps);
  EXPECT_NEAR(scene.report().largest_depth, 1, eps);
}

TEST_P(RigidContacts, AGrowingCylinderPushesOutwards) {
  Model model;
  model.mesh.X = {{1.25, 0, 1}};
  RigidBody cylinder;
  cylinder.shape = RigidShape::cylinder;
  cylinder.axis = {0, 0, 1};
  cylinder.radius = 1;
  cylinder.length = 2;
  cylinder.radius_change = 1;
  cylinder.motion = {LoadShape::ramp, 0, 1};
  cylinder.nodes = {0};
  model.bodies = {cylinder};
  Scene scene(GetParam(), model);
  for (int n = 0; n < 8; ++n) scene.step(0.125);
  EXPECT_NEAR(scene.position(0).x, 2, 4 * scene.bench.tolerance());
}

/// A free mass that a plate sets in motion: the work of the plate is its kinetic energy, at every step.
TEST_P(RigidContacts, WorkIsTheEnergyOfTheNodes) {
  Model model;
  model.mesh.X = {{1, 1, 0.93}, {1, 2, 0.8}, {2, 1, 0.99}};
  model.bodies = {pressing_plate()};
  model.bodies[0].motion = {LoadShape::poly345, 0, 1};
  model.bodies[0].friction = 0.3;
  Scene scene(GetParam(), model, 2);
  scene.bench.v[1] = {0.2, 0, 0.5};
  expect_work_to_be_the_energy_of_the_nodes(scene, 20);
  EXPECT_GT(scene.rigid->work(), 0.1);
}

RigidBody table() {  // front along +z at z = 0
  RigidBody plate;
  plate.name = "table";
  plate.corners = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  return plate;
}

/// At the surface at a tenth of the run, at the same speed all the way.
TEST_P(RigidContacts, ANodeThatStartsInsideComesOutEvenly) {
  const double depth = 0.002;
  Model model;
  model.mesh.X = {{1, 1, -depth}};
  model.bodies = {table()};
  model.bodies[0].nodes = {0};
  model.time.total = 1;
  Scene scene(GetParam(), model);
  const double eps = scene.bench.tolerance();
  for (int n = 1; n <= 20; ++n) {
    scene.step(0.01);
    EXPECT_NEAR(scene.position(0).z, depth * (0.1 * n - 1), eps) << n;
    EXPECT_NEAR(scene.bench.v[0].z, 10 * depth, 200 * eps) << n;  // in one step: ten times as fast
  }
  EXPECT_NEAR(scene.report().start_depth, depth, eps);
}

TEST_P(RigidContacts, ASlidingNodeStopsAfterItsStoppingDistance) {
  Model model;
  model.mesh.X = {{0.5, 1.3, 0}};
  model.bodies = {table()};
  model.bodies[0].nodes = {0};
  model.bodies[0].friction = 0.3;
  Scene scene(GetParam(), model, 2.5);
  scene.gravity = {0, 0, -10};
  scene.bench.v[0] = {3, 0, 0};
  for (int n = 0; n < 1200; ++n) scene.step(0.001);
  EXPECT_NEAR(scene.bench.u[0].x, 3 * 3 / (2 * 0.3 * 10.0), 0.01 * 1.5);
  EXPECT_NEAR(scene.position(0).z, 0, 20 * scene.bench.tolerance());
}

/// A table that is pulled away below a node: with friction enough to take it along, or not, when the node
/// gets mu g.
TEST_P(RigidContacts, FrictionIsMeasuredOnTheMovingBody) {
  for (const double mu : {0.5, 0.1}) {
    Model model;
    model.mesh.X = {{1, 1, 0}};
    model.bodies = {table()};
    model.bodies[0].nodes = {0};
    model.bodies[0].friction = mu;
    model.bodies[0].displacement = {1, 0, 0};  // a = 2 m/s^2
    model.bodies[0].motion.shape = LoadShape::table;
    for (int k = 0; k <= 100; ++k) model.bodies[0].motion.table.push_back({0.01 * k, 1e-4 * k * k});
    Scene scene(GetParam(), model);
    scene.gravity = {0, 0, -10};
    for (int n = 0; n < 100; ++n) scene.step(0.01);
    EXPECT_NEAR(scene.bench.u[0].x, mu > 0.2 ? 1 : 0.5, 0.01) << mu;
  }
}

TEST_P(RigidContacts, AProbeWithFrictionTakesNodesAlong) {
  Model model;
  model.mesh.X = {{1, 0, 1}};
  RigidBody probe = upright_probe({0});
  probe.displacement = {0, 0, 1};
  probe.motion = {LoadShape::ramp, 0, 1};
  probe.friction = 3;
  model.bodies = {probe};
  Scene scene(GetParam(), model);
  scene.gravity = {-100, 0, 0};
  for (int n = 0; n < 100; ++n) scene.step(0.01);
  expect_near(scene.position(0), {1, 0, 2}, 1e-3);
}

/// Nodes 0, 1 and 2 are those of a skin, 0.1 thick.
Model skin_of(std::vector<Vec3<double>> X) {
  Model model;
  model.mesh.X = std::move(X);
  model.mesh.triangles = {{0, 1, 2}};
  ShellSection skin;
  skin.elements = {0};
  skin.thickness = {0.1};
  model.shells = {skin};
  return model;
}

TEST_P(RigidContacts, NodesOfShellsStayHalfTheThicknessAroundAProbe) {
  Model model = skin_of({{1.2, 0, 1}, {1.2, 0, 2}, {0, 1.2, 1.5}, {1.2, 0, 1.5}});
  model.bodies = {upright_probe({0, 1, 3})};
  Scene scene(GetParam(), model);
  scene.gravity = {-10, 0, 0};
  for (int n = 0; n < 100; ++n) scene.step(0.01);
  const double eps = 40 * scene.bench.tolerance();
  expect_near(scene.position(0), {1.05, 0, 1}, eps);
  expect_near(scene.position(1), {1.05, 0, 2}, eps);
  expect_near(scene.position(3), {1, 0, 1.5}, eps);
}

TEST_P(RigidContacts, NodesOfShellsStayHalfTheThicknessInFrontOfAPlate) {
  Model model = skin_of({{1, 1, 0.2}, {2, 1, 0.2}, {1, 2, 0.2}, {3, 3, 0.2}});
  model.bodies = {table()};
  model.bodies[0].nodes = {0, 1, 2, 3};
  Scene scene(GetParam(), model);
  scene.gravity = {0, 0, -10};
  for (int n = 0; n < 100; ++n) scene.step(0.01);
  for (const int n : {0, 1, 2}) EXPECT_NEAR(scene.position(n).z, 0.05, 40 * scene.bench.tolerance()) << n;
  EXPECT_NEAR(scene.position(3).z, 0, 40 * scene.bench.tolerance()) << "no shell";
}

TEST_P(RigidContacts, ReportGivesTheResultant) {
  Model model;
  model.mesh.X = {{1, 1, 1.5}, {1, 2, 0.5}, {2, 1, 1.25}};
  model.bodies = {pressing_plate()};
  Scene scene(GetParam(), model, 2);
  scene.step(0.1);
  const auto report = scene.report();
  const double kick = 0.05 * 0.1;
  EXPECT_EQ(report.node_count, 2);
  expect_near(report.force, {0, 0, -2 * (0.55 + 0.3) / kick}, 1000 * scene.bench.tolerance());
}

TEST_P(RigidContacts, RestartGivesTheSameBits) {
  Model model;
  model.mesh.X = {{1, 1, 0.93}, {1, 2, 0.8}, {2, 1, 1.004}};
  model.time.total = 8;  // the last node is behind the plate until 0.8
  model.bodies = {pressing_plate()};
  model.bodies[0].friction = 0.3;
  model.bodies[0].displacement.x = 0.1;
  expect_same_bits_after_restart(GetParam(), model, 2);
}

/// A unit cube that plates, a cylinder and a probe start in by a share of its edge.
TEST(RigidContactInput, NodesThatStartDeepInABodyAreRefused) {
  const Mesh cube = box_mesh({1, 1, 1}, {1, 1, 1}, Shape::hexahedron);
  const auto refused = [&](const RigidBody& body) -> std::string {
    try {
      start_depths(RigidMotion(body), candidate_nodes({}, cube), cube);
      return "";
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      return e.what();
    }
  };
  RigidBody body = pressing_plate();
  for (const double z : {2.0, 1.0, 0.95}) {
    for (auto& corner : body.corners) corner.z = z;
    EXPECT_EQ(refused(body), "");
  }
  for (auto& corner : body.corners) corner.z = 0.8;
  EXPECT_NE(refused(body).find("compression plate: node 4 starts 0.2 behind it"), std::string::npos)
      << refused(body);
  std::swap(body.corners[1], body.corners[2]);
  for (auto& corner : body.corners) corner.z = 2;
  EXPECT_NE(refused(body).find("exchange b and c"), std::string::npos) << "the cube is on its wrong side";
  for (const RigidShape shape : {RigidShape::cylinder, RigidShape::probe}) {
    body.shape = shape;
    body.axis = {0, 0, 1};
    body.origin = {-0.5, -0.5, -1};
    body.length = 3;
    body.radius = 0.75;
    EXPECT_EQ(refused(body), "");
    body.radius = 1;
    EXPECT_NE(refused(body).find("node 0 starts 0.292893 inside of it"), std::string::npos) << refused(body);
  }
}

/// A shell whose middle starts on a body, or nearer than half of its thickness, is not thrown off it.
TEST(RigidContactInput, ShellsThatStartNearKeepTheirGap) {
  Mesh mesh;
  mesh.X = {{1, 1, 0}, {1, 2, 0.02}, {2, 1, 0.2}, {2, 2, -0.01}};
  const auto gaps = gaps_to_keep(RigidMotion(table()), {0, 1, 2, 3}, {0.05, 0.05, 0.05, 0.05}, mesh);
  EXPECT_NEAR(gaps[0], 0, 1e-15);
  EXPECT_NEAR(gaps[1], 0.02, 1e-15);
  EXPECT_EQ(gaps[2], 0.05);
  EXPECT_EQ(gaps[3], 0);
}

TEST(RigidContactInput, AnEmptyListMeansTheSurface) {
  Mesh mesh;
  mesh.X = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}, {0.25, 0.25, 0.25}};
  for (const auto& e : {std::array{0, 1, 2, 5}, {0, 3, 1, 5}, {0, 2, 3, 5}, {1, 3, 2, 5}})
    mesh.add_element(Shape::tetrahedron, e);
  EXPECT_EQ(candidate_nodes({}, mesh), (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(candidate_nodes({4}, mesh), std::vector{4});
}

}  // namespace
}  // namespace glisson::contact
