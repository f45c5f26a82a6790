// The same bits every time: twice, for any number of threads, interrupted and resumed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <tests/support/models.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

/// Everything at once: two materials, viscosity, gravity, pressure, prescribed motion, springs, a plate,
/// damping.
Model busy_model(Formulation formulation, bool quasi_static) {
  Model model = box_model({12, 6, 6}, {0.12, 0.06, 0.06}, formulation, {"NH", {1000, 20000}, 1000}, 0.1);
  Section tail = model.sections[0];
  tail.elements.assign(model.sections[0].elements.begin() + 200, model.sections[0].elements.end());
  model.sections[0].elements.resize(200);
  tail.material.isochoric = {{0.3, 0.02}, {0.2, 0.2}};
  tail.material.parameters = {1500, 20000};
  model.sections.push_back(tail);
  model.fixed.push_back({face(model.mesh, 0, 0), all_axes});
  model.displacements.push_back({face(model.mesh, 0, 0.12), 1, {0.005}, smooth_curve(0.2)});
  model.gravity.push_back({{}, {0, 0, -9.81}, ramp_curve(0.2)});
  model.springs.push_back(
      {face(model.mesh, 1, 0.06), {{0, 0.004, 0}}, {0.5}, ramp_curve(0.2), step_curve(0.2), 1e-5});
  RigidBody plate;
  plate.corners = {Vec3<double>{-1, -1, -0.0005}, Vec3<double>{1, -1, -0.0005}, Vec3<double>{-1, 1, -0.0005}};
  model.bodies.push_back(plate);
  model.time.total = 0.2;
  model.time.damping = 5;
  model.time.energy_tolerance = 0;
  if (quasi_static) model.time.quasi_static = QuasiStatic{1e-3, 1e-3, 900};
  return model;
}

/// Of each formulation, and one without contact, whose steps end with a sweep over the nodes on devices.
std::vector<Model> busy_models() {
  std::vector<Model> all;
  for (const auto formulation : {Formulation::t4, Formulation::t4anp, Formulation::h8})
    all.push_back(busy_model(formulation, false));
  all.push_back(all.front());
  all.back().bodies.clear();
  return all;
}

class Repeatability : public Matrix {};

TEST_P(Repeatability, TwiceAndWithOneTwoAndThreeThreads) {
  for (const Model& model : busy_models()) expect_same_bits_for_any_threads(model, GetParam(), 700);
}

/// $GLISSON_REPEATS times, where more than a few are wanted.
TEST_P(Repeatability, ManyTimes) {
  const char* wish = std::getenv("GLISSON_REPEATS");
  const int repeats = wish ? std::max(2, std::atoi(wish)) : 2;
  for (const Model& model : busy_models()) {
    std::vector<Vec3<double>> first;
    for (int i = 0; i < repeats; ++i) {
      auto simulation = simulate(model, GetParam());
      simulation->step(100);
      if (i == 0) first = simulation->displacement();
      ASSERT_TRUE(same_bits(first, simulation->displacement())) << "run " << i;
    }
  }
}

TEST_P(Repeatability, InterruptedAnywhereAndResumed) {
  std::vector<Model> models{busy_model(Formulation::t4, true), busy_model(Formulation::t4, false)};
  models.push_back(busy_models().back());
  for (const Model& model : models) {
    auto whole = simulate(model, GetParam());
    whole->step(700);
    for (const int stop : {1, 333, 505}) {
      std::stringstream checkpoint;
      {
        auto first = simulate(model, GetParam());
        first->step(stop);
        first->displacement();
        first->element_fields();  // looking at results must not change the run
        first->velocity();
        first->save(checkpoint);
      }
      auto second = simulate(model, GetParam());
      second->load(checkpoint);
      second->step(700 - stop);
      EXPECT_TRUE(same_bits(whole->displacement(), second->displacement())) << "stopped at " << stop;
      EXPECT_EQ(whole->energies().imbalance(), second->energies().imbalance());
    }
  }
}

TEST_P(Repeatability, TwoSimulationsOfOneModelDoNotDisturbEachOther) {
  for (const Model& model : busy_models()) {
    auto a = simulate(model, GetParam()), b = simulate(model, GetParam());
    for (int i = 0; i < 5; ++i) a->step(5), b->step(3), b->step(2);
    EXPECT_TRUE(same_bits(a->displacement(), b->displacement()));
  }
}

GLISSON_ALL_CASES(Repeatability);

TEST(Checkpoint, OfAnotherModelOrDamagedIsRefused) {
  const Model model = busy_model(Formulation::t4, false), other = busy_model(Formulation::t4anp, false);
  std::stringstream checkpoint;
  simulate(model, serial_double)->save(checkpoint);
  const std::string bytes = checkpoint.str();
  std::stringstream cut(bytes.substr(0, bytes.size() / 2)), again(bytes);
  EXPECT_THROW(simulate(model, serial_double)->load(cut), Error);
  EXPECT_THROW(simulate(model, threads_float)->load(again), Error);
}

}  // namespace
}  // namespace glisson::test
