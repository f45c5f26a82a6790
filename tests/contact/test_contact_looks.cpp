// How often the host looks where the bodies are, and what the answer rests on.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/contact/bodies.hpp"
#include "tests/support/same_bits.hpp"

namespace glisson::test {
namespace {

constexpr Case emulated{"EmulatedFloat", "emulated", Precision::single_precision};
constexpr Case serial_float{"SerialFloat", "serial", Precision::single_precision};

/// A block that comes down on another one by some 0.006 edge lengths a step.
Model landing_block(Shape shape = Shape::hexahedron) {
  Model model;
  const Material rubber{"NH", mu_kappa(1e4, 0.3), 1000};
  add_body(model, box_mesh({6, 6, 2}, {0.06, 0.06, 0.02}, Shape::tetrahedron), Formulation::t4, rubber);
  Mesh upper = box_mesh({4, 4, 2}, {0.04, 0.04, 0.02}, shape);
  move(upper, {0.011, 0.012, 0.0202});
  const Body block =
      add_body(model, upper, shape == Shape::hexahedron ? Formulation::h8 : Formulation::t4, rubber);
  model.initial_velocities.push_back({block.nodes(), {0.05, 0.02, -0.06}});
  model.contact.between_bodies = true;
  model.contact.friction = 0.3;
  model.time.total = 1;
  return model;
}

const ContactSearchReport& search_of(const std::vector<NamedContact>& contacts) {
  return contacts.back().report.search;
}

void expect_near(const AnySimulation& one, const AnySimulation& other, double tolerance) {
  const auto a = one.displacement(), b = other.displacement();
  for (std::size_t n = 0; n < a.size(); ++n) {
    const auto apart = a[n] - b[n];
    EXPECT_LT(std::sqrt(dot(apart, apart)), tolerance) << "node " << n;
  }
}

TEST(ContactLooks, OfADeviceAreFewAndChangeNothingThatMatters) {
  const Model model = landing_block();
  auto device = simulate(model, emulated), host = simulate(model, serial_float);
  device->step(48), host->step(48);
  const auto seldom = device->contacts(), always = host->contacts();
  EXPECT_EQ(search_of(always).looks, 48);
  EXPECT_LT(search_of(seldom).looks, 24);
  EXPECT_GT(search_of(seldom).searches, 1) << "nothing moved";
  EXPECT_NE(device->energies().contact, 0) << "nothing touched";
  expect_near(*device, *host, 1e-7);
}

TEST(ContactLooks, OfADeviceGiveTetrahedraTheSamePlaces) {
  const Model model = landing_block(Shape::tetrahedron);
  auto device = simulate(model, {"EmulatedDouble", "emulated", Precision::double_precision}),
       host = simulate(model, serial_double);
  device->step(200), host->step(200);
  EXPECT_GT(search_of(host->contacts()).searches, 3) << "nothing moved";
  EXPECT_NE(host->energies().contact, 0) << "nothing touched";
  expect_near(*device, *host, 1e-12);
}

/// A plate 0.6 edges over a block, both at rest until `start`.
Model resting_plate(double start) {
  Model model;
  const Material soft{"NH", {2000, 20000}, 1000};
  Mesh lower = box_mesh({5, 5, 2}, {0.05, 0.05, 0.02}, Shape::tetrahedron);
  add_body(model, lower, Formulation::t4, soft);
  Mesh upper = box_mesh({4, 4, 1}, {0.04, 0.04, 0.01}, Shape::tetrahedron);
  move(upper, {0.0053, 0.0047, 0.026});
  const Body plate = add_body(model, upper, Formulation::t4, soft);
  std::vector<int> floor;
  for (int n = 0; n < plate.first_node; ++n)
    if (model.mesh.X[std::size_t(n)].z == 0) floor.push_back(n);
  model.fixed.push_back({floor, 7});
  model.contact.between_bodies = true;
  model.time.total = start + 0.03;
  return model;
}
std::vector<int> nodes_above(double z, const Model& model) {
  std::vector<int> nodes;
  for (int n = 0; n < model.mesh.node_count(); ++n)
    if (model.mesh.X[std::size_t(n)].z > z) nodes.push_back(n);
  return nodes;
}
double deepest_of(const Model& model, const Case& its) {
  auto simulation = simulate(model, its);
  while (!simulation->finished()) simulation->step(1);
  EXPECT_NE(simulation->energies().contact, 0) << "nothing touched";
  return simulation->contacts().back().report.largest_depth;
}

/// It jumps by 0.9 edges in one step, or starts with a fifth of the speed of sound, which presses it in
/// deeper. Devices are told what is prescribed.
TEST(ContactLooks, SeeAToolThatStartsAllOfASudden) {
  for (const auto& [time, share] : {std::pair{1e-4, 0.05}, {9e-3, 0.15}}) {
    Model model = resting_plate(0.02);
    PrescribedDisplacement jump;
    jump.nodes = nodes_above(0.025, model);
    jump.axes = 4;
    jump.values = {-0.009};
    jump.curve = {LoadShape::table, 0, 1, false, {{0.02, 0}, {0.02 + time, 1}}};
    model.displacements.push_back(jump);
    for (const Case& its : {serial_float, emulated})
      EXPECT_LT(deepest_of(model, its), share * 0.01) << its.name << ", " << time;
  }
}

/// The same after a first step that brings it there from far off, and so leaves room for some edges.
TEST(ContactLooks, SeeAToolThatStartsAgain) {
  Model model = resting_plate(0.02);
  const std::vector<int> plate = nodes_above(0.025, model);
  for (const int n : plate) model.mesh.X[std::size_t(n)].z += 0.01;
  model.displacements.push_back({plate, 4, {-0.01}, step_curve(1)});
  model.displacements.push_back(
      {plate, 4, {-0.009}, {LoadShape::table, 0, 1, false, {{0.02, 0}, {0.0201, 1}}}});
  for (const Case& its : {serial_float, emulated}) EXPECT_LT(deepest_of(model, its), 0.05 * 0.01) << its.name;
}

/// Some kilopascals on it, in the middle of the run or from its beginning on.
TEST(ContactLooks, SeeWhatAForceStartsAllOfASudden) {
  for (const auto& [start, pressure] : {std::pair{0.02, 4000.0}, {0.0, 1500.0}}) {
    Model model = resting_plate(start);
    NodalForce push;
    push.nodes = nodes_above(0.035, model);
    push.axes = 4;
    push.values = {-pressure * 0.04 * 0.04 / double(push.nodes.size())};
    push.curve = {LoadShape::table,
                  0,
                  1,
                  false,
                  {{start, start > 0 ? 0 : 1}, {start + 1e-4, 1}, {start + 5e-3, 1}, {start + 5.1e-3, 0}}};
    model.forces.push_back(push);
    for (const Case& its : {serial_float, emulated})
      EXPECT_LT(deepest_of(model, its), 0.15 * 0.01) << its.name << ", " << start;
  }
}

TEST(ContactLooks, AResumedRunLooksInTheSameSteps) {
  for (const int before : {6, 9, 13}) {
    for (const Case& its : {emulated, serial_float}) {
      const auto [whole, resumed] =
          expect_same_bits_resumed(landing_block(Shape::tetrahedron), its, before, 16);
      EXPECT_NE(whole->energies().contact, 0) << "nothing touched";
    }
  }
}

/// Pressed by something rigid, nodes would move far without it: that is not how far they move.
TEST(ContactLooks, ANodeHeldByARigidBodyDoesNotMove) {
  Model model = landing_block();
  model.initial_velocities.clear();
  std::vector<int> floor;
  for (int n = 0; n < model.mesh.node_count(); ++n)
    if (model.mesh.X[std::size_t(n)].z == 0) floor.push_back(n);
  model.fixed.push_back({floor, 7});
  RigidBody plate;
  plate.corners = {Vec3<double>{-1, -1, 0.0405}, Vec3<double>{-1, 1, 0.0405}, Vec3<double>{1, -1, 0.0405}};
  plate.displacement = {0, 0, -0.012};
  plate.motion = smooth_curve(0.2);
  model.bodies = {plate};
  model.time.total = 0.2;
  model.time.damping = 100;
  auto simulation = simulate(model, serial_float);
  simulation->step(1);
  const double first = double(search_of(simulation->contacts()).candidates);
  while (!simulation->finished()) simulation->step(100);
  EXPECT_LT(double(search_of(simulation->contacts()).candidates), 1.5 * first)
      << "candidates for farther nodes than any that move";
  EXPECT_GT(simulation->contacts().back().report.node_count, 10);
}

}  // namespace
}  // namespace glisson::test
