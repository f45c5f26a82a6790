// The loops of contact that are compiled for each instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glisson/cpu/solids/kernel_table.hpp>
#include <glisson/run/make_simulation.hpp>

#include <tests/contact/body_scenes.hpp>

namespace glisson::test {
namespace {

constexpr int steps = 100;

double largest_difference(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, dot(a[n] - b[n], a[n] - b[n]));
  return std::sqrt(most);
}

TEST(ContactLoops, OfEveryInstructionSetGiveTheForcesOfThePlainOnes) {
  const Model model = sliding_block();
  auto reference = simulate(model, serial_double);
  reference->step(steps);
  const auto expected = reference->displacement();
  const ContactReport touching = reference->contacts().front().report;
  ASSERT_GT(touching.search.candidates, 1000);
  ASSERT_GT(touching.node_count, 0);
  const double size = largest_difference(expected, std::vector<Vec3<double>>(expected.size()));
  const auto sets = patches::instruction_sets();
  for (std::size_t i = 0; i < sets.count; ++i) {
    if (!sets.sets[i].available()) continue;
    SimulationOptions options;
    options.threads = 2;
    options.instruction_set = sets.sets[i].name;
    auto its = make_simulation(model, options);
    its->step(steps);
    EXPECT_LT(largest_difference(its->displacement(), expected) / size, 1e-4) << sets.sets[i].name;
    EXPECT_NEAR(its->contacts().front().report.node_count, touching.node_count, 5);
    options.threads = 1;
    auto alone = make_simulation(model, options);
    alone->step(steps);
    EXPECT_EQ(largest_difference(its->displacement(), alone->displacement()), 0) << sets.sets[i].name;
  }
}

}  // namespace
}  // namespace glisson::test
