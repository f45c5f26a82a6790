// Self-contact of solids: a sheet that folds, the "C" that closes (Johnsen 2016, figure 5.10).
#include <gtest/gtest.h>

#include <bench/contact_shapes.hpp>
#include <tests/contact/bodies.hpp>
#include <tests/contact/overlap_check.hpp>

namespace glisson::test {
namespace {

class SelfContacts : public Matrix {};

constexpr double sheet_length = 0.4, sheet_edge = 0.01, sheet_thickness = 0.005, sheet_speed = 1;

/// A sheet of 40 x 6 x 1 cells that flies freely, its two parts turning towards each other like a closing
/// book, with a twist.
Model folding_sheet(Formulation formulation, bool self) {
  Model model;
  const Mesh mesh = box_mesh({40, 6, 1}, {sheet_length, 0.06, sheet_thickness}, shape_of(formulation));
  add_body(model, mesh, formulation, {"NH", mu_kappa(1e4, 0.3), 1000});
  for (int n = 0; n < mesh.node_count(); ++n) {
    const auto& X = mesh.X[std::size_t(n)];
    const double s = X.x / sheet_length - 0.45, up = X.z / sheet_length - 0.00625;
    model.initial_velocities.push_back(
        {{n}, sheet_speed * Vec3<double>{(s > 0 ? -2 : 2) * up, 0.1 * s, 2 * std::abs(s)}});
  }
  model.contact.self = self;
  model.time.total = 1;
  return model;
}

struct Fold {
  double overlap = 0;  ///< largest over the run [m]
  double lost = 0;     ///< momentum, per sum of masses times speed [-]
  ContactReport report;
};
Fold fold(const Model& model, const Case& c) {
  const auto mass = lumped_mass(model);
  const Body all{0, model.mesh.node_count()};
  OverlapCheck check(model.mesh);
  auto simulation = simulate(model, c);
  const auto before = mean_of(simulation->velocity(), all, mass);
  Fold result;
  while (!simulation->finished()) {
    simulation->step(20);
    result.overlap = std::max(result.overlap, check.deepest(positions(*simulation, model.mesh)));
  }
  const auto lost = mean_of(simulation->velocity(), all, mass) - before;
  result.lost = std::sqrt(dot(lost, lost)) / sheet_speed;
  if (model.contact.self) result.report = simulation->contacts().at(0).report;
  return result;
}

void expect_apart(Formulation formulation, const Case& c) {
  const Fold its = fold(folding_sheet(formulation, true), c);
  EXPECT_LT(its.overlap, 0.05 * sheet_edge);
  EXPECT_GT(its.report.largest_depth, 0) << "nothing was touched";
  EXPECT_LT(its.lost, c.rounding());
}

TEST_P(SelfContacts, OfAFoldingSheetHoldItsSidesApartAndKeepMomentum) {
  expect_apart(Formulation::t4, GetParam());
}
TEST(SelfContactCases, ASheetOfHexahedraHoldsItsSidesApartAndKeepsMomentum) {
  expect_apart(Formulation::h8, threads_float);
}

TEST(SelfContactCases, WithoutContactTheFoldingSheetGoesThroughItself) {
  EXPECT_GT(fold(folding_sheet(Formulation::t4, false), threads_float).overlap, 0.4 * sheet_thickness);
}

/// G, K, rho, time and step of figure 5.10; the upper part moves down by more than the gap is wide.
TEST_P(SelfContacts, OfTheCThatClosesHoldItsEndsApart) {
  Model model;
  const Mesh mesh = bench::c_shape();
  add_body(model, mesh, Formulation::t4, {"NH", {10, 40}, 1});
  model.fixed.push_back({nodes_where(mesh, [](const auto& X) { return X.z < -6; }), all_axes});
  const auto upper = nodes_where(mesh, [](const auto& X) { return X.z > 6; });
  model.displacements.push_back({upper, 4, {-3.5}, ramp_curve(2)});
  model.fixed.push_back({upper, 3});
  model.contact.self = true;
  model.time.total = 2;
  model.time.step = 0.001;
  auto simulation = simulate(model, GetParam());
  OverlapCheck check(mesh);
  double overlap = 0;
  while (!simulation->finished()) {
    simulation->step(50);
    overlap = std::max(overlap, check.deepest(positions(*simulation, mesh)));
  }
  const ContactReport report = simulation->contacts().at(0).report;
  EXPECT_GT(report.node_count, 0) << "nothing touches";
  constexpr double edge = 5.5 / 4;  // of the cells across the ring
  EXPECT_LT(overlap, 0.05 * edge);
  EXPECT_LT(report.largest_depth, 0.05 * edge);
}

INSTANTIATE_TEST_SUITE_P(All, SelfContacts, testing::Values(serial_double, threads_float, cuda_float),
                         case_name);

}  // namespace
}  // namespace glisson::test
