// The stable step of membranes and shells against the eigenvalues of whole meshes, and relaxation in time.
#include <gtest/gtest.h>

#include <algorithm>

#include <Eigen/Dense>

#include <glisson/shells/inertia.hpp>
#include <tests/shells/sheets.hpp>
#include <tests/shells/statics.hpp>
#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

Model uneven(ShellSection section) {
  Model model = sheet(
      6, 4,
      [](double s, double t) {
        return Vec3<double>{0.2 * s * (1 + 0.5 * s), 0.1 * t + 0.02 * t * (1 - t) * std::sin(9 * s),
                            0.02 * std::sin(4 * s + t)};
      },
      std::move(section));
  model.shells[0].direction = {1, 0, 0};
  return model;
}

double rest_area(const Model& model, const std::array<int, 3>& t) {
  const auto X = [&](std::size_t a) { return model.mesh.X[static_cast<std::size_t>(t[a])]; };
  const auto N = cross(X(1) - X(0), X(2) - X(0));
  return 0.5 * std::sqrt(dot(N, N));
}

/// 2 / omega_max of the free mesh, pulled by next to nothing: fibres and wrinkled parts work then.
double exact_step(const Model& model) {
  ShellStatics statics(model, FixedDirections(model.mesh.X.size()));
  for (std::size_t n = 0; n < model.mesh.X.size(); ++n) statics.u()[n] = 1e-9 * model.mesh.X[n];
  std::vector<Vec3<double>> f;
  std::vector<MatrixEntry> K;
  statics.evaluate(f, K);
  std::vector<double> mass(model.mesh.X.size(), 0);
  for (const auto& t : model.mesh.triangles)
    for (const int n : t)
      mass[static_cast<std::size_t>(n)] +=
          model.shells[0].density * model.shells[0].thickness * rest_area(model, t) / 3;
  const auto size = static_cast<Eigen::Index>(statics.dofs());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  for (const auto& e : K)
    A(e.row, e.col) += e.value / std::sqrt(mass[static_cast<std::size_t>(e.row / 3)] *
                                           mass[static_cast<std::size_t>(e.col / 3)]);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A, Eigen::EigenvaluesOnly);
  return 2 / std::sqrt(solver.eigenvalues().maxCoeff());
}

double bound(const Model& model) {
  double dt = 1e300;
  for (const auto& step : shells::triangle_steps(model)) dt = std::min(dt, step.dt);
  return dt;
}

/// From thin ones, limited by the plane, to thick ones, limited by bending.
std::vector<Model> sheets() {
  std::vector<Model> models;
  for (const ShellSection& section :
       {membrane_section("Linear", {1e5, 0.3}, 1e-3), membrane_section("NeoHookean", {1e5}, 1e-3),
        membrane_section("NeoHookeanCompressible", {1e5, 3e5}, 1e-3),
        membrane_section("Fung", {1e5, 3}, 1e-3), membrane_section("TwoFibre", {1e5, 1e5, 2, 30}, 1e-3),
        shell_section(1e6, 0.3, 1e-4), shell_section(1e6, 0.3, 5e-3), shell_section(1e6, 0.3, 2e-2)})
    models.push_back(uneven(section));
  Model clamped = uneven(shell_section(1e6, 0.3, 1e-2));
  clamped.clamped_nodes = sheet_nodes(clamped, [](const auto& X) { return X.x < 1e-9; });
  models.push_back(clamped);
  Model wrinkling = uneven(membrane_section("NeoHookean", {1e5}, 1e-3));
  wrinkling.shells[0].wrinkling = true;
  models.push_back(wrinkling);
  models.push_back(uneven(membrane_section("TwoFibre", {1e4, 1e6, 2, 30}, 1e-3)));  // strong fibres
  return models;
}

TEST(ShellSteps, TheElementsBoundThatOfTheMesh) {
  for (const Model& model : sheets()) {
    const double exact = exact_step(model), estimate = bound(model);
    printf("    %s %s h %g: bound over exact %.3f\n", name_of(model.shells[0].formulation),
           model.shells[0].law.c_str(), model.shells[0].thickness, estimate / exact);
    EXPECT_LE(estimate, exact * (1 + 1e-6));
    EXPECT_GE(estimate, 0.4 * exact);
  }
}

class ShellSteppers : public Matrix {};

/// What a run takes for stable lies between the bound and the truth, and a run with it stays in balance.
TEST_P(ShellSteppers, RunsTakeAStableStep) {
  for (Model model : sheets()) {
    const double exact = exact_step(model);
    for (int n = 0; n < model.mesh.node_count(); ++n)
      model.initial_velocities.push_back({{n}, {0, 0, 1e-4 * std::sin(5.0 * n)}});
    model.time.total = 200 * exact, model.time.safety = 0.95;
    // stiffness that comes and goes within a step costs the balance more
    if (model.shells[0].law == "TwoFibre" || model.shells[0].wrinkling) model.time.safety = 0.5;
    auto simulation = simulate(model, GetParam());
    EXPECT_LE(simulation->report().stable_step, 1.001 * exact);
    EXPECT_GE(simulation->report().stable_step, 0.99 * bound(model));
    while (!simulation->finished()) simulation->step(50);
    const Energies e = simulation->energies();
    EXPECT_LT(e.kinetic + e.strain, 1.5 * e.initial);
  }
}

/// A strip held at a stretch relaxes as S_e (1 - alpha + alpha exp(-t / tau)); the terms step by backward
/// Euler, so exp(-t / tau) is (1 + dt / tau)^-n, n steps after the first one.
TEST_P(ShellSteppers, AHeldMembraneRelaxes) {
  const double alpha = 0.4, tau = 0.2, stretch = 1.2;
  for (const char* law : {"NeoHookean", "Linear"}) {
    ShellSection section = membrane_section(law, {1e4}, 1e-3);
    if (section.law == "Linear") section.parameters.push_back(0.3);
    double pull[2];
    for (const bool relaxes : {false, true}) {
      section.prony.clear();
      if (relaxes) section.prony = {{alpha, tau}};
      Model model = uneven(section);
      std::vector<double> values;
      std::vector<int> nodes;
      for (int n = 0; n < model.mesh.node_count(); ++n) {
        nodes.push_back(n);
        values.push_back((stretch - 1) * model.mesh.X[static_cast<std::size_t>(n)].x);
      }
      model.displacements.push_back({nodes, 1, values, step_curve(1)});
      model.fixed.push_back({nodes, 6});
      model.time.total = 0.4, model.time.step = 0.002, model.time.energy_tolerance = 0;
      auto simulation = simulate(model, GetParam());
      while (!simulation->finished()) simulation->step(50);
      pull[relaxes] = 0;
      const auto f = simulation->internal_force();
      for (const int n : sheet_nodes(model, [](const auto& X) { return X.x > 0.3 - 1e-9; }))
        pull[relaxes] -= f[static_cast<std::size_t>(n)].x;
    }
    ASSERT_GT(pull[0], 0.01);
    EXPECT_NEAR(pull[1] / pull[0], 1 - alpha + alpha * std::exp(-0.4 / tau), 0.003) << law;
  }
}
GLISSON_ALL_CASES(ShellSteppers);

}  // namespace
}  // namespace glisson::test
