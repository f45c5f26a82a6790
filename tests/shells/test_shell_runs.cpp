// Membranes and shells in whole runs, on every backend.
#include <gtest/gtest.h>

#include <sstream>

#include <tests/shells/sheets.hpp>
#include <tests/support/models.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

class ShellRuns : public Matrix {};

/// Uniaxial tension, closed form: nominal stress mu (l - 1/l^2), width and thickness 1/sqrt(l), on two
/// meshes.
TEST_P(ShellRuns, ANeoHookeanStripStretchesAsTheClosedFormSays) {
  const double mu = 1000, h = 0.001, stretch = 1.5, stress = mu * (stretch - 1 / (stretch * stretch));
  for (const int n : {2, 5}) {
    Model model = sheet(
        2 * n, n,
        [](double s, double t) {
          return Vec3<double>{0.2 * s, 0.1 * t, 0};
        },
        membrane_section("NeoHookean", {mu}, h));
    const auto all = sheet_nodes(model, [](const auto&) { return true; });
    model.fixed.push_back({all, 4});
    model.fixed.push_back({sheet_nodes(model, [](const auto& X) { return X.x < 1e-9; }), 1});
    model.fixed.push_back({{0}, all_axes});
    const auto end = sheet_nodes(model, [](const auto& X) { return X.x > 0.2 - 1e-9; });
    std::vector<double> share(end.size(), stress * h * 0.1 / n);
    share.front() /= 2, share.back() /= 2;
    model.forces.push_back({end, 1, share, smooth_curve(1)});
    model.time = relaxed(1e-5, 1e-6);
    validate(model);
    const auto u = final_displacement(model, GetParam());
    const double wide = 0.1 * (1 / std::sqrt(stretch) - 1);
    EXPECT_NEAR(u[std::size_t(2 * n)].x, 0.2 * (stretch - 1), 2e-5);
    EXPECT_NEAR(u[u.size() - 1].y, wide, 2e-5);
  }
}
GLISSON_ALL_CASES(ShellRuns);

/// A simply supported square plate in its first mode: omega = 2 (pi / a)^2 sqrt(D / (rho h)), nu = 0.3.
Model plate(int n, double& omega) {
  const double E = 1e6, h = 0.01, rho = 1000, a = 1;
  Model model = sheet(
      n, n,
      [](double s, double t) {
        return Vec3<double>{s, t, 0};
      },
      shell_section(E, 0.3, h, rho));
  omega = 2 * pi * pi / (a * a) * std::sqrt(E * h * h / (12 * 0.91 * rho));
  model.fixed.push_back(
      {sheet_nodes(
           model, [](const auto& X) { return X.x < 1e-9 || X.y < 1e-9 || X.x > 1 - 1e-9 || X.y > 1 - 1e-9; }),
       all_axes});
  for (int k = 0; k < model.mesh.node_count(); ++k) {
    const auto& X = model.mesh.X[std::size_t(k)];
    const double shape = std::sin(pi * X.x) * std::sin(pi * X.y);
    if (shape > 1e-9) model.initial_velocities.push_back({{k}, {0, 0, 1e-4 * shape}});
  }
  model.time.total = 4 * 2 * pi / omega;
  return model;
}

/// First frequency over the exact one, from half a period.
double first_frequency(int n) {
  double omega = 0;
  Model model = plate(n, omega);
  model.time.total = 1.2 * pi / omega;
  auto simulation = simulate(model, serial_double);
  const auto middle = static_cast<std::size_t>(n / 2 + (n + 1) * (n / 2));
  double before = 0, t_before = 0, half_period = 0;
  while (!simulation->finished()) {
    simulation->step(20);
    const double now = simulation->displacement()[middle].z, t = simulation->time();
    if (before > 0 && now <= 0) half_period = t_before + (t - t_before) * before / (before - now);
    before = now, t_before = t;
  }
  EXPECT_GT(half_period, 0);
  EXPECT_LT(std::abs(simulation->energies().imbalance()), 0.01 * simulation->energies().initial);
  return pi / half_period / omega;
}

TEST(ShellDynamics, APlateVibratesAtItsFirstFrequency) {
  double before = 1;
  for (const int n : {6, 12, 24}) {
    const double ratio = first_frequency(n);
    printf("    %3d x %-3d first frequency over exact: %.4f\n", n, n, ratio);
    EXPECT_LT(std::abs(ratio - 1), before);
    before = std::abs(ratio - 1);
  }
  EXPECT_LT(before, 0.02);
}

TEST(ShellThreads, GiveTheSameBitsForAnyNumber) {
  double omega = 0;
  Model model = plate(60, omega);
  model.shells[0].prony = {{0.3, 0.2}};
  const auto u = expect_same_bits_for_any_threads(model, threads_float, 60);
  EXPECT_GT(u[30 + 61 * 30].z, 0);
}

TEST(ShellDynamics, ACheckpointGoesOnWithTheSameBits) {
  double omega = 0;
  Model model = plate(6, omega);
  model.shells[0].prony = {{0.3, 0.2}};
  model.time.total = 0.5;
  auto whole = simulate(model, threads_float);
  whole->step(40);
  std::stringstream file;
  whole->save(file);
  auto resumed = simulate(model, threads_float);
  resumed->load(file);
  whole->step(40), resumed->step(40);
  const auto a = whole->displacement(), b = resumed->displacement();
  double largest = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    EXPECT_EQ(a[n].z, b[n].z);
    largest = std::max(largest, std::abs(a[n].z));
  }
  EXPECT_GT(largest, 0);
}

}  // namespace
}  // namespace glisson::test
