// Deformable bodies that are pressed hard.
#include <gtest/gtest.h>

#include <tests/contact/body_scenes.hpp>

namespace glisson::test {
namespace {

/// By 40 and by 60 %.
void press_soft_blocks(double share) {
  const auto [model, above] = pressed_blocks(share, 1, 20);
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
