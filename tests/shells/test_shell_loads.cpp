// Pressure, traction, gravity and momentum on triangles that stand on nodes of their own.
#include <gtest/gtest.h>

#include <tests/shells/sheets.hpp>
#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

constexpr double density = 1100, thickness = 2e-3;

std::vector<ShellSection> kinds() {
  return {membrane_section("NeoHookean", {1e4}, thickness, density),
          shell_section(1e4, 0.3, thickness, density)};
}

/// An irregular flat sheet, or one that is curved and folded.
Model free_sheet(const ShellSection& section, bool flat) {
  Model model = sheet(
      5, 4,
      [flat](double s, double t) {
        const double x = s + 0.1 * s * (1 - s) * std::sin(9 * t), y = t - 0.1 * t * (1 - t) * std::sin(7 * s);
        const double up = std::max(s - 0.6, 0.0) + 0.1 * std::sin(3 * t);
        return Vec3<double>{0.2 * x, 0.15 * y, flat ? 0 : 0.1 * up};
      },
      section);
  model.time.energy_tolerance = 0;
  return model;
}

/// The triangles as facets of loads; turned: seen from the other side.
std::vector<Facet> facets(const Model& model, bool turned) {
  std::vector<Facet> all;
  for (const auto& t : model.mesh.triangles)
    all.push_back(turned ? Facet{{t[0], t[2], t[1], -1}} : Facet{{t[0], t[1], t[2], -1}});
  return all;
}

Vec3<double> twice_area(const Model& model, const std::array<int, 3>& t) {
  const auto X = [&](std::size_t a) { return model.mesh.X[static_cast<std::size_t>(t[a])]; };
  return cross(X(1) - X(0), X(2) - X(0));
}

/// rho h A / 3 on each corner.
std::vector<double> masses(const Model& model) {
  std::vector<double> m(model.mesh.X.size(), 0);
  for (const auto& t : model.mesh.triangles) {
    const auto N = twice_area(model, t);
    for (const int n : t) m[static_cast<std::size_t>(n)] += density * thickness * std::sqrt(dot(N, N)) / 6;
  }
  return m;
}

Vec3<double> momentum(const Model& model, const AnySimulation& simulation) {
  const auto m = masses(model);
  const auto v = simulation.velocity();
  Vec3<double> sum;
  for (std::size_t n = 0; n < m.size(); ++n) sum = sum + m[n] * v[n];
  return sum;
}

Vec3<double> angular_momentum(const Model& model, const AnySimulation& simulation) {
  const auto m = masses(model);
  const auto v = simulation.velocity(), u = simulation.displacement();
  Vec3<double> sum;
  for (std::size_t n = 0; n < m.size(); ++n) sum = sum + m[n] * cross(model.mesh.X[n] + u[n], v[n]);
  return sum;
}

void expect_near(const Vec3<double>& a, const Vec3<double>& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

class ShellLoads : public Matrix {};

/// A load that is uniform over a flat sheet moves it as a rigid body, a = load / (rho h), on any mesh:
/// central differences give u = a t^2 / 2 exactly.
TEST_P(ShellLoads, UniformLoadsMoveAFlatSheetAsARigidBody) {
  struct Push {
    double pressure;
    bool turned;
    Vec3<double> traction, gravity, exact;
  };
  const double p = 3, a = p / (density * thickness);
  const Push pushes[] = {{p, false, {}, {}, {0, 0, -a}},
                         {-p, false, {}, {}, {0, 0, a}},
                         {p, true, {}, {}, {0, 0, a}},
                         {0, false, {p, 0, -2 * p}, {}, {a, 0, -2 * a}},
                         {0, true, {p, 0, -2 * p}, {}, {a, 0, -2 * a}},
                         {0, false, {}, {1, 2, -9.81}, {1, 2, -9.81}},
                         {p, false, {0, p, 0}, {0, 0, a}, {0, a, 0}}};
  for (const ShellSection& section : kinds())
    for (const Push& push : pushes) {
      Model model = free_sheet(section, true);
      if (push.pressure != 0)
        model.pressures.push_back({facets(model, push.turned), push.pressure, step_curve(1)});
      if (dot(push.traction, push.traction) > 0)
        model.tractions.push_back({facets(model, push.turned), {push.traction}, step_curve(1)});
      if (dot(push.gravity, push.gravity) > 0) model.gravity.push_back({{}, push.gravity, step_curve(1)});
      model.time.total = 0.05;
      validate(model);
      auto simulation = simulate(model, GetParam());
      while (!simulation->finished()) simulation->step(10);
      const double t = simulation->time(), size = std::sqrt(dot(push.exact, push.exact));
      const double rounding = 20 * GetParam().rounding() * size;
      for (const auto& u : simulation->displacement())
        expect_near(u, 0.5 * t * t * push.exact, 0.5 * t * t * rounding);
      for (const auto& v : simulation->velocity()) expect_near(v, t * push.exact, t * rounding);
    }
}

/// Of a curved and folded sheet: -p times the sum of the area vectors, t times the area. Momentum after one
/// short step.
TEST_P(ShellLoads, ResultantsOnAFoldedSheetAreExact) {
  for (const ShellSection& section : kinds())
    for (const bool turned : {false, true}) {
      Model model = free_sheet(section, false);
      const double p = 5;
      const Vec3<double> traction{2, -1, 3};
      Vec3<double> N;
      double area = 0;
      for (const auto& t : model.mesh.triangles) {
        const auto twice = twice_area(model, t);
        N = N + 0.5 * twice, area += 0.5 * std::sqrt(dot(twice, twice));
      }
      model.pressures.push_back({facets(model, turned), p, step_curve(1)});
      model.tractions.push_back({facets(model, turned), {traction}, step_curve(1)});
      model.time.step = 1e-6, model.time.total = 1;
      validate(model);
      auto simulation = simulate(model, GetParam());
      simulation->step(1);
      const Vec3<double> force = (turned ? p : -p) * N + area * traction;
      expect_near(momentum(model, *simulation), 1e-6 * force,
                  1e-6 * p * area * (1e-6 + GetParam().rounding()));
    }
}

/// A free sheet that flies, spins and swings: no force from outside, so momentum and angular momentum stay,
/// and so does the energy.
TEST_P(ShellLoads, AFreeSheetKeepsItsMomentum) {
  for (const ShellSection& section : kinds()) {
    Model model = free_sheet(section, false);
    const Vec3<double> spin{2, -3, 5};
    for (int n = 0; n < model.mesh.node_count(); ++n) {
      const auto& X = model.mesh.X[static_cast<std::size_t>(n)];
      const Vec3<double> swing{0.2 * std::sin(20 * X.y), 0, 0.5 * std::sin(30 * X.x)};
      model.initial_velocities.push_back({{n}, Vec3<double>{0.3, 0.1, -0.2} + cross(spin, X) + swing});
    }
    model.time.total = 0.3, model.time.safety = 0.5;
    validate(model);
    auto simulation = simulate(model, GetParam());
    const Vec3<double> P = momentum(model, *simulation), L = angular_momentum(model, *simulation);
    while (!simulation->finished()) simulation->step(50);
    const double rounding = 20 * GetParam().rounding() + 1e-9;
    expect_near(momentum(model, *simulation), P, rounding * std::sqrt(dot(P, P)));
    expect_near(angular_momentum(model, *simulation), L, rounding * std::sqrt(dot(L, L)));
    const Energies e = simulation->energies();
    EXPECT_GT(e.strain, 0.01 * e.initial);
    EXPECT_LT(std::abs(e.imbalance()), 0.01 * e.initial);
  }
}
GLISSON_ALL_CASES(ShellLoads);

}  // namespace
}  // namespace glisson::test
