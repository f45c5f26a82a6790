// What a simulation does with its model before and at the first steps: refuses what does not fit, names what
// limits the step, lets loads grow.
#include <gtest/gtest.h>

#include <cstring>

#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

Model pulled_block() {
  Model model = box_model({3, 2, 2}, {0.03, 0.02, 0.02}, Formulation::t4, {"NH", {1000, 20000}, 1000});
  model.fixed.push_back({face(model.mesh, 0, 0), all_axes});
  model.time.total = 0.1;
  return model;
}

TEST(SetUp, RefusesAModelThatDoesNotFit) {
  Model model = pulled_block();
  model.fixed[0].nodes.push_back(4000);
  try {
    simulate(model, serial_double);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("node 4000"), std::string::npos) << error.what();
  }
}

TEST(SetUp, SaysWhatLimitsTheStep) {
  Model model = pulled_block();
  EXPECT_TRUE(simulate(model, serial_double)->report().limited_by.ends_with(" (T4, NH)"));
  model.springs.push_back({face(model.mesh, 0, 0.03), {{0.001, 0, 0}}, {1e5}, ramp_curve(0.1)});
  EXPECT_EQ(simulate(model, serial_double)->report().limited_by, "springs");
}

TEST(SetUp, QuasiStaticLoadsGrowWithoutATotalTime) {
  Model model = pulled_block();
  model.displacements.push_back({face(model.mesh, 0, 0.03), 1, {0.003}, smooth_curve(1)});
  model.time = relaxed();
  const auto expected = final_displacement(model, serial_double);
  model.time.total = 0;
  const auto simulation = simulate(model, serial_double);
  simulation->step(10);
  const auto pulled = static_cast<std::size_t>(model.displacements[0].nodes[0]);
  EXPECT_GT(simulation->displacement()[pulled].x, 0);
  EXPECT_LT(simulation->displacement()[pulled].x, 1e-4);
  while (!simulation->finished()) simulation->step(100);
  const auto u = simulation->displacement();
  for (std::size_t n = 0; n < u.size(); ++n) EXPECT_NEAR(u[n].x, expected[n].x, 1e-12);
}

// Johnsen 2016, eq. 3.15: the energy of every step counts, however rarely energies are reported.
TEST(SetUp, SpringCapSeesTheEnergyOfEveryStep) {
  Model model = pulled_block();
  model.time.damping = 50;
  model.springs.push_back(
      {face(model.mesh, 0, 0.03), {{0.01, 0, 0}}, {0.2}, ramp_curve(0.1), step_curve(0.1), 1e-6});
  const auto with = [&](int every) {
    model.time.monitor_every = every;
    return final_displacement(model, serial_double);
  };
  const auto often = with(1), rarely = with(100000);
  EXPECT_EQ(std::memcmp(often.data(), rarely.data(), often.size() * sizeof often[0]), 0);
  model.springs[0].strain_energy_cap.reset();
  const auto pulled = static_cast<std::size_t>(model.springs[0].nodes[0]);
  EXPECT_GT(with(1)[pulled].x, 1.2 * often[pulled].x) << "the cap never acted";
}

}  // namespace
}  // namespace glisson::test
