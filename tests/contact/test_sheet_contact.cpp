// Membranes in contact: with solids, with each other, with rigid surfaces, as skins.
#include <gtest/gtest.h>

#include <glisson/core/mesh/triangles.hpp>

#include <tests/contact/sheets.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

class SheetContacts : public Matrix {};  ///< too long for the emulated device
class SheetContactsEverywhere : public Matrix {};

/// What a run of two bodies did.
struct Meeting {
  double least = 1e300;  ///< distance between them [m]
  int crossings = 0;
  double lost = 0;  ///< momentum over mass [m/s]
  Vec3<double> velocity_a, velocity_b;
  ContactReport report;
};
Meeting meet(const Model& model, const Body& a, const Body& b, const Case& c, int every = 5) {
  const auto mass = lumped_mass(model);
  const Body all{0, model.mesh.node_count()};
  const Triangles of_a = triangles_of(model.mesh, a), of_b = triangles_of(model.mesh, b);
  auto simulation = simulate(model, c);
  const auto before = mean_of(simulation->velocity(), all, mass);
  Meeting result;
  while (!simulation->finished()) {
    simulation->step(every);
    const auto x = positions(*simulation, model.mesh);
    result.least = std::min(result.least, least_distance(x, of_a, of_b));
    result.crossings += crossings(x, of_a, of_b);
  }
  const auto lost = mean_of(simulation->velocity(), all, mass) - before;
  result.lost = std::sqrt(dot(lost, lost));
  result.velocity_a = mean_of(simulation->velocity(), a, mass);
  result.velocity_b = mean_of(simulation->velocity(), b, mass);
  result.report = simulation->contacts().at(0).report;
  return result;
}

constexpr double edge = 0.2 / 12;  ///< of the sheets below

/// A ball of radius 0.05 thrown at the middle of a sheet, from above (side 1) or below (-1).
Model trampoline(double thickness, double side, double speed) {
  Model model;
  Mesh ball = ball_mesh(3);
  for (auto& X : ball.X) X = 0.05 * X;
  move(ball, {0.003, 0.002, side * (0.0505 + 0.5 * thickness)});
  const Body thrown = add_body(model, ball, Formulation::t4, {"NH", mu_kappa(3e5, 0.3), 1000});
  const Body net = add_flat_sheet(
      model, 12, 0.2, 0,
      membrane_section("NeoHookean", {2e5 * 0.002 / thickness}, thickness, 1000 * 0.002 / thickness));
  std::vector<int> border;
  for (const int n : net.nodes()) {
    const auto& X = model.mesh.X[std::size_t(n)];
    if (std::max(std::abs(X.x), std::abs(X.y)) > 0.0999) border.push_back(n);
  }
  model.fixed.push_back({border, all_axes});
  model.initial_velocities.push_back({thrown.nodes(), {0, 0, -side * speed}});
  model.contact.between_bodies = true;
  model.time.total = 0.16;
  return model;
}

/// The ball comes back, and its surface stays half a thickness away from the middle of the sheet.
TEST_P(SheetContacts, ABallComesBackFromATrampoline) {
  for (const double side : {1.0, -1.0}) {
    const Model model = trampoline(0.002, side, 1);
    const Body ball{0, model.mesh.node_count() - 169}, net{ball.node_count, 169};
    const Meeting its = meet(model, ball, net, GetParam(), 10);
    EXPECT_EQ(its.crossings, 0) << "side " << side;
    EXPECT_GT(its.least, 0.5 * 0.002 - 0.02 * edge) << "side " << side;
    EXPECT_LT(its.least, 0.5 * 0.002 + 0.02 * edge) << "side " << side;
    EXPECT_GT(side * its.velocity_a.z, 0.5) << "side " << side;
  }
}

/// A hundredth of an edge thick: depths of the ball are as large as the thickness, and it still does not
/// pass.
TEST(SheetContactCases, ABallDoesNotPassAThinSheet) {
  const Model model = trampoline(0.01 * edge, 1, 2);
  const Body ball{0, model.mesh.node_count() - 169}, net{ball.node_count, 169};
  const Meeting its = meet(model, ball, net, threads_float);
  EXPECT_GT(its.velocity_a.z, 0.5);
  EXPECT_LT(its.report.largest_depth, 0.05 * edge);
}

/// A sheet that flies at a block, tilted and spinning.
Model thrown_sheet(double friction) {
  Model model;
  add_body(model, box_mesh({8, 8, 3}, {0.16, 0.16, 0.06}, Shape::tetrahedron, 0.1), Formulation::t4,
           {"NH", mu_kappa(1e5, 0.3), 1000});
  for (auto& X : model.mesh.X) X = X - Vec3<double>{0.08, 0.08, 0.06};
  const double h = 0.003, tilt = 0.1;
  const Body thrown = add_sheet(
      model, 12, 12,
      [=](double s, double t) {
        return Vec3<double>{0.2 * (s - 0.5), 0.2 * (t - 0.5), 0.013 + tilt * 0.2 * (s - 0.5)};
      },
      membrane_section("NeoHookean", {5e4}, h));
  for (const int n : thrown.nodes()) {
    const auto& X = model.mesh.X[std::size_t(n)];
    model.initial_velocities.push_back({{n}, {0.5, 0.2 + 2 * X.x, -1}});
  }
  model.contact.between_bodies = true;
  model.contact.friction = friction;
  model.time.total = 0.05;
  return model;
}

TEST_P(SheetContactsEverywhere, AThrownSheetKeepsMomentumAndDoesNotPass) {
  const Model model = thrown_sheet(0.3);
  const Body block{0, 9 * 9 * 4}, thrown{block.node_count, 169};
  const Meeting its = meet(model, block, thrown, GetParam());
  EXPECT_EQ(its.crossings, 0);
  EXPECT_LT(its.lost, GetParam().rounding());
  EXPECT_GT(its.least, 0.5 * 0.003 - 0.05 * 0.02);  // edge of the block
  EXPECT_LT(its.velocity_a.z, -0.01) << "nothing was touched";
}

TEST(SheetContactThreads, GiveTheSameBitsForAnyNumber) {
  Model model = thrown_sheet(0.3);
  model.time.total = 0.02;
  expect_same_bits_for_any_threads(model, threads_float, 60);
}

TEST_P(SheetContactsEverywhere, AResumedRunEndsWithTheSameBits) {
  const auto [whole, resumed] = expect_same_bits_resumed(thrown_sheet(0.3), GetParam(), 60, 20);
  EXPECT_GT(whole->contacts().at(0).report.largest_depth, 0) << "nothing was touched";
}

/// Two free sheets of different meshes, one of them wavy, thrown at each other.
Model two_sheets(double h) {
  Model model;
  const ShellSection skin = membrane_section("NeoHookean", {5e4}, h);
  const Body lower = add_flat_sheet(model, 12, 0.2, 0, skin);
  const Body upper = add_sheet(
      model, 10, 9,
      [=](double s, double t) {
        return Vec3<double>{0.15 * (s - 0.6), 0.17 * (t - 0.45), 0.012 + 0.01 * std::sin(6 * s) * s * t};
      },
      skin);
  model.initial_velocities.push_back({lower.nodes(), {0, 0, 0.5}});
  model.initial_velocities.push_back({upper.nodes(), {0.1, 0, -0.5}});
  model.contact.between_bodies = true;
  model.time.total = 0.06;
  return model;
}

TEST_P(SheetContacts, TwoSheetsStayTheirThicknessApart) {
  for (const double h : {0.004, 0.001}) {
    const Model model = two_sheets(h);
    const Body lower{0, 169}, upper{169, 110};
    const Meeting its = meet(model, lower, upper, GetParam());
    EXPECT_EQ(its.crossings, 0) << h;
    EXPECT_GT(its.least, h - 0.05 * edge) << h << " " << its.report.largest_depth;
    EXPECT_LT(its.lost, GetParam().rounding()) << h;
    EXPECT_LT(its.velocity_a.z, 0.2) << "nothing was touched";
  }
}

/// Two borders that cross, no node near a facet: a sheet that stands on its tip falls past the border of a
/// level one.
TEST_P(SheetContactsEverywhere, BordersThatCrossHoldEachOther) {
  Model model;
  const double h = 0.004;
  const ShellSection skin = membrane_section("NeoHookean", {5e4}, h);
  const Body level = add_sheet(
      model, 6, 6,
      [](double s, double t) {
        return Vec3<double>{0.1 * (s - 0.5), 0.1 * (t - 1), 0};
      },
      skin);
  const Body falling = add_sheet(
      model, 6, 6,
      [](double s, double t) {
        const double along = 0.12 * (s - 0.5), up = 0.1 * t;  // the lower border falls towards +y
        return Vec3<double>{0.008, 0.8 * along + 0.6 * up, 0.006 - 0.6 * along + 0.8 * up};
      },
      skin);
  model.fixed.push_back({level.nodes(), all_axes});
  model.initial_velocities.push_back({falling.nodes(), {0, 0, -0.5}});
  model.contact.between_bodies = true;
  model.time.total = 0.03;
  const Meeting its = meet(model, level, falling, GetParam());
  EXPECT_EQ(its.crossings, 0);
  EXPECT_GT(its.report.largest_depth, 0) << "nothing was touched";
}

/// 3 x 3 cells below and 4 x 4 above a sheet of 5 x 5; nu = 0, so that all three keep their borders together.
TEST_P(SheetContacts, AUniformStressPassesASheetBetweenBlocks) {
  for (const auto& [shape, formulation] :
       {std::pair{Shape::tetrahedron, Formulation::t4}, std::pair{Shape::hexahedron, Formulation::h8}}) {
    Model model;
    const double h = 0.05;
    const Material rubber{"NH", mu_kappa(3000, 0), 1000};
    add_body(model, box_mesh({3, 3, 2}, {1, 1, 0.5}, shape), formulation, rubber);
    Mesh upper = box_mesh({4, 4, 3}, {1, 1, 0.5}, shape);
    move(upper, {0, 0, 0.5 + h});
    add_body(model, upper, formulation, rubber);
    const Body between = add_sheet(
        model, 5, 5,
        [=](double s, double t) {
          return Vec3<double>{s, t, 0.5 + 0.5 * h};
        },
        membrane_section("NeoHookean", {3000}, h));
    model.fixed.push_back({face(model.mesh, 2, 0), 4});
    model.fixed.push_back({face(model.mesh, 0, 0), 1});
    model.fixed.push_back({face(model.mesh, 1, 0), 2});
    model.fixed.push_back({between.nodes(), 3});
    model.displacements.push_back({face(model.mesh, 2, 1 + h), 4, {-0.05}, ramp_curve(1)});
    model.contact.between_bodies = true;
    model.time = relaxed();
    auto simulation = simulate(model, GetParam());
    while (!simulation->finished()) simulation->step(100);
    double low = 1e30, high = -1e30;
    for (const auto& s : simulation->element_fields().stress) {
      low = std::min(low, s.zz);
      high = std::max(high, s.zz);
    }
    EXPECT_LT(low, -100);
    EXPECT_NEAR(high / low, 1, 0.01) << low << " " << high << " " << name_of(formulation);
  }
}

/// A skin on one of two blocks that are thrown at each other keeps them half of its thickness apart.
TEST_P(SheetContactsEverywhere, ASkinMovesTheSurfaceOutByHalfItsThickness) {
  for (const bool skinned : {true, false}) {
    Model model;
    const double h = 0.2;
    const Material rubber{"NH", mu_kappa(3000, 0.3), 1000};
    add_body(model, box_mesh({3, 3, 3}, {1, 1, 1}, Shape::hexahedron), Formulation::h8, rubber);
    const Body lower{0, model.mesh.node_count()};
    Mesh upper = box_mesh({2, 2, 2}, {0.7, 0.7, 0.7}, Shape::tetrahedron);
    move(upper, {0.1, 0.12, 1.15});
    const Body thrown = add_body(model, upper, Formulation::t4, rubber);
    if (skinned) {
      const auto facets = outer_surface(model.mesh);
      for (const Facet& f : facets)
        if (f.node_count() == 4) append_triangles(f, model.mesh.X, model.mesh.triangles);
      ShellSection skin = membrane_section("NeoHookean", {3000}, h);
      skin.elements.resize(model.mesh.triangles.size());
      std::iota(skin.elements.begin(), skin.elements.end(), 0);
      model.shells.push_back(skin);
    }
    model.initial_velocities.push_back({thrown.nodes(), {0, 0, -0.2}});
    model.contact.between_bodies = true;
    model.time.total = 1.2;
    const Meeting its = meet(model, lower, thrown, GetParam(), 2);
    const double expected = skinned ? 0.5 * h : 0;
    EXPECT_NEAR(its.least, expected, 0.01);
    EXPECT_LT(its.lost, GetParam().rounding());
    EXPECT_GT(its.velocity_b.z, -0.15) << "nothing was touched";
  }
}

/// A sheet whose two parts turn towards each other like a closing book, with a twist.
TEST_P(SheetContacts, AFoldingSheetDoesNotGoThroughItself) {
  Model model;
  const double length = 0.4, h = 0.004;
  const Body all = add_sheet(
      model, 40, 6,
      [=](double s, double t) {
        return Vec3<double>{length * s, 0.06 * t, 0};
      },
      membrane_section("NeoHookean", {5e3}, h));
  for (const int n : all.nodes()) {
    const double s = model.mesh.X[std::size_t(n)].x / length - 0.45;
    model.initial_velocities.push_back({{n}, {0, 0.1 * s, 2 * std::abs(s)}});
  }
  model.contact.self = true;
  model.time.total = 0.5;
  const auto mass = lumped_mass(model);
  const Triangles its = triangles_of(model.mesh, all);
  auto simulation = simulate(model, GetParam());
  const auto before = mean_of(simulation->velocity(), all, mass);
  int through = 0;
  while (!simulation->finished()) {
    simulation->step(10);
    through += crossings(positions(*simulation, model.mesh), its, its);
  }
  const auto lost = mean_of(simulation->velocity(), all, mass) - before;
  EXPECT_EQ(through, 0);
  EXPECT_LT(std::sqrt(dot(lost, lost)), GetParam().rounding());
  EXPECT_GT(simulation->contacts().at(0).report.largest_depth, 0) << "nothing was touched";
}

/// A free sheet falls on a rigid floor and stays half of its thickness above it.
TEST_P(SheetContactsEverywhere, ARigidFloorHoldsASheetAtHalfItsThickness) {
  Model model;
  const double h = 0.004;
  add_flat_sheet(model, 12, 0.2, 0.003, membrane_section("NeoHookean", {5e4}, h));
  RigidSurface floor;
  floor.name = "floor";
  floor.surface.X = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  floor.surface.facets = {{{0, 1, 2, 3}}};
  model.surfaces.push_back(floor);
  model.initial_velocities.push_back({Body{0, 169}.nodes(), {0, 0, -0.1}});
  model.gravity.push_back({{}, {0, 0, -9.81}, step_curve(1)});
  model.time.total = 0.05;
  auto simulation = simulate(model, GetParam());
  double lowest = 1;
  while (!simulation->finished()) {
    simulation->step(10);
    for (const auto& x : positions(*simulation, model.mesh)) lowest = std::min(lowest, x.z);
  }
  EXPECT_NEAR(lowest, 0.5 * h, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(All, SheetContacts, testing::Values(serial_double, threads_float, cuda_float),
                         case_name);
GLISSON_ALL_CASES(SheetContactsEverywhere);

TEST(SheetContactInput, WhatGoesThroughASheetAtTheStartIsRefused) {
  Model model;
  add_body(model, box_mesh({2, 2, 2}, {0.1, 0.1, 0.1}, Shape::tetrahedron), Formulation::t4,
           {"NH", mu_kappa(3000, 0.3), 1000});
  add_flat_sheet(model, 6, 0.2, 0.03, membrane_section("NeoHookean", {5e4}, 0.001));
  model.contact.between_bodies = true;
  model.time.total = 1;
  try {
    simulate(model, serial_double);
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("goes through the membrane"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace glisson::test
