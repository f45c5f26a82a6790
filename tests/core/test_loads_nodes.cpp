// Loads on node lists: forces, gravity, springs; work and restart of each.
#include <glisson/core/loads/make_loads.hpp>

#include "load_bench.hpp"

namespace glisson {
namespace {

const LoadCurve always{LoadShape::step};

template <class C>
struct NodeLoads : ::testing::Test {};
TYPED_TEST_SUITE(NodeLoads, BenchCases);

TYPED_TEST(NodeLoads, ForceActsOnItsAxesOnly) {
  Bench<TypeParam> bench(10);
  NodalForces<BackendOf<TypeParam>, RealOf<TypeParam>> load(bench.backend, {{1, 4, 4}, 5u, {2, 3, 5}, always},
                                                            bench.numbering);
  const auto& f = bench.forces(load);
  for (int n = 0; n < 10; ++n) {
    const double expected = n == 1 ? 2 : n == 4 ? 8 : 0;
    expect_near(f[std::size_t(n)], {expected, 0, expected}, 0);
  }
}

TYPED_TEST(NodeLoads, CurveStartsAndEndsOnTime) {
  Bench<TypeParam> bench(3);
  NodalForce load{{0}, 1u, {4}, {LoadShape::ramp, 2, 4}};
  NodalForces<BackendOf<TypeParam>, RealOf<TypeParam>> held(bench.backend, load, bench.numbering);
  load.curve.release_after_end = true;
  NodalForces<BackendOf<TypeParam>, RealOf<TypeParam>> released(bench.backend, load, bench.numbering);
  const double times[] = {1.999, 2, 3, 4, 4.001}, values[] = {0, 0, 2, 4, 4};
  for (int k = 0; k < 5; ++k) EXPECT_DOUBLE_EQ(bench.forces(held, times[k])[0].x, values[k]);
  EXPECT_DOUBLE_EQ(bench.forces(released, 4)[0].x, 4);
  EXPECT_DOUBLE_EQ(bench.forces(released, 4.001)[0].x, 0);
}

TYPED_TEST(NodeLoads, GravityIsMassTimesAcceleration) {
  Bench<TypeParam> bench(10, 0.25);
  bench.masses[3] = 2;
  std::vector<double> internal(10, 0.25);
  internal[std::size_t(bench.numbering.internal_of_user[3])] = 2;
  const Vec3<double> g{0.5, 0, -9.81};
  GravityLoad<BackendOf<TypeParam>, RealOf<TypeParam>> all(bench.backend, {{}, g, always}, bench.numbering,
                                                           internal);
  GravityLoad<BackendOf<TypeParam>, RealOf<TypeParam>> some(bench.backend, {{3, 5}, g, always},
                                                            bench.numbering, internal);
  expect_near(sum_of(bench.forces(all)), 4.25 * g, 45 * bench.tolerance());
  expect_near(bench.forces(some)[3], 2.0 * g, 20 * bench.tolerance());
  expect_near(bench.f[4], {}, 0);
}

TYPED_TEST(NodeLoads, SpringPullsToItsMovingTarget) {
  Bench<TypeParam> bench(3, 0.5);
  Springs springs{{0, 2}, {{1, 0, 0}, {0, 2, 0}}, {8, 16}, {LoadShape::ramp, 0, 2}, {LoadShape::ramp, 0, 4},
                  {}};
  SpringLoad<BackendOf<TypeParam>, RealOf<TypeParam>> load(bench.backend, springs, bench.numbering,
                                                           bench.masses);
  bench.u[0] = {0.125, 0, 0.5};
  const auto& f = bench.forces(load, 1);  // k amplitude 1/2, target amplitude 1/4
  expect_near(f[0], {4 * (0.25 - 0.125), 0, -2}, 0);
  expect_near(f[2], {0, 8 * 0.5, 0}, 0);
  EXPECT_DOUBLE_EQ(load.stable_step(), 2 / std::sqrt(16 / 0.5));
}

TYPED_TEST(NodeLoads, SpringsOnOneNodeActTogether) {
  Bench<TypeParam> bench(3);
  Springs springs{{1, 1}, {{1, 0, 0}, {-1, 0, 0}}, {3, 1}, always, always, {}};
  SpringLoad<BackendOf<TypeParam>, RealOf<TypeParam>> load(bench.backend, springs, bench.numbering,
                                                           bench.masses);
  bench.u[1] = {0.25, 0, 0};
  expect_near(bench.forces(load)[1], {3 * 0.75 - 1.25, 0, 0}, 0);
}

TYPED_TEST(NodeLoads, SpringStiffnessFreezesAboveTheStrainEnergyCap) {
  Bench<TypeParam> bench(1);
  Springs springs{{0}, {{1, 0, 0}}, {4}, {LoadShape::ramp, 0, 4}, always, 10.0};
  SpringLoad<BackendOf<TypeParam>, RealOf<TypeParam>> load(bench.backend, springs, bench.numbering,
                                                           bench.masses);
  const auto pull = [&](double t, double strain_energy, bool advance = true) {
    auto step = bench.view(t, 1);
    step.strain_energy = strain_energy;
    step.advance = advance;
    return bench.forces(load, step)[0].x;
  };
  EXPECT_DOUBLE_EQ(pull(1, 5), 1);
  EXPECT_DOUBLE_EQ(pull(3, 5, false), 3);  // an evaluation on the side
  EXPECT_DOUBLE_EQ(pull(2, 10), 1);        // leaves no trace: the last step's value is kept
  const auto saved = load.save();
  SpringLoad<BackendOf<TypeParam>, RealOf<TypeParam>> resumed(bench.backend, springs, bench.numbering,
                                                              bench.masses);
  resumed.load(saved);
  EXPECT_DOUBLE_EQ(resumed.stiffness_amplitude(), 0.25);
  EXPECT_DOUBLE_EQ(pull(3, 11), 1);
  EXPECT_DOUBLE_EQ(pull(3, 9.9), 3);
}

/// Constant acceleration from rest: W = F u exactly at every step but for the half weight of step 0, F dt^2 /
/// (8 m) of path.
TYPED_TEST(NodeLoads, WorkOfAConstantForceIsForceTimesPath) {
  const double mass = 2, dt = 0.125;
  const Vec3<double> g{0, 3, -4};
  Bench<TypeParam> bench(1, mass);
  GravityLoad<BackendOf<TypeParam>, RealOf<TypeParam>> load(bench.backend, {{}, g, always}, bench.numbering,
                                                            bench.masses);
  for (int n = 0; n < 40; ++n) {
    bench.forces(load, bench.view(n * dt, dt));
    bench.advance(dt);
    auto side = bench.view(n * dt, dt);
    side.advance = false;
    load.add_forces(side);
  }
  const double t = 40 * dt, path = 5 * t * t / 2;
  auto last = bench.view(t, dt);
  load.add_forces(last);
  EXPECT_NEAR(load.work(), mass * 5 * (path - 5 * dt * dt / 8),
              1e-5 * mass * 5 * path * (sizeof(RealOf<TypeParam>) == 4 ? 1 : 1e-6));
}

/// An oscillator: KE(n) = m v(n-1/2).v(n+1/2)/2 changes by exactly the work of the spring.
TYPED_TEST(NodeLoads, WorkOfASpringBalancesTheKineticEnergy) {
  const double dt = 0.2;
  Bench<TypeParam> bench(1, 3);
  Springs springs{{0}, {{1, 2, -1}}, {5}, {LoadShape::ramp, 0, 10}, always, {}};
  SpringLoad<BackendOf<TypeParam>, RealOf<TypeParam>> load(bench.backend, springs, bench.numbering,
                                                           bench.masses);
  for (int n = 0; n < 60; ++n) {
    bench.forces(load, bench.view(n * dt, dt));
    const auto before = bench.v[0];
    bench.advance(dt);
    const double kinetic = 1.5 * dot(before, bench.v[0]);
    EXPECT_NEAR(load.work(), kinetic, 20 * bench.tolerance());
  }
}

TYPED_TEST(NodeLoads, CountingWorkDoesNotChangeTheForces) {
  Bench<TypeParam> bench(40, 0.3);
  Model model;
  std::vector<int> nodes(40);
  std::iota(nodes.begin(), nodes.end(), 0);
  model.forces.push_back({nodes, 7u, {0.7}, always});
  model.gravity.push_back({{}, {1, 2, 3}, always});
  model.springs.push_back({nodes, {{0.1, 0.7, 0}}, {2.3}, always, always, {}});
  const auto loads = make_loads<BackendOf<TypeParam>, RealOf<TypeParam>>(bench.backend, model,
                                                                         bench.numbering, bench.masses);
  for (std::size_t n = 0; n < 40; ++n) bench.u[n] = {0.1 * double(n), -0.3, 0.7};
  auto step = bench.view(1, 0.1);
  for (const auto& load : loads) bench.forces(*load, step);
  const auto counted = bench.f;
  step = bench.view(1, 0.1);
  step.monitor = false;
  for (const auto& load : loads) bench.forces(*load, step);
  for (std::size_t n = 0; n < 40; ++n) expect_near(bench.f[n], counted[n], 0);
}

TYPED_TEST(NodeLoads, RestartGivesTheSameBits) {
  Bench<TypeParam> bench(40, 0.3);
  Model model;
  std::vector<int> nodes(40);
  std::iota(nodes.begin(), nodes.end(), 0);
  model.forces.push_back({nodes, 7u, {0.7}, {LoadShape::hilly, 0, 1}});
  model.gravity.push_back({{}, {1, 2, 3}, {LoadShape::poly345, 0, 1}});
  model.springs.push_back({nodes, {{0.1, 0, 0}}, {2}, {}, {}, {}});
  const auto make = [&] {
    return make_loads<BackendOf<TypeParam>, RealOf<TypeParam>>(bench.backend, model, bench.numbering,
                                                               bench.masses);
  };
  auto loads = make(), resumed = make();
  const auto run = [&](auto& list, int from, int to) {
    for (bench.step_count = from; bench.step_count < to;) {
      auto step = bench.view(0.1 * double(bench.step_count), 0.1);
      for (auto& load : list) bench.forces(*load, step);
      bench.advance(0.1);
    }
  };
  run(loads, 0, 5);
  const auto u = bench.u, v = bench.v;
  for (std::size_t k = 0; k < loads.size(); ++k) resumed[k]->load(loads[k]->save());
  run(loads, 5, 10);
  const auto u_end = bench.u;
  bench.u = u, bench.v = v;
  run(resumed, 5, 10);
  for (std::size_t n = 0; n < u.size(); ++n) expect_near(bench.u[n], u_end[n], 0);
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
