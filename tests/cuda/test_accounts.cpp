// How often an energy account lets the host wait for the device.
#include <gtest/gtest.h>

#include <cstring>

#include <tests/cuda/fake_simulation.hpp>
#include <tests/run/everything.hpp>

namespace glisson::cuda {
namespace {

using namespace glisson::test;
using CudaAccounts = FakeMachine;

/// Accounts every 10 steps.
Model accounted(Model model) {
  model.time.total = 1;
  model.time.step = 1e-4;
  model.time.monitor_every = 10;
  return model;
}

Model block(Formulation formulation) {
  Model model = box_model({4, 4, 4}, {0.04, 0.04, 0.04}, formulation, {"NH", {1000, 20000}}, 0.1);
  model.fixed = {{face(model.mesh, 2, 0)}};
  model.gravity = {{{}, {0, 0, -9.81}, ramp_curve(1)}};
  return accounted(model);
}

Model pressed() {
  Model model = block(Formulation::t4);
  RigidBody plate;
  plate.corners = {{{0, 0, 0.041}, {0, 0.04, 0.041}, {0.04, 0, 0.041}}};
  plate.displacement = {0, 0, -0.002};
  plate.motion = smooth_curve(0.02);
  model.bodies = {plate};
  return model;
}

/// All kinds of providers but a cap of springs, which asks for the strain energy in each step.
Model all(Formulation formulation) {
  Model model = accounted(everything(formulation));
  model.springs[0].strain_energy_cap.reset();
  return model;
}

/// Waits of the steps from one account to the end of the next.
int waits_of_account(const Model& model) {
  const auto simulation = alone(model);
  simulation->watch_largest_displacement();
  simulation->step(11);
  const int before = fake.waits;
  simulation->step(10);
  return fake.waits - before;
}

/// That wait is also the one at the end of step().
TEST_F(CudaAccounts, WaitOnce) {
  EXPECT_EQ(waits_of_account(block(Formulation::t4)), 1);
  EXPECT_EQ(waits_of_account(block(Formulation::h8)), 1);
  EXPECT_EQ(waits_of_account(pressed()), 1);
  EXPECT_EQ(waits_of_account(all(Formulation::t4)), 1) << "with shells";
  EXPECT_EQ(waits_of_account(all(Formulation::h8)), 1);
}

/// Without pinned memory each contributor waits for its own copy, as all did before copies were joined.
TEST_F(CudaAccounts, AreTheSameWithoutPinnedMemory) {
  for (const Formulation formulation : {Formulation::t4, Formulation::h8}) {
    const Model model = all(formulation);
    const auto joint = alone(model);
    joint->step(31);
    fake.fails = "allocate_pinned", fake.code = status::out_of_memory;
    EXPECT_EQ(waits_of_account(block(formulation)), formulation == Formulation::t4 ? 6 : 7);
    EXPECT_EQ(waits_of_account(model), formulation == Formulation::t4 ? 14 : 13);
    const auto one_by_one = alone(model);
    one_by_one->step(31);
    fake.fails = "";
    const Energies a = joint->energies(), b = one_by_one->energies();
    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
    EXPECT_NE(a.strain * a.kinetic * a.external * a.prescribed * a.damping, 0);
  }
}

}  // namespace
}  // namespace glisson::cuda
