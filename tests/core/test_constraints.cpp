// Fixed nodes, prescribed displacements, sliding planes; reactions and their work.
#include <glisson/core/constraints/constraints.hpp>

#include "load_bench.hpp"

namespace glisson {
namespace {

const LoadCurve always{LoadShape::step};
const LoadCurve ramp{LoadShape::ramp, 0, 2};

template <class C>
struct ConstraintBench : ::testing::Test {};
TYPED_TEST_SUITE(ConstraintBench, BenchCases);

/// u and v after the constraints of a model, at t_next = 1 after a step of 1/4 from amplitude A(3/4).
template <class C>
void apply(Bench<C>& bench, Constraints<BackendOf<C>, RealOf<C>>& constraints) {
  const auto u = bench.u, v = bench.v;
  for (const double t : {0.75, 1.0}) {
    bench.u = u, bench.v = v;
    bench.view(t, 0.25);
    constraints.apply(bench.device_u(), bench.device_v(), t, 0.25);
  }
  bench.get(bench.device_u(), bench.u);
  bench.get(bench.device_v(), bench.v);
}

TYPED_TEST(ConstraintBench, FixHoldsItsAxes) {
  Bench<TypeParam> bench(10);
  Model model;
  model.fixed = {{{2, 3}, all_axes}, {{4}, 2u}, {{4}, 4u}};
  for (auto& a : bench.u) a = {1, 2, 3};
  for (auto& a : bench.v) a = {4, 5, 6};
  Constraints<BackendOf<TypeParam>, RealOf<TypeParam>> constraints(bench.backend, model, bench.numbering);
  apply(bench, constraints);
  expect_near(bench.u[2], {}, 0);
  expect_near(bench.v[3], {}, 0);
  expect_near(bench.u[4], {1, 0, 0}, 0);
  expect_near(bench.v[4], {4, 0, 0}, 0);
  expect_near(bench.u[5], {1, 2, 3}, 0);
}

TYPED_TEST(ConstraintBench, PrescribedValuesAddUpAndBeatAFix) {
  Bench<TypeParam> bench(4);
  Model model;
  model.fixed = {{{0, 1}, all_axes}};
  model.displacements = {{{1, 2}, 1u, {0.5, 0.75}, ramp}, {{1}, 3u, {0.25}, always}};
  for (auto& a : bench.u) a = {9, 8, 7};
  Constraints<BackendOf<TypeParam>, RealOf<TypeParam>> constraints(bench.backend, model, bench.numbering);
  apply(bench, constraints);
  expect_near(bench.u[0], {}, 0);
  expect_near(bench.u[1], {0.5 * 0.5 + 0.25, 0.25, 0}, 0);
  expect_near(bench.v[1], {0.25, 0, 0}, 0);
  expect_near(bench.u[2], {0.375, 8, 7}, 0);
  expect_near(bench.v[2], {0.375, 0, 0}, 0);
}

TYPED_TEST(ConstraintBench, TheLastDisplacementIsTheOneInTheFile) {
  Bench<TypeParam> bench(1);
  Model model;
  model.displacements = {{{0}, 4u, {0.3}, {LoadShape::poly345, 0, 0.7}}};
  Constraints<BackendOf<TypeParam>, RealOf<TypeParam>> constraints(bench.backend, model, bench.numbering);
  bench.view(0, 0.1);
  constraints.apply(bench.device_u(), bench.device_v(), 7 * 0.1, 0.1);
  bench.get(bench.device_u(), bench.u);
  EXPECT_EQ(bench.u[0].z, double(RealOf<TypeParam>(0.3)));
}

TYPED_TEST(ConstraintBench, ManyCurvesGoThroughATable) {
  Bench<TypeParam> bench(40);
  Model model;
  for (int n = 0; n < 40; ++n)
    model.displacements.push_back({{n}, 1u, {1}, {LoadShape::table, 0, 1, false, {{0, 0}, {1, 0.25 * n}}}});
  Constraints<BackendOf<TypeParam>, RealOf<TypeParam>> constraints(bench.backend, model, bench.numbering);
  apply(bench, constraints);
  for (int n = 0; n < 40; ++n) {
    EXPECT_EQ(bench.u[std::size_t(n)].x, 0.25 * n);
    EXPECT_NEAR(bench.v[std::size_t(n)].x, 0.25 * n, 10 * bench.tolerance());
  }
}

TYPED_TEST(ConstraintBench, SlidingPlaneRemovesTheNormalPart) {
  Bench<TypeParam> bench(2);
  Model model;
  model.planes = {{{0}, {3, 4, 0}}};  // not unit: normalised
  bench.u[0] = bench.u[1] = {2, 1, 5};
  bench.v[0] = {-1, 1, 1};
  Constraints<BackendOf<TypeParam>, RealOf<TypeParam>> constraints(bench.backend, model, bench.numbering);
  apply(bench, constraints);
  expect_near(bench.u[0], {2 - 0.6 * 2, 1 - 0.8 * 2, 5}, 2 * bench.tolerance());
  expect_near(bench.v[0], {-1 - 0.6 * 0.2, 1 - 0.8 * 0.2, 1}, 2 * bench.tolerance());
  expect_near(bench.u[1], {2, 1, 5}, 0);
}

/// Everything at once on one node: each condition must hold, not only the last.
TYPED_TEST(ConstraintBench, PlanesFixesAndValuesHoldTogether) {
  Bench<TypeParam> bench(4);
  Model model;
  const Vec3<double> n{0.6, 0.8, 0}, m{0, 0.6, 0.8};
  model.planes = {{{0, 1, 2, 3}, n}, {{0, 2, 3}, m}, {{0}, n}, {{3}, {1, 0, 1}}};
  model.displacements = {{{1}, 1u, {0.5}, always}};
  model.fixed = {{{2}, 4u}};
  for (auto& a : bench.u) a = {2, 1, 5};
  Constraints<BackendOf<TypeParam>, RealOf<TypeParam>> constraints(bench.backend, model, bench.numbering);
  apply(bench, constraints);
  const double eps = 20 * bench.tolerance();
  EXPECT_NEAR(dot(bench.u[0], n), 0, eps);
  EXPECT_NEAR(dot(bench.u[0], m), 0, eps);
  EXPECT_GT(dot(bench.u[0], bench.u[0]), 1);       // it still slides along both
  expect_near(bench.u[1], {0.5, -0.375, 5}, eps);  // prescribed, and on the plane
  expect_near(bench.u[2], {}, eps);                // no direction left
  expect_near(bench.u[3], {}, eps);
}

/// Two masses, one pulled by a prescribed motion through a spring: the energies of the moving mass balance
/// with the work of the reaction at every step, jump of the velocity at the start included.
template <class C>
void check_reaction_work(const Model& model, bool restart) {
  using B = BackendOf<C>;
  using R = RealOf<C>;
  const double k = 30, dt = 0.1, m = 2;
  Bench<C> bench(2, m);
  auto constraints = std::make_unique<Constraints<B, R>>(bench.backend, model, bench.numbering);
  bench.v[1] = {0, 0.5, 0};
  const double start = 0.5 * m * 0.25;
  for (int n = 0; n < 50; ++n) {
    if (restart && n == 20) {
      const auto saved = constraints->save();
      constraints = std::make_unique<Constraints<B, R>>(bench.backend, model, bench.numbering);
      constraints->load(saved);
    }
    StepView<R> step = bench.view(n * dt, dt);
    const auto stretch = bench.u[1] - bench.u[0];
    const double strain_energy = 0.5 * k * dot(stretch, stretch);
    bench.put({k * stretch, -k * stretch}, bench.device_f(), false);
    const PlainStepper<R> stepper{R(n == 0 ? 0.5 * dt : dt), R(dt)};
    constraints->add_reactions(step, (n + 1) * dt, stepper);
    bench.get(bench.device_f(), bench.f);
    const auto before = bench.v;
    bench.advance(dt);
    const auto unconstrained = bench.u;
    bench.view(0, dt);
    constraints->apply(bench.device_u(), bench.device_v(), (n + 1) * dt, dt);
    bench.get(bench.device_u(), bench.u);
    bench.get(bench.device_v(), bench.v);
    for (int i = 0; i < 2; ++i)
      expect_near(bench.u[i], unconstrained[i], 100 * bench.tolerance());  // the reaction did it all
    const double kinetic = 0.5 * m * (dot(before[0], bench.v[0]) + dot(before[1], bench.v[1]));
    EXPECT_NEAR(kinetic + strain_energy - start, constraints->work(), 1000 * bench.tolerance()) << n;
  }
  EXPECT_GT(constraints->work(), 0.1);
}

TYPED_TEST(ConstraintBench, ReactionWorkClosesTheEnergyBalance) {
  Model model;
  model.displacements = {{{0}, all_axes, {1}, ramp}};
  for (const bool restart : {false, true}) check_reaction_work<TypeParam>(model, restart);
  model.displacements.push_back({{0}, 2u, {-0.5}, {LoadShape::poly345, 0.5, 3}});
  model.planes = {{{1}, {1, 0, 1}}};
  check_reaction_work<TypeParam>(model, false);
}

TYPED_TEST(ConstraintBench, ProjectionLeavesTheFreePart) {
  Bench<TypeParam> bench(3);
  Model model;
  model.displacements = {{{0}, 1u, {1}, always}};
  model.planes = {{{1}, {0, 0, 2}}};
  model.initial_velocities = {{{0, 1, 2}, {1, 2, 3}}, {{2}, {0, 0, 4}}};
  Constraints<BackendOf<TypeParam>, RealOf<TypeParam>> constraints(bench.backend, model, bench.numbering);
  const auto v0 = initial_velocity(model, bench.numbering);
  for (int n = 0; n < 3; ++n)
    bench.v[std::size_t(n)] = v0[std::size_t(bench.numbering.internal_of_user[std::size_t(n)])];
  bench.view(0, 1);
  constraints.project(bench.device_v());
  bench.get(bench.device_v(), bench.v);
  expect_near(bench.v[0], {0, 2, 3}, 0);
  expect_near(bench.v[1], {1, 2, 0}, 0);
  expect_near(bench.v[2], {0, 0, 4}, 0);
}

TEST(ConstraintInput, RejectsWhatCannotBe) {
  const auto numbering = shuffled_numbering(3);
  Model model;
  model.fixed = {{{3}, all_axes}};
  EXPECT_THROW(make_constraint_list(model, numbering), Error);
  model.fixed.clear();
  model.planes = {{{0}, {0, 0, 0}}};
  EXPECT_THROW(make_constraint_list(model, numbering), Error);
  model.planes.clear();
  model.displacements = {{{0, 1, 2}, 1u, {1, 2}, always}};
  EXPECT_THROW(make_constraint_list(model, numbering), Error);
}

}  // namespace
}  // namespace glisson
