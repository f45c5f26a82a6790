// Coulomb friction between deformable bodies against what is known in closed form.
#include <gtest/gtest.h>

#include <tests/contact/bodies.hpp>

namespace glisson::test {
namespace {

constexpr double g = 9.81;

/// A block of 4 cm on a track that is held from below; gravity acts within 0.2 s, smoothly. What slides on
/// something elastic with a constant coefficient excites vibrations (Adams 1995), in which parts of the
/// interface stick and the mean friction is less; relaxation damps them, as in tissue.
struct Slide {
  Model model;
  Body block;
  Slide(double friction, const Vec3<double>& gravity) {
    const Material firm{"NH", mu_kappa(1e5, 0.3), 1000};
    add_body(model, box_mesh({24, 5, 1}, {0.24, 0.05, 0.01}, Shape::hexahedron), Formulation::h8, firm);
    Mesh upper = box_mesh({5, 4, 2}, {0.04, 0.04, 0.02}, Shape::hexahedron);
    move(upper, {0.013, 0.005, 0.01});
    block = add_body(model, upper, Formulation::h8, firm);
    for (Section& section : model.sections)
      section.material.isochoric = section.material.volumetric = {{0.5, 3e-4}};
    model.fixed.push_back({face(model.mesh, 2, 0), all_axes});
    model.gravity.push_back({block.nodes(), gravity, smooth_curve(0.2)});
    model.contact.between_bodies = true;
    model.contact.friction = friction;
  }
};

/// Acceleration once gravity acts fully, over g.
double acceleration_on_incline(double friction, double slope) {
  Slide slide(friction, g * Vec3<double>{std::sin(slope), 0, -std::cos(slope)});
  slide.model.time.total = 0.5;
  const auto mass = lumped_mass(slide.model);
  auto simulation = simulate(slide.model, threads_float);
  const auto speed = [&] { return mean_of(simulation->velocity(), slide.block, mass).x; };
  while (simulation->time() < 0.3) simulation->step(1);
  const double t = simulation->time(), v = speed();
  while (!simulation->finished()) simulation->step(1);
  return (speed() - v) / (simulation->time() - t) / g;
}

/// The bound is 2 % of the acceleration at 1.01.
TEST(BodyFriction, ABlockSlipsExactlyAboveTheAngleOfFriction) {
  const double mu = 0.3;
  for (const double share : {0.98, 0.99, 1.01, 1.02, 1.2}) {
    const double slope = std::atan(share * mu);
    const double expected = share > 1 ? std::sin(slope) - mu * std::cos(slope) : 0;
    const double a = acceleration_on_incline(mu, slope);
    EXPECT_NEAR(a, expected, share < 1.1 ? 6e-5 : 2e-4) << share;
  }
}

/// While gravity grows as 10 r^3 - 15 r^4 + 6 r^5 over T the block loses mu g T / 2 of its speed and mu g T^2
/// / 7 of its way.
TEST(BodyFriction, ABlockStopsWhereItShould) {
  const double mu = 0.25, v = 0.6, T = 0.2;
  Slide slide(mu, {0, 0, -g});
  slide.model.initial_velocities.push_back({slide.block.nodes(), {v, 0, 0}});
  slide.model.time.total = 0.6;
  const double left = v - mu * g * T / 2;
  const double expected = v * T - mu * g * T * T / 7 + left * left / (2 * mu * g);
  const auto mass = lumped_mass(slide.model);
  auto simulation = simulate(slide.model, threads_float);
  while (!simulation->finished()) simulation->step(20);
  const double way = mean_of(simulation->displacement(), slide.block, mass).x;
  EXPECT_NEAR(way / expected, 1, 0.01);
  EXPECT_NEAR(mean_of(simulation->velocity(), slide.block, mass).x, 0, 0.002);
}

}  // namespace
}  // namespace glisson::test
