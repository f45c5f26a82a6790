// Velocities between two steps, of nodes in contact: half a kick of all forces, the contact's too.
#include <gtest/gtest.h>

#include <algorithm>

#include <glisson/core/mesh/surface.hpp>
#include <tests/contact/bodies.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

class ContactVelocity : public Matrix {};

const Material jelly{"NH", mu_kappa(2e4, 0.3), 1000};

/// A cube of 10 cm that gravity lays on what is below it; at rest long before the end.
Model lying_cube(Model model) {
  Mesh cube = box_mesh({3, 3, 3}, {0.1, 0.1, 0.1}, Shape::hexahedron);
  move(cube, {0.02, 0.02, 0.1});
  const Body body = add_body(model, cube, Formulation::h8_full, jelly);
  model.gravity.push_back({body.nodes(), {0, 0, -9.81}, smooth_curve(0.2)});
  model.time.damping = 60;
  model.time.total = 0.8;
  return model;
}
Model on_a_block() {
  Model model;
  add_body(model, box_mesh({4, 4, 2}, {0.14, 0.14, 0.1}, Shape::hexahedron), Formulation::h8_full, jelly);
  model.fixed.push_back({face(model.mesh, 2, 0), all_axes});
  model.contact.between_bodies = true;
  return lying_cube(model);
}
Model on_a_rigid_surface() {
  Model model;
  const Mesh block = box_mesh({3, 3, 1}, {0.2, 0.2, 0.1}, Shape::hexahedron);
  RigidSurface floor;
  floor.surface = {block.X, outer_surface(block)};
  floor.friction = 0.3;
  model.surfaces = {floor};
  return lying_cube(model);
}
Model on_a_plate() {
  Model model;
  RigidBody plate;
  plate.corners = {Vec3<double>{-1, -1, 0.1}, Vec3<double>{1, -1, 0.1}, Vec3<double>{-1, 1, 0.1}};
  model.bodies = {plate};
  return lying_cube(model);
}

double fastest(const AnySimulation& simulation) {
  double most = 0;
  for (const auto& v : simulation.velocity()) most = std::max(most, std::sqrt(dot(v, v)));
  return most;
}

/// Without the force of contact the half kick of the others leaves 0.13 m/s on the nodes that press.
TEST_P(ContactVelocity, IsZeroAtRest) {
  for (const auto& model : {on_a_block(), on_a_rigid_surface(), on_a_plate()}) {
    auto simulation = simulate(model, GetParam());
    while (!simulation->finished()) simulation->step(100);
    const auto u = simulation->displacement();
    EXPECT_LT(u.back().z, -1e-3) << "nothing lies on anything";
    EXPECT_LT(fastest(*simulation), 2e-4);
  }
}

TEST(ContactVelocities, AskingForThemDisturbsNothing) {
  for (const auto& model : {on_a_block(), on_a_rigid_surface(), on_a_plate()}) {
    auto asked = simulate(model, threads_float), left = simulate(model, threads_float);
    for (int n = 0; n < 60 && !left->finished(); ++n) {
      asked->velocity();
      asked->step(7);
      left->step(7);
    }
    EXPECT_TRUE(same_bits(asked->displacement(), left->displacement()));
  }
}

GLISSON_ALL_CASES(ContactVelocity);

}  // namespace
}  // namespace glisson::test
