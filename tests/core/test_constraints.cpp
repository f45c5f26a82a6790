// Fixed nodes, prescribed displacements, sliding planes; reactions and their work.
#include <glisson/core/base/error.hpp>
#include <glisson/core/constraints/constraint_list.hpp>

#include "tests/core/constrained_nodes.hpp"

namespace glisson {
namespace {

const LoadCurve always{LoadShape::step};
const LoadCurve ramp{LoadShape::ramp, 0, 2};

using ConstraintBench = BenchTest;
GLISSON_BENCH_CASES(ConstraintBench);

/// u and v after the constraints of a model, at t_next = 1 after a step of 1/4 from amplitude A(3/4).
void apply(ConstrainedNodes& bench) {
  const auto u = bench.u, v = bench.v;
  for (const double t : {0.75, 1.0}) {
    bench.u = u, bench.v = v;
    bench.apply(t, 0.25);
  }
}

TEST_P(ConstraintBench, FixHoldsItsAxes) {
  const auto bench = constrained_nodes(GetParam(), 10);
  Model model;
  model.fixed = {{{2, 3}, all_axes}, {{4}, 2u}, {{4}, 4u}};
  for (auto& a : bench->u) a = {1, 2, 3};
  for (auto& a : bench->v) a = {4, 5, 6};
  bench->constrain(model);
  apply(*bench);
  expect_near(bench->u[2], {}, 0);
  expect_near(bench->v[3], {}, 0);
  expect_near(bench->u[4], {1, 0, 0}, 0);
  expect_near(bench->v[4], {4, 0, 0}, 0);
  expect_near(bench->u[5], {1, 2, 3}, 0);
}

TEST_P(ConstraintBench, PrescribedValuesAddUpAndBeatAFix) {
  const auto bench = constrained_nodes(GetParam(), 4);
  Model model;
  model.fixed = {{{0, 1}, all_axes}};
  model.displacements = {{{1, 2}, 1u, {0.5, 0.75}, ramp}, {{1}, 3u, {0.25}, always}};
  for (auto& a : bench->u) a = {9, 8, 7};
  bench->constrain(model);
  apply(*bench);
  expect_near(bench->u[0], {}, 0);
  expect_near(bench->u[1], {0.5 * 0.5 + 0.25, 0.25, 0}, 0);
  expect_near(bench->v[1], {0.25, 0, 0}, 0);
  expect_near(bench->u[2], {0.375, 8, 7}, 0);
  expect_near(bench->v[2], {0.375, 0, 0}, 0);
}

TEST_P(ConstraintBench, TheLastDisplacementIsTheOneInTheFile) {
  const auto bench = constrained_nodes(GetParam(), 1);
  Model model;
  model.displacements = {{{0}, 4u, {0.3}, {LoadShape::poly345, 0, 0.7}}};
  bench->constrain(model);
  bench->apply(7 * 0.1, 0.1);
  EXPECT_EQ(bench->u[0].z, in_float(GetParam()) ? double(0.3f) : 0.3);
}

TEST_P(ConstraintBench, ManyCurvesGoThroughATable) {
  const auto bench = constrained_nodes(GetParam(), 40);
  Model model;
  for (int n = 0; n < 40; ++n)
    model.displacements.push_back({{n}, 1u, {1}, {LoadShape::table, 0, 1, false, {{0, 0}, {1, 0.25 * n}}}});
  bench->constrain(model);
  apply(*bench);
  for (int n = 0; n < 40; ++n) {
    EXPECT_EQ(bench->u[std::size_t(n)].x, 0.25 * n);
    EXPECT_NEAR(bench->v[std::size_t(n)].x, 0.25 * n, 10 * bench->tolerance());
  }
}

TEST_P(ConstraintBench, SlidingPlaneRemovesTheNormalPart) {
  const auto bench = constrained_nodes(GetParam(), 2);
  Model model;
  model.planes = {{{0}, {3, 4, 0}}};  // not unit: normalised
  bench->u[0] = bench->u[1] = {2, 1, 5};
  bench->v[0] = {-1, 1, 1};
  bench->constrain(model);
  apply(*bench);
  expect_near(bench->u[0], {2 - 0.6 * 2, 1 - 0.8 * 2, 5}, 2 * bench->tolerance());
  expect_near(bench->v[0], {-1 - 0.6 * 0.2, 1 - 0.8 * 0.2, 1}, 2 * bench->tolerance());
  expect_near(bench->u[1], {2, 1, 5}, 0);
}

/// Everything at once on one node: each condition must hold, not only the last.
TEST_P(ConstraintBench, PlanesFixesAndValuesHoldTogether) {
  const auto bench = constrained_nodes(GetParam(), 4);
  Model model;
  const Vec3<double> n{0.6, 0.8, 0}, m{0, 0.6, 0.8};
  model.planes = {{{0, 1, 2, 3}, n}, {{0, 2, 3}, m}, {{0}, n}, {{3}, {1, 0, 1}}};
  model.displacements = {{{1}, 1u, {0.5}, always}};
  model.fixed = {{{2}, 4u}};
  for (auto& a : bench->u) a = {2, 1, 5};
  bench->constrain(model);
  apply(*bench);
  const double eps = 20 * bench->tolerance();
  EXPECT_NEAR(dot(bench->u[0], n), 0, eps);
  EXPECT_NEAR(dot(bench->u[0], m), 0, eps);
  EXPECT_GT(dot(bench->u[0], bench->u[0]), 1);      // it still slides along both
  expect_near(bench->u[1], {0.5, -0.375, 5}, eps);  // prescribed, and on the plane
  expect_near(bench->u[2], {}, eps);                // no direction left
  expect_near(bench->u[3], {}, eps);
}

/// Two masses, one pulled by a prescribed motion through a spring: the energies of the moving mass balance
/// with the work of the reaction at every step, jump of the velocity at the start included.
void check_reaction_work(BenchCase row, const Model& model, bool restart) {
  const double k = 30, dt = 0.1, m = 2;
  const auto bench = constrained_nodes(row, 2, m);
  bench->constrain(model);
  bench->v[1] = {0, 0.5, 0};
  const double start = 0.5 * m * 0.25;
  for (int n = 0; n < 50; ++n) {
    if (restart && n == 20) {
      const auto saved = bench->save();
      bench->constrain(model);
      bench->load(saved);
    }
    const auto stretch = bench->u[1] - bench->u[0];
    const double strain_energy = 0.5 * k * dot(stretch, stretch);
    bench->react({k * stretch, -k * stretch}, n * dt, (n + 1) * dt, dt);
    const auto before = bench->v;
    bench->advance(dt);
    const auto unconstrained = bench->u;
    bench->apply((n + 1) * dt, dt);
    for (int i = 0; i < 2; ++i)
      expect_near(bench->u[i], unconstrained[i], 100 * bench->tolerance());  // the reaction did it all
    const double kinetic = 0.5 * m * (dot(before[0], bench->v[0]) + dot(before[1], bench->v[1]));
    EXPECT_NEAR(kinetic + strain_energy - start, bench->work(), 1000 * bench->tolerance()) << n;
  }
  EXPECT_GT(bench->work(), 0.1);
}

TEST_P(ConstraintBench, ReactionWorkClosesTheEnergyBalance) {
  Model model;
  model.displacements = {{{0}, all_axes, {1}, ramp}};
  for (const bool restart : {false, true}) check_reaction_work(GetParam(), model, restart);
  model.displacements.push_back({{0}, 2u, {-0.5}, {LoadShape::poly345, 0.5, 3}});
  model.planes = {{{1}, {1, 0, 1}}};
  check_reaction_work(GetParam(), model, false);
}

TEST_P(ConstraintBench, ProjectionLeavesTheFreePart) {
  const auto bench = constrained_nodes(GetParam(), 3);
  Model model;
  model.displacements = {{{0}, 1u, {1}, always}};
  model.planes = {{{1}, {0, 0, 2}}};
  model.initial_velocities = {{{0, 1, 2}, {1, 2, 3}}, {{2}, {0, 0, 4}}};
  bench->constrain(model);
  const auto v0 = initial_velocity(model, bench->numbering);
  for (int n = 0; n < 3; ++n)
    bench->v[std::size_t(n)] = v0[std::size_t(bench->numbering.internal_of_user[std::size_t(n)])];
  bench->project();
  expect_near(bench->v[0], {0, 2, 3}, 0);
  expect_near(bench->v[1], {1, 2, 0}, 0);
  expect_near(bench->v[2], {0, 0, 4}, 0);
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
