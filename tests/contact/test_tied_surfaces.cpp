// Glued surfaces whose meshes do not match: stress, stiffness, momentum, restart, what is refused.
#include <gtest/gtest.h>

#include <tests/contact/sheets.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

class TiedBodies : public Matrix {};
class TiedBeams : public Matrix {};  ///< too long for the emulated device

void tie(Model& model, std::size_t a, std::size_t b) {
  model.ties.push_back({"tie", model.bodies_by_name[a].name, model.bodies_by_name[b].name, {}});
}

/// Two blocks on each other, 3 x 3 and 4 x 4 cells at the interface, pulled by 5 %, sides free.
Model pulled_blocks(Shape lower, Shape upper) {
  const auto formulation = [](Shape s) {
    return s == Shape::tetrahedron ? Formulation::t4 : Formulation::h8;
  };
  Model model;
  const Material rubber{"NH", mu_kappa(3000, 0.3), 1000};
  add_body(model, box_mesh({3, 3, 2}, {1, 1, 0.5}, lower), formulation(lower), rubber);
  Mesh second = box_mesh({4, 4, 3}, {1, 1, 0.5}, upper);
  move(second, {0, 0, 0.5});
  add_body(model, second, formulation(upper), rubber);
  model.fixed.push_back({face(model.mesh, 2, 0), 4});
  model.fixed.push_back({face(model.mesh, 0, 0), 1});
  model.fixed.push_back({face(model.mesh, 1, 0), 2});
  model.displacements.push_back({face(model.mesh, 2, 1), 4, {0.05}, ramp_curve(1)});
  tie(model, 1, 0);
  model.time = relaxed();
  return model;
}

TEST_P(TiedBodies, AUniformTensionPassesAnInterfaceThatDoesNotMatch) {
  for (const Shape lower : {Shape::tetrahedron, Shape::hexahedron})
    for (const Shape upper : {Shape::tetrahedron, Shape::hexahedron}) {
      const Model model = pulled_blocks(lower, upper);
      auto simulation = simulate(model, GetParam());
      while (!simulation->finished()) simulation->step(100);
      double low = 1e30, high = -1e30;
      for (const auto& s : simulation->element_fields().stress) {
        low = std::min(low, s.zz);
        high = std::max(high, s.zz);
      }
      EXPECT_NEAR(low / high, 1, 0.01) << int(lower) << int(upper);
      EXPECT_GT(low, 100);
    }
}

/// A beam of 0.4 x 0.1 x 0.1 m held at x = 0 under a load across; in one piece, or glued in the middle.
double deflection(const std::vector<Mesh>& pieces, const Case& c) {
  Model model;
  for (const Mesh& piece : pieces)
    add_body(model, piece, Formulation::h8_full, {"NH", mu_kappa(1e5, 0.3), 1000});
  for (std::size_t k = 1; k < pieces.size(); ++k) tie(model, k, k - 1);
  model.fixed.push_back({face(model.mesh, 0, 0), all_axes});
  const auto end = face(model.mesh, 0, 0.4);
  model.forces.push_back({end, 4, {-0.1 / double(end.size())}, ramp_curve(1)});
  model.time = relaxed();
  const auto u = final_displacement(model, c);
  double mean = 0;
  for (const int n : end) mean += u[std::size_t(n)].z / double(end.size());
  return mean;
}

Mesh half_beam(std::array<int, 3> cells, double from) {
  Mesh mesh = box_mesh(cells, {0.2, 0.1, 0.1}, Shape::hexahedron);
  move(mesh, {from, 0, 0});
  return mesh;
}

TEST_P(TiedBeams, AGluedCantileverBendsLikeOneInOnePiece) {
  const Case& c = GetParam();
  const double whole = deflection({box_mesh({16, 4, 4}, {0.4, 0.1, 0.1}, Shape::hexahedron)}, c);
  const double matching = deflection({half_beam({8, 4, 4}, 0), half_beam({8, 4, 4}, 0.2)}, c);
  const double uneven = deflection({half_beam({8, 4, 4}, 0), half_beam({10, 5, 5}, 0.2)}, c);
  EXPECT_NEAR(matching / whole, 1, 1e-3);
  EXPECT_NEAR(uneven / whole, 1, 0.02);
}

/// Two blocks that would fly apart and spin, in free flight.
Model spinning_pair() {
  Model model = pulled_blocks(Shape::tetrahedron, Shape::hexahedron);
  model.fixed.clear();
  model.displacements.clear();
  for (int n = 0; n < model.mesh.node_count(); ++n) {
    const auto& X = model.mesh.X[std::size_t(n)];
    model.initial_velocities.push_back({{n}, {0.3 * X.z, -0.2 * X.z, X.z > 0.5 ? 0.1 : -0.1}});
  }
  model.time = {};
  model.time.total = 2;
  return model;
}

TEST_P(TiedBodies, StayTogetherAndKeepMomentum) {
  const Model model = spinning_pair();
  const auto mass = lumped_mass(model);
  const Body all{0, model.mesh.node_count()};
  auto simulation = simulate(model, GetParam());
  const auto before = mean_of(simulation->velocity(), all, mass);
  double apart = 0;
  while (!simulation->finished()) {
    simulation->step(20);
    const auto u = simulation->displacement();
    // both meshes have these corners of the interface
    for (const auto& [a, b] : {std::pair{32, 48}, std::pair{47, 72}}) {
      const auto d = u[std::size_t(a)] - u[std::size_t(b)];
      apart = std::max(apart, std::sqrt(dot(d, d)));
    }
  }
  const auto lost = mean_of(simulation->velocity(), all, mass) - before;
  EXPECT_LT(std::sqrt(dot(lost, lost)), GetParam().rounding());
  EXPECT_LT(apart, 0.01);
  const Energies e = simulation->energies();
  EXPECT_NEAR(e.kinetic + e.strain, e.initial, 0.02 * e.initial);
  EXPECT_NEAR(e.contact, 0, 0.02 * e.initial);
}

TEST(TiedThreads, GiveTheSameBitsForAnyNumber) {
  expect_same_bits_for_any_threads(spinning_pair(), threads_float, 60);
}

TEST_P(TiedBodies, AResumedRunEndsWithTheSameBits) {
  expect_same_bits_resumed(spinning_pair(), GetParam(), 30, 20);
}

/// A membrane glued onto a block bends with it.
TEST_P(TiedBodies, AMembraneSticksToABlock) {
  Model model;
  add_body(model, box_mesh({4, 4, 2}, {1, 1, 0.5}, Shape::hexahedron), Formulation::h8,
           {"NH", mu_kappa(3000, 0.3), 1000});
  const Body skin = add_sheet(
      model, 5, 5,
      [](double s, double t) {
        return Vec3<double>{s, t, 0.51};
      },
      membrane_section("NeoHookean", {3000}, 0.02));
  tie(model, 1, 0);
  model.fixed.push_back({face(model.mesh, 2, 0), 4});
  model.fixed.push_back({face(model.mesh, 0, 0), 1});
  model.fixed.push_back({face(model.mesh, 1, 0), 2});
  model.displacements.push_back({face(model.mesh, 0, 1), 1, {0.1}, ramp_curve(1)});
  model.time = relaxed();
  const auto u = final_displacement(model, GetParam());
  for (const int n : skin.nodes()) {
    EXPECT_NEAR(u[std::size_t(n)].x, 0.1 * model.mesh.X[std::size_t(n)].x, 0.003);
    EXPECT_LT(u[std::size_t(n)].z, 0);
  }
}

GLISSON_ALL_CASES(TiedBodies);
INSTANTIATE_TEST_SUITE_P(All, TiedBeams, testing::Values(serial_double, threads_float, cuda_float),
                         case_name);

TEST(TiedInput, ThatCannotBeTiedIsRefused) {
  Model model = pulled_blocks(Shape::tetrahedron, Shape::tetrahedron);
  for (auto& X : model.mesh.X)
    if (&X - model.mesh.X.data() >= 48) X.z += 0.2;
  expect_refused(model, "lies within 0.0166667 of 'body 0'");
  model.ties[0].distance = 0.25;
  model.displacements.clear();
  EXPECT_NO_THROW(simulate(model, serial_double));
  model.ties[0].b = "nobody";
  expect_refused(model, "no sub-model with the name 'nobody'");
  model.ties[0].b = model.ties[0].a;
  expect_refused(model, "to itself");
  model = pulled_blocks(Shape::tetrahedron, Shape::tetrahedron);
  tie(model, 0, 1);
  expect_refused(model, "are a pair already");
}

}  // namespace
}  // namespace glisson::test
