// Whole simulations in groups: the real time loops with all their launches, on the fake machine. What is
// compared is the member alone on a device of its own, bit by bit.
#include <gtest/gtest.h>

#include <glisson/run/ensembles.hpp>
#include <tests/cuda/fake_simulation.hpp>
#include <tests/support/models.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::cuda {
namespace {

using namespace glisson::test;

std::unique_ptr<AnyEnsemble> together(
    const std::vector<Model>& models, int threads,
    std::shared_ptr<ConstantArrays> constants = std::make_shared<ConstantArrays>()) {
  return detail::device_ensemble(
      models, threads,
      {[=] { return std::make_unique<DeviceGroup>(fake_runtime, 0, constants); }, simulate_fake});
}

/// A block held at the bottom, of a stiffness of its own, so that its time step and the steps of its energy
/// accounts are its own too; every third has another law.
Model member(int k) {
  Material material{"NH", {1000.0 + 70 * k, 20000}};
  if (k % 3 == 1) material = {"AB", {1000.0 + 50 * k, 2, 20000}};
  Model model = box_model({3, 3, 4}, {0.03, 0.03, 0.04}, Formulation::t4, material, 0.1);
  const double total = 0.02;
  model.fixed = {{face(model.mesh, 2, 0)}};
  model.gravity = {{{}, {0, 0.5 * k, -9.81}, ramp_curve(total)}};
  model.forces = {{{face(model.mesh, 2, 0.04)[0]}, 1, {0.002 * (k + 1)}, smooth_curve(total)}};
  if (k % 2 == 0) model.displacements = {{face(model.mesh, 2, 0.04), 4, {-0.001}, smooth_curve(total)}};
  model.time.total = total * (k % 4 == 3 ? 0.7 : 1);
  model.time.damping = k % 2;
  model.time.monitor_every = k % 5 == 4 ? 7 : 0;
  return model;
}

std::vector<Model> members(int count) {
  std::vector<Model> models;
  for (int k = 0; k < count; ++k) models.push_back(member(k));
  models[4].sections[0].formulation = Formulation::t4anp;
  models[1].time.quasi_static = QuasiStatic{1e-3, 1e-3, 400};
  RigidBody plate;
  plate.corners = {{{0, 0, 0.041}, {0, 0.03, 0.041}, {0.03, 0, 0.041}}};
  plate.displacement = {0, 0, -0.002};
  plate.motion = smooth_curve(0.02);
  models[5].bodies = {plate};
  return models;
}

void expect_single_run(const Model& model, AnySimulation& member, int k) {
  const auto single = alone(model);
  single->step(1 << 30);
  EXPECT_EQ(member.step_count(), single->step_count()) << k;
  EXPECT_TRUE(same_bits(member.displacement(), single->displacement())) << k;
  EXPECT_TRUE(same_bits(member.velocity(), single->velocity())) << k;
  EXPECT_EQ(member.energies().kinetic, single->energies().kinetic) << k;
  EXPECT_EQ(member.energies().external, single->energies().external) << k;
  EXPECT_GT(single->energies().strain, 0) << k;
}

using CudaDeviceEnsemble = FakeMachine;

TEST_F(CudaDeviceEnsemble, MembersAreTheirSingleRunsBitByBit) {
  auto models = members(8);
  models[6].time.step = 1;  // fails
  models[6].time.total = 100;
  models[7].sections[0].material.parameters[0] = -1e30;  // cannot be set up
  const auto ensemble = together(models, 1);
  while (!ensemble->finished()) ensemble->step(13);
  for (int k = 0; k < 6; ++k) {
    ASSERT_EQ(ensemble->status(k), MemberStatus::finished) << k << ensemble->error(k);
    expect_single_run(models[static_cast<std::size_t>(k)], ensemble->member(k), k);
  }
  for (const int k : {6, 7}) EXPECT_EQ(ensemble->status(k), MemberStatus::failed);
  EXPECT_NE(ensemble->error(6), ensemble->error(7));
}

TEST_F(CudaDeviceEnsemble, GroupsRunOnThreadsOfTheirOwn) {
  const auto models = members(70);
  const auto ensemble = together(models, 3);
  EXPECT_EQ(fake.live_streams, 2) << "fewer than 32 members are no group";
  ensemble->step(1 << 30);
  EXPECT_TRUE(ensemble->finished());
  for (const int k : {0, 1, 4, 5, 33, 34, 35, 69})
    expect_single_run(models[static_cast<std::size_t>(k)], ensemble->member(k), k);
}

/// The launches of members alike must not grow with their number, or nothing is gained.
TEST_F(CudaDeviceEnsemble, MembersAlikeShareTheirLaunches) {
  std::vector<Model> models(3, member(0));
  models[1].gravity[0].acceleration.x = 1, models[2].sections[0].material.parameters[0] *= 1.0001;
  for (Model& model : models) model.time.step = 2e-4;
  const auto launches = [](const auto& run) {
    const int before = fake.launches, members_before = fake.members;
    run();
    return std::pair{fake.launches - before, fake.members - members_before};
  };
  fake.fails = "make_graph", fake.code = status::out_of_memory;  // so that each is counted
  const auto single = alone(models[0]);
  const auto [of_one, by_one] = launches([&] { single->step(50); });
  const auto ensemble = together(models, 1);
  const auto [of_all, by_all] = launches([&] { ensemble->step(50); });
  EXPECT_LT(of_all, 1.2 * of_one) << "three in one launch; in groups copies are launches too";
  EXPECT_GE(by_all, 3 * by_one);
}

TEST_F(CudaDeviceEnsemble, MembersShareTheWaitOfTheirAccounts) {
  std::vector<Model> models(3, member(0));
  for (Model& model : models) model.time.step = 2e-4, model.time.monitor_every = 10;
  const auto ensemble = together(models, 1);
  ensemble->step(9);
  const auto waits = [&] {
    const int before = fake.waits;
    ensemble->step(1);
    return fake.waits - before;
  };
  EXPECT_EQ(waits(), 1) << "at the end of a step without an account";
  EXPECT_EQ(waits(), 1) << "its account is at the end of the step";
}

TEST_F(CudaDeviceEnsemble, MembersShareWhatTheyOnlyRead) {
  const auto bytes = [](int count) {
    std::vector<Model> models(static_cast<std::size_t>(count), member(0));
    for (int k = 0; k < count; ++k)
      models[static_cast<std::size_t>(k)].sections[0].material.parameters[0] += k;
    const auto constants = std::make_shared<ConstantArrays>();
    const auto ensemble = together(models, 2, constants);
    return constants->bytes();
  };
  EXPECT_GT(bytes(1), 20u * 3 * 3 * 4 * 6) << "corners, rows and places of each tetrahedron";
  EXPECT_LE(bytes(65), bytes(1) + 64 * 16) << "parameters are their own";
}

TEST_F(CudaDeviceEnsemble, ALostDeviceFailsAllMembers) {
  const auto ensemble = together(members(6), 1);
  ensemble->step(10);
  fake.fails = "wait", fake.code = status::ecc_error;
  ensemble->step(1000);
  EXPECT_TRUE(ensemble->finished());
  for (int k = 0; k < 6; ++k)
    EXPECT_NE(ensemble->error(k).find("could not be corrected"), std::string::npos) << ensemble->error(k);
}

}  // namespace
}  // namespace glisson::cuda
