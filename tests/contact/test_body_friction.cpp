// Coulomb friction between deformable bodies against what is known in closed form.
#include <gtest/gtest.h>

#include <algorithm>

#include <glisson/core/mesh/surface.hpp>
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

/// A bar is pressed on a rigid floor and pulled along it at its front face (Heinstein & Laursen 1999; Johnsen
/// 2016, section 5.5.5): E, nu and mu are theirs, the sizes, which the latter does not tell, are chosen so
/// that the last slip is 1.27 mm. The floor is a body all of whose nodes are held.
struct PulledBar {
  static constexpr double inch = 0.0254, L = 20 * inch, H = inch, E = 68.947e6, mu = 0.1, T = 0.1;
  static constexpr double pressed = 0.1 * T, pressure = E / 600, pull = mu * pressure * 25;
  Model model;
  Body bar;
  explicit PulledBar(int cells) {
    const Material elastic{"LE", {E, 0.0}, 1000};
    Mesh floor = box_mesh({23, 2, 1}, {22 * inch, 1.5 * inch, 0.5 * inch}, Shape::hexahedron);
    move(floor, {-inch, -0.25 * inch, -0.5 * inch});
    model.fixed.push_back({add_body(model, floor, Formulation::h8, elastic).nodes(), all_axes});
    bar = add_body(model, box_mesh({20 * cells, cells, cells}, {L, H, H}, Shape::hexahedron), Formulation::h8,
                   elastic);
    const auto on = [&](auto keep) {
      std::vector<int> nodes = bar.nodes();
      std::erase_if(nodes, [&](int n) { return !keep(model.mesh.X[static_cast<std::size_t>(n)]); });
      return nodes;
    };
    model.fixed.push_back({on([](const auto& X) { return X.x < 1e-9; }), 1});
    model.fixed.push_back({on([](const auto& X) { return X.y < 1e-9 || X.y > H - 1e-9; }), 2});
    model.displacements.push_back(
        {on([](const auto& X) { return X.z > H - 1e-9; }), 4, {-pressure / E * H}, smooth_curve(pressed)});
    std::vector<Facet> front = outer_surface(model.mesh);
    std::erase_if(front, [&](const Facet& facet) {
      return std::any_of(facet.nodes.begin(), facet.nodes.end(), [&](int n) {
        return n < bar.first_node || model.mesh.X[static_cast<std::size_t>(n)].x < L - 1e-9;
      });
    });
    model.pressures.push_back({front, -pull, {LoadShape::ramp, pressed, pressed + T}});
    model.contact.between_bodies = true;
    model.contact.friction = mu;
    model.time.total = pressed + T;
    model.time.damping = 200;
  }
  /// The part that slips under a share of the pull passes as much of it to the floor as friction takes.
  static double slip(double x, double share) {
    const double slope = mu * pressure / H / E, strain = share * pull / E;
    const double length = std::min(strain / slope, L), from = x - (L - length);
    return from < 0 ? 0 : (strain - slope * length + slope * from / 2) * from;
  }
};

TEST(BodyFriction, APulledBarSlipsAsFarAsItsFrictionLetsIt) {
  const PulledBar pulled(2);
  auto simulation = simulate(pulled.model, threads_float);
  for (const double share : {0.3, 0.5, 0.7, 0.9, 1.0}) {
    while (!simulation->finished() && simulation->time() < PulledBar::pressed + share * PulledBar::T)
      simulation->step(1);
    const double tip = PulledBar::slip(PulledBar::L, share);
    const auto u = simulation->displacement();
    for (const int n : pulled.bar.nodes()) {
      const auto& X = pulled.model.mesh.X[static_cast<std::size_t>(n)];
      if (X.z > 1e-9) continue;
      EXPECT_NEAR(u[static_cast<std::size_t>(n)].x / tip, PulledBar::slip(X.x, share) / tip,
                  share < 0.6 ? 0.05 : 0.02)
          << X.x << " at " << share;
    }
  }
}

}  // namespace
}  // namespace glisson::test
