// Penalty response between deformable bodies: momentum, the stable step, depth under pressure, friction that
// holds, self-contact, restart.
#include <gtest/gtest.h>

#include <tests/contact/body_scenes.hpp>
#include <tests/contact/overlap_check.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

class BodyPenalties : public Matrix {};

Model sliding_block(const PenaltyShare& penalty) {
  Model model = test::sliding_block();
  model.contact.penalty = penalty;
  return model;
}

TEST_P(BodyPenalties, KeepMomentumWithFriction) {
  const Model model = sliding_block(default_penalty);
  const auto mass = lumped_mass(model);
  const Body all{0, model.mesh.node_count()};
  auto simulation = simulate(model, GetParam());
  const auto before = mean_of(simulation->velocity(), all, mass);
  while (!simulation->finished()) simulation->step(20);
  const auto lost = mean_of(simulation->velocity(), all, mass) - before;
  EXPECT_LT(std::sqrt(dot(lost, lost)), GetParam().rounding() * 0.1);
  EXPECT_LT(simulation->energies().contact, 0) << "friction takes energy";
  EXPECT_GT(mean_of(simulation->velocity(), {0, 25 * 25 * 3}, mass).x, 1e-4) << "nothing was touched";
}

TEST_P(BodyPenalties, AResumedRunEndsWithTheSameBits) {
  const auto [whole, resumed] = expect_same_bits_resumed(sliding_block(default_penalty), GetParam(), 10, 10);
  const ContactReport a = whole->contacts().at(0).report, b = resumed->contacts().at(0).report;
  EXPECT_GT(a.node_count, 0);
  EXPECT_EQ(a.node_count, b.node_count);
  EXPECT_EQ(a.largest_depth, b.largest_depth);
}

TEST(BodyPenaltyThreads, GiveTheSameBitsForAnyNumber) {
  expect_same_bits_for_any_threads(sliding_block(default_penalty), threads_float, 30);
}

/// Undamped bodies in resting contact at 0.999 of the stable step, with the largest stiffness that there is:
/// the sum of kinetic, strain and potential energy never grows.
TEST(BodyPenalty, TheStepStaysStableAtEveryStiffness) {
  for (const double share : {0.3, 0.5, default_penalty, 1.0}) {
    Model model;
    const Material rubber{"NH", mu_kappa(1e4, 0.3), 1000};
    add_body(model, box_mesh({4, 4, 3}, {0.04, 0.04, 0.03}, Shape::hexahedron), Formulation::h8, rubber);
    Mesh upper = box_mesh({5, 5, 3}, {0.04, 0.04, 0.03}, Shape::tetrahedron);
    move(upper, {0.001, -0.0005, 0.0301});
    const Body block = add_body(model, upper, Formulation::t4, rubber);
    model.fixed.push_back({face(model.mesh, 2, 0), all_axes});
    model.initial_velocities.push_back({block.nodes(), {0, 0, -0.1}});
    model.contact.between_bodies = true;
    model.contact.penalty = share;
    model.time.total = 0.3;
    model.time.safety = 0.999;
    auto simulation = simulate(model, threads_float);
    double peak = 0;
    while (!simulation->finished()) {
      simulation->step(20);
      const Energies e = simulation->energies();
      peak = std::max(peak, (e.kinetic + e.strain) / e.initial);
    }
    EXPECT_LT(peak, 1.001) << share;
    EXPECT_GT(simulation->contacts().at(0).report.largest_depth, 0) << share;
    EXPECT_GT(mean_of(simulation->velocity(), block, lumped_mass(model)).z, 0.02)
        << "it flies off: " << share;
  }
}

/// Two blocks pressed by this share of their height: the depth at the end in edges, the force [N].
constexpr double press_edge = 0.06 / 7;
struct Pressed {
  double depth, force;
};
Pressed press(double by, const PenaltyShare& penalty) {
  auto [model, above] = pressed_blocks(by, 0.5, 40);
  model.contact.penalty = penalty;
  auto simulation = simulate(model, threads_float);
  while (!simulation->finished()) simulation->step(100);
  double force = 0;
  const auto f = simulation->contact_force();
  for (const int n : above.nodes()) force += f[static_cast<std::size_t>(n)].z;
  return {simulation->contacts().at(0).report.depth / press_edge, force};
}

/// The multipliers hold the surfaces on each other, penalties let them in by a share that falls with the
/// stiffness; the force is that of the bodies either way.
TEST(BodyPenalty, DepthUnderPressureFallsWithTheStiffness) {
  const Pressed exact = press(0.2, {});
  double last = 1;
  for (const double share : {0.3, 0.5, default_penalty}) {
    const Pressed its = press(0.2, share);
    EXPECT_LT(its.depth, 0.6 * last) << share;
    EXPECT_GT(its.depth, exact.depth) << share;
    const double overlap = its.depth * press_edge / (0.2 * 0.06);  // by which the bodies are pressed less
    EXPECT_NEAR(its.force, exact.force, 1.5 * overlap * exact.force) << share;
    last = its.depth;
  }
  EXPECT_LT(last, 0.02);
}

/// Below the angle of friction a block creeps by next to nothing.
TEST(BodyPenalty, FrictionHoldsWhatItCanHold) {
  Model model;
  const Material firm{"NH", mu_kappa(1e5, 0.3), 1000};
  add_body(model, box_mesh({12, 5, 1}, {0.12, 0.05, 0.01}, Shape::hexahedron), Formulation::h8, firm);
  Mesh upper = box_mesh({5, 4, 2}, {0.04, 0.04, 0.02}, Shape::hexahedron);
  move(upper, {0.013, 0.005, 0.01});
  const Body block = add_body(model, upper, Formulation::h8, firm);
  for (Section& section : model.sections)
    section.material.isochoric = section.material.volumetric = {{0.5, 3e-4}};
  model.fixed.push_back({face(model.mesh, 2, 0), all_axes});
  const double mu = 0.3, slope = std::atan(0.9 * mu);
  model.gravity.push_back(
      {block.nodes(), 9.81 * Vec3<double>{std::sin(slope), 0, -std::cos(slope)}, smooth_curve(0.1)});
  model.contact.between_bodies = true;
  model.contact.friction = mu;
  model.contact.penalty = default_penalty;
  model.time.total = 0.3;
  const auto mass = lumped_mass(model);
  auto simulation = simulate(model, threads_float);
  while (simulation->time() < 0.15) simulation->step(20);
  const double way = mean_of(simulation->displacement(), block, mass).x;
  while (!simulation->finished()) simulation->step(20);
  const double later = mean_of(simulation->displacement(), block, mass).x;
  EXPECT_LT(later, 2e-4) << "0.11 m if it slipped freely";
  EXPECT_NEAR(later, way, 2e-5) << "8e-6 as measured; multipliers 5e-7";
}

TEST(BodyPenalty, BodiesThatStartInEachOtherAreRefused) {
  Model model = sliding_block(default_penalty);
  for (auto& X : model.mesh.X)
    if (X.z > 0.02005) X.z -= 0.0008;
  expect_refused(model, "penalty forces would throw them apart");
  model.contact.penalty = 1.5;
  expect_refused(model, "its penalty stiffness is 1.5");
  model.contact.penalty = -0.1;
  expect_refused(model, "must be greater than 0");
}

GLISSON_ALL_CASES(BodyPenalties);

}  // namespace
}  // namespace glisson::test
