// Loads on node lists: forces, gravity, springs; work and restart of each.
#include <cmath>
#include <numeric>

#include <glisson/core/base/error.hpp>

#include "tests/core/loaded_nodes.hpp"

namespace glisson {
namespace {

const LoadCurve always{LoadShape::step};

using NodeLoads = BenchTest;
GLISSON_BENCH_CASES(NodeLoads);

TEST_P(NodeLoads, ForceActsOnItsAxesOnly) {
  const auto bench = loaded_nodes(GetParam(), 10);
  const auto load = bench->load(NodalForce{{1, 4, 4}, 5u, {2, 3, 5}, always});
  const auto& f = bench->forces(*load);
  for (int n = 0; n < 10; ++n) {
    const double expected = n == 1 ? 2 : n == 4 ? 8 : 0;
    expect_near(f[std::size_t(n)], {expected, 0, expected}, 0);
  }
}

TEST_P(NodeLoads, CurveStartsAndEndsOnTime) {
  const auto bench = loaded_nodes(GetParam(), 3);
  NodalForce load{{0}, 1u, {4}, {LoadShape::ramp, 2, 4}};
  const auto held = bench->load(load);
  load.curve.release_after_end = true;
  const auto released = bench->load(load);
  const double times[] = {1.999, 2, 3, 4, 4.001}, values[] = {0, 0, 2, 4, 4};
  for (int k = 0; k < 5; ++k) EXPECT_DOUBLE_EQ(bench->forces(*held, times[k])[0].x, values[k]);
  EXPECT_DOUBLE_EQ(bench->forces(*released, 4)[0].x, 4);
  EXPECT_DOUBLE_EQ(bench->forces(*released, 4.001)[0].x, 0);
}

TEST_P(NodeLoads, GravityIsMassTimesAcceleration) {
  const auto bench = loaded_nodes(GetParam(), 10, 0.25);
  bench->masses[3] = 2;
  std::vector<double> internal(10, 0.25);
  internal[std::size_t(bench->numbering.internal_of_user[3])] = 2;
  const Vec3<double> g{0.5, 0, -9.81};
  const auto all = bench->load(Gravity{{}, g, always}, internal);
  const auto some = bench->load(Gravity{{3, 5}, g, always}, internal);
  expect_near(sum_of(bench->forces(*all)), 4.25 * g, 45 * bench->tolerance());
  expect_near(bench->forces(*some)[3], 2.0 * g, 20 * bench->tolerance());
  expect_near(bench->f[4], {}, 0);
}

TEST_P(NodeLoads, SpringPullsToItsMovingTarget) {
  const auto bench = loaded_nodes(GetParam(), 3, 0.5);
  Springs springs{{0, 2}, {{1, 0, 0}, {0, 2, 0}}, {8, 16}, {LoadShape::ramp, 0, 2}, {LoadShape::ramp, 0, 4},
                  {}};
  const auto load = bench->load(springs);
  bench->u[0] = {0.125, 0, 0.5};
  const auto& f = bench->forces(*load, 1);  // k amplitude 1/2, target amplitude 1/4
  expect_near(f[0], {4 * (0.25 - 0.125), 0, -2}, 0);
  expect_near(f[2], {0, 8 * 0.5, 0}, 0);
  EXPECT_DOUBLE_EQ(load->stable_step(), 2 / std::sqrt(16 / 0.5));
}

TEST_P(NodeLoads, SpringsOnOneNodeActTogether) {
  const auto bench = loaded_nodes(GetParam(), 3);
  Springs springs{{1, 1}, {{1, 0, 0}, {-1, 0, 0}}, {3, 1}, always, always, {}};
  const auto load = bench->load(springs);
  bench->u[1] = {0.25, 0, 0};
  expect_near(bench->forces(*load)[1], {3 * 0.75 - 1.25, 0, 0}, 0);
}

TEST_P(NodeLoads, SpringStiffnessFreezesAboveTheStrainEnergyCap) {
  const auto bench = loaded_nodes(GetParam(), 1);
  Springs springs{{0}, {{1, 0, 0}}, {4}, {LoadShape::ramp, 0, 4}, always, 10.0};
  const auto load = bench->load(springs);
  const auto pull = [&](double t, double strain_energy, bool advance = true) {
    auto step = bench->view(t, 1);
    step.strain_energy = strain_energy;
    step.advance = advance;
    return bench->forces(*load, step)[0].x;
  };
  EXPECT_DOUBLE_EQ(pull(1, 5), 1);
  EXPECT_DOUBLE_EQ(pull(3, 5, false), 3);  // an evaluation on the side
  EXPECT_DOUBLE_EQ(pull(2, 10), 1);        // leaves no trace: the last step's value is kept
  const auto saved = load->save();
  const auto resumed = bench->load(springs);
  resumed->load(saved);
  EXPECT_DOUBLE_EQ(resumed->stiffness_amplitude(), 0.25);
  EXPECT_DOUBLE_EQ(pull(3, 11), 1);
  EXPECT_DOUBLE_EQ(pull(3, 9.9), 3);
}

/// Constant acceleration from rest: W = F u exactly at every step but for the half weight of step 0, F dt^2 /
/// (8 m) of path.
TEST_P(NodeLoads, WorkOfAConstantForceIsForceTimesPath) {
  const double mass = 2, dt = 0.125;
  const Vec3<double> g{0, 3, -4};
  const auto bench = loaded_nodes(GetParam(), 1, mass);
  const auto load = bench->load(Gravity{{}, g, always}, bench->masses);
  for (int n = 0; n < 40; ++n) {
    bench->forces(*load, bench->view(n * dt, dt));
    bench->advance(dt);
    auto side = bench->view(n * dt, dt);
    side.advance = false;
    load->add_forces(side);
  }
  const double t = 40 * dt, path = 5 * t * t / 2;
  auto last = bench->view(t, dt);
  load->add_forces(last);
  EXPECT_NEAR(load->work(), mass * 5 * (path - 5 * dt * dt / 8),
              1e-5 * mass * 5 * path * (in_float(GetParam()) ? 1 : 1e-6));
}

/// An oscillator: KE(n) = m v(n-1/2).v(n+1/2)/2 changes by exactly the work of the spring.
TEST_P(NodeLoads, WorkOfASpringBalancesTheKineticEnergy) {
  const double dt = 0.2;
  const auto bench = loaded_nodes(GetParam(), 1, 3);
  Springs springs{{0}, {{1, 2, -1}}, {5}, {LoadShape::ramp, 0, 10}, always, {}};
  const auto load = bench->load(springs);
  for (int n = 0; n < 60; ++n) {
    bench->forces(*load, bench->view(n * dt, dt));
    const auto before = bench->v[0];
    bench->advance(dt);
    const double kinetic = 1.5 * dot(before, bench->v[0]);
    EXPECT_NEAR(load->work(), kinetic, 20 * bench->tolerance());
  }
}

TEST_P(NodeLoads, CountingWorkDoesNotChangeTheForces) {
  const auto bench = loaded_nodes(GetParam(), 40, 0.3);
  Model model;
  std::vector<int> nodes(40);
  std::iota(nodes.begin(), nodes.end(), 0);
  model.forces.push_back({nodes, 7u, {0.7}, always});
  model.gravity.push_back({{}, {1, 2, 3}, always});
  model.springs.push_back({nodes, {{0.1, 0.7, 0}}, {2.3}, always, always, {}});
  const auto loads = bench->loads(model);
  for (std::size_t n = 0; n < 40; ++n) bench->u[n] = {0.1 * double(n), -0.3, 0.7};
  auto step = bench->view(1, 0.1);
  for (const auto& load : loads) bench->forces(*load, step);
  const auto counted = bench->f;
  step = bench->view(1, 0.1);
  step.monitor = false;
  for (const auto& load : loads) bench->forces(*load, step);
  for (std::size_t n = 0; n < 40; ++n) expect_near(bench->f[n], counted[n], 0);
}

TEST_P(NodeLoads, RestartGivesTheSameBits) {
  const auto bench = loaded_nodes(GetParam(), 40, 0.3);
  Model model;
  std::vector<int> nodes(40);
  std::iota(nodes.begin(), nodes.end(), 0);
  model.forces.push_back({nodes, 7u, {0.7}, {LoadShape::hilly, 0, 1}});
  model.gravity.push_back({{}, {1, 2, 3}, {LoadShape::poly345, 0, 1}});
  model.springs.push_back({nodes, {{0.1, 0, 0}}, {2}, {}, {}, {}});
  auto loads = bench->loads(model), resumed = bench->loads(model);
  const auto run = [&](auto& list, int from, int to) {
    for (bench->step_count = from; bench->step_count < to;) {
      auto step = bench->view(0.1 * double(bench->step_count), 0.1);
      for (auto& load : list) bench->forces(*load, step);
      bench->advance(0.1);
    }
  };
  run(loads, 0, 5);
  const auto u = bench->u, v = bench->v;
  for (std::size_t k = 0; k < loads.size(); ++k) resumed[k]->load(loads[k]->save());
  run(loads, 5, 10);
  const auto u_end = bench->u;
  bench->u = u, bench->v = v;
  run(resumed, 5, 10);
  for (std::size_t n = 0; n < u.size(); ++n) expect_near(bench->u[n], u_end[n], 0);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    EXPECT_EQ(resumed[k]->work(), loads[k]->work());
    EXPECT_NE(loads[k]->work(), 0);
    EXPECT_EQ(resumed[k]->save(), loads[k]->save());
    auto bytes = loads[k]->save();
    bytes.pop_back();
    EXPECT_THROW(loads[k]->load(bytes), Error);
  }
}

}  // namespace
}  // namespace glisson
