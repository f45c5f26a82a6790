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
Model landing_block() {
  Model model;
  const Material rubber{"NH", mu_kappa(1e4, 0.3), 1000};
  add_body(model, box_mesh({6, 6, 2}, {0.06, 0.06, 0.02}, Shape::tetrahedron), Formulation::t4, rubber);
  Mesh upper = box_mesh({4, 4, 2}, {0.04, 0.04, 0.02}, Shape::hexahedron);
  move(upper, {0.011, 0.012, 0.0202});
  const Body block = add_body(model, upper, Formulation::h8, rubber);
  model.initial_velocities.push_back({block.nodes(), {0.05, 0.02, -0.06}});
  model.contact.between_bodies = true;
  model.contact.friction = 0.3;
  model.time.total = 1;
  return model;
}

const ContactSearchReport& search_of(const std::vector<NamedContact>& contacts) {
  return contacts.back().report.search;
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
  const auto a = device->displacement(), b = host->displacement();
  for (std::size_t n = 0; n < a.size(); ++n) {
    const auto apart = a[n] - b[n];
    EXPECT_LT(std::sqrt(dot(apart, apart)), 1e-7) << "node " << n;
  }
}

TEST(ContactLooks, AResumedRunLooksInTheSameSteps) {
  for (const int before : {6, 9, 13}) {
    const auto [whole, resumed] = expect_same_bits_resumed(landing_block(), emulated, before, 16);
    EXPECT_NE(whole->energies().contact, 0) << "nothing touched";
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
