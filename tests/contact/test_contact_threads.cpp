// Contact on a mesh that is large enough for the whole team.
#include <gtest/gtest.h>

#include <algorithm>

#include <glisson/core/mesh/surface.hpp>

#include <tests/contact/body_scenes.hpp>
#include <tests/support/models.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

/// A mat that a plate and a probe press onto a rough block.
Model pressed_mat() {
  Model model = box_model({48, 48, 2}, {0.48, 0.48, 0.02}, Formulation::t4, {"NH", {1000, 5000}, 1000}, 0.1);
  RigidSurface block;
  const Mesh mesh = box_mesh({3, 3, 1}, {0.5, 0.5, 0.1}, Shape::hexahedron, 0);
  block.surface = {mesh.X, outer_surface(mesh)};
  for (auto& X : block.surface.X) X = X + Vec3<double>{-0.01, -0.01, -0.1002};
  block.friction = 0.3;
  block.displacement = {0.002, 0, 0};
  model.surfaces = {block};
  RigidBody plate;
  plate.corners = {Vec3<double>{-1, -1, 0.0202}, Vec3<double>{-1, 1, 0.0202}, Vec3<double>{1, -1, 0.0202}};
  plate.displacement = {0, 0, -0.002};
  RigidBody probe;
  probe.shape = RigidShape::probe;
  probe.origin = {0.24, 0.24, 0.1}, probe.axis = {0, 0, -1};
  probe.radius = 0.05, probe.length = 0.029;
  probe.displacement = {0, 0, -0.004};
  model.bodies = {plate, probe};
  model.gravity = {{{}, {0, 0, -9.81}, ramp_curve(0.02)}};
  model.time.total = 0.02;
  return model;
}

TEST(ContactThreads, GiveTheSameBitsForAnyNumber) {
  const Model model = pressed_mat();
  validate(model);
  const auto u = expect_same_bits_for_any_threads(model, threads_float, 40);
  const auto lowest = std::min_element(u.begin(), u.end(), [](auto& a, auto& b) { return a.z < b.z; });
  EXPECT_LT(lowest->z, -1e-4) << "nothing was pressed";
}

/// Two thin blocks of tetrahedra that are thrown on each other and slide: most of the surface of both is
/// listed, but not all.
Model sliding_sheets() {
  Model model;
  const Material rubber{"NH", mu_kappa(1e4, 0.3), 1000};
  add_body(model, box_mesh({30, 30, 2}, {0.3, 0.3, 0.02}, Shape::tetrahedron, 0.1), Formulation::t4, rubber);
  Mesh upper = box_mesh({23, 23, 2}, {0.2, 0.2, 0.02}, Shape::tetrahedron, 0.1);
  move(upper, {0.05, 0.04, 0.0201});
  const Body block = add_body(model, upper, Formulation::t4, rubber);
  model.initial_velocities.push_back({block.nodes(), {0.1, 0.05, -0.05}});
  model.contact.between_bodies = true;
  model.contact.friction = 0.3;
  model.time.total = 0.03;
  return model;
}

TEST(ContactThreads, GiveTheSameBitsBetweenBodiesForAnyNumber) {
  const Model model = sliding_sheets();
  validate(model);
  expect_same_bits_for_any_threads(model, threads_float, 20);
  auto simulation = simulate(model, threads_float, 1);
  int most = 0;
  for (int step = 0; step < 20; ++step) {
    simulation->step(1);
    most = std::max(most, simulation->contacts().front().report.node_count);
  }
  EXPECT_GT(most, 100);
  const ContactReport report = simulation->contacts().front().report;
  EXPECT_GT(report.search.candidates, 3000) << "not enough for the team";
}

}  // namespace
}  // namespace glisson::test
