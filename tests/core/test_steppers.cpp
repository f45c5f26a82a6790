// The velocity forms against the textbook recurrences, and the plan of steps.
#include <gtest/gtest.h>

#include <cmath>

#include <glisson/core/base/error.hpp>
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

}  // namespace
}  // namespace glisson
