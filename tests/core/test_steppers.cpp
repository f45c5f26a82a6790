// The velocity forms against the textbook recurrences, and the plan of steps.
#include <gtest/gtest.h>

#include <cmath>

#include <glisson/core/base/error.hpp>
#include <glisson/core/kernels/advance_nodes.hpp>
#include <glisson/core/simulation/step_plan.hpp>
#include <glisson/core/steppers/steppers.hpp>

namespace glisson {
namespace {

constexpr double mass = 0.7, stiffness = 350, damping = 3, dt = 0.02;

double force(double u, double t) { return std::sin(5 * t) - stiffness * u - 40 * u * u * u; }

/// u after `steps` with a stepper in velocity form, started with v(-1/2) = 0 as the textbook forms are.
template <class S>
double velocity_form(int steps) {
  double u = 0;
  Vec3<double> v{};
  for (int n = 0; n < steps; ++n) {
    v = S::make(damping, dt, dt).velocity(v, {force(u, n * dt), 0, 0}, 1 / mass);
    u += dt * v.x;
  }
  return u;
}

TEST(Steppers, CentralDifferenceIsTheTextbookRecurrence) {  // Johnsen 2016, eq. 4.13-4.14
  const double D = damping * mass, A = 1 / (D / (2 * dt) + mass / (dt * dt));
  const double b = 2 * mass / (dt * dt) * A, c = (D / (2 * dt) - mass / (dt * dt)) * A;
  double u = 0, before = 0;
  for (int n = 0; n < 200; ++n) {
    const double next = A * force(u, n * dt) + b * u + c * before;
    before = u, u = next;
  }
  EXPECT_NEAR(velocity_form<CentralDifference<double>>(200), u, 1e-12);
}

TEST(Steppers, NewmarkIsTheTextbookRecurrence) {  // Johnsen 2016, eq. 4.15
  double u = 0, v = 0, a = 0;
  for (int n = 0; n < 200; ++n) {
    const double next =
        (force(u, n * dt) / mass - damping * v - 0.5 * damping * dt * a) / (1 + 0.5 * damping * dt);
    v += 0.5 * dt * (next + a);
    a = next;
    u += dt * v + 0.5 * dt * dt * a;
  }
  EXPECT_NEAR(velocity_form<Newmark<double>>(200), u, 1e-12);
}

TEST(StepPlan, EndsExactlyAtTheTotalTime) {
  for (const double wish : {0.001, 0.0007, 0.3, 1.0, 5.0}) {
    const StepPlan plan(1.0, wish);
    EXPECT_DOUBLE_EQ(plan.time(plan.last_step()), 1.0);
    EXPECT_LE(plan.dt(), wish * (1 + 1e-6));
  }
  EXPECT_EQ(StepPlan(1.0, 0.1).last_step(), 10);  // 1.0 / 0.1 is not 10 in binary
}

TEST(StepPlan, AShorterStepStillEndsThere) {
  StepPlan plan(1.0, 0.01);
  plan.shorten(40, 0.003);
  EXPECT_DOUBLE_EQ(plan.time(40), 0.4);
  EXPECT_DOUBLE_EQ(plan.time(plan.last_step()), 1.0);
  EXPECT_DOUBLE_EQ(plan.force_interval(40), 0.5 * (0.01 + plan.dt()));
  EXPECT_DOUBLE_EQ(plan.force_interval(41), plan.dt());
  EXPECT_LE(plan.dt(), 0.003 * (1 + 1e-6));
}

TEST(StepPlan, RefusesWhatNeverEnds) { EXPECT_THROW(StepPlan(1.0, 1e-300), Error); }

// Between two accounts only the dissipation is summed: same motion, same dissipation.
TEST(Steppers, DampedUpdateDissipatesWhatTheMonitoredOneDoes) {
  constexpr int count = 150, chunks = 3;
  using Step = CentralDifference<float>;
  const Step step = Step::make(5, 1e-3, 1e-3);
  std::vector<Vec4<float>> u[2], v[2], f[2];
  std::vector<NodeEnergies> energies[2];
  for (int k = 0; k < 2; ++k) {
    energies[k].resize(chunks);
    u[k].resize(count), v[k].resize(count), f[k].resize(count);
    for (int n = 0; n < count; ++n) {
      const auto i = static_cast<std::size_t>(n);
      const float x = 0.01f * static_cast<float>(n);
      v[k][i] = {x, 1 - x, 0.5f * x, n % 7 == 0 ? 0.0f : 3 + x};  // some nodes have no mass
      f[k][i] = {2 * x, -x, 1, 0};
    }
  }
  for (int c = 0; c < chunks; ++c) {
    const AdvanceNodes<float, Step> a{u[0].data(), v[0].data(), f[0].data(), step.rows(), count},
        b{u[1].data(), v[1].data(), f[1].data(), step.rows(), count};
    AdvanceNodesMonitored<float, Step>{a, energies[0].data(), count, 5, 1e-3, false}(c);
    AdvanceNodesDamped<float, Step>{b, energies[1].data(), count, 5, 1e-3}(c);
  }
  for (std::size_t c = 0; c < chunks; ++c)
    EXPECT_NEAR(energies[1][c].damping, energies[0][c].damping, 1e-6 * energies[0][c].damping);
  for (std::size_t n = 0; n < count; ++n) {
    EXPECT_EQ(u[0][n].x, u[1][n].x);
    EXPECT_EQ(v[0][n].y, v[1][n].y);
    EXPECT_EQ(f[1][n].z, 0);
  }
}

}  // namespace
}  // namespace glisson
