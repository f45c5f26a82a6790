// Deformable bodies that are pressed hard.
#include <gtest/gtest.h>

#include <tests/contact/bodies.hpp>

namespace glisson::test {
namespace {

/// Two soft blocks of tetrahedra on each other, 6 x 6 and 7 x 7 cells at the interface, free to spread, by 40
/// and by 60 %. (Hexahedra with one point buckle there without any contact.)
void press_soft_blocks(double share) {
  Model model;
  const Material soft{"NH", mu_kappa(3000, 0.45), 1000};
  add_body(model, box_mesh({6, 6, 5}, {0.06, 0.06, 0.03}, Shape::tetrahedron), Formulation::t4, soft);
  Mesh upper = box_mesh({7, 7, 5}, {0.06, 0.06, 0.03}, Shape::tetrahedron);
  move(upper, {0, 0, 0.03});
  const Body above = add_body(model, upper, Formulation::t4, soft);
  model.fixed.push_back({face(model.mesh, 2, 0), 4});
  model.fixed.push_back({face(model.mesh, 0, 0), 1});
  model.fixed.push_back({face(model.mesh, 1, 0), 2});
  model.displacements.push_back({face(model.mesh, 2, 0.06), 4, {-0.06 * share}, smooth_curve(1)});
  model.contact.between_bodies = true;
  model.time.total = 1;
  model.time.damping = 20;
  auto simulation = simulate(model, threads_float);
  while (!simulation->finished()) simulation->step(100);
  const auto report = simulation->contacts().at(0).report;
  const double edge = 0.006;
  EXPECT_LT(report.largest_depth, 0.05 * edge);
  EXPECT_GT(report.node_count, 80);
  const auto u = simulation->displacement(), f = simulation->contact_force();
  double force = 0, low = 1, high = 0;
  for (const int n : above.nodes()) {
    force += f[static_cast<std::size_t>(n)].z;
    if (std::abs(model.mesh.X[static_cast<std::size_t>(n)].z - 0.03) > 1e-9) continue;
    low = std::min(low, 0.03 + u[static_cast<std::size_t>(n)].z);
    high = std::max(high, 0.03 + u[static_cast<std::size_t>(n)].z);
  }
  EXPECT_NEAR(low, 0.03 * (1 - share), 0.0002);
  EXPECT_NEAR(high, 0.03 * (1 - share), 0.0002);
}

TEST(BodyPressing, SoftBlocksDoNotEnterEachOtherAt40Percent) { press_soft_blocks(0.4); }

TEST(BodyPressing, SoftBlocksDoNotEnterEachOtherAt60Percent) { press_soft_blocks(0.6); }

}  // namespace
}  // namespace glisson::test
