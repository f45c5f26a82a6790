// Ensembles on a GPU: members share launches. Those on the CPU are in tests/run/test_ensemble.cpp.
#include <gtest/gtest.h>

#include <glisson/run/make_ensemble.hpp>
#include <tests/support/models.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

Model member(int k) {
  Model model =
      box_model({10, 10, 10}, {0.1, 0.1, 0.1}, Formulation::t4, {"NH", {1000.0 + 50 * k, 20000}}, 0.1);
  model.fixed.push_back({face(model.mesh, 2, 0), all_axes});
  model.gravity.push_back({{}, {0, 0, -9.81}, ramp_curve(0.1)});
  model.time.total = 0.1;
  model.time.damping = k % 2;
  return model;
}

/// Members that share launches on the GPU against simulations of their own, which share none.
void expect_single_runs(const std::vector<Model>& models, int failing, int threads) {
  SimulationOptions options;
  options.device = "cuda";
  options.threads = threads;
  const auto ensemble = make_ensemble(models, options);
  while (!ensemble->finished()) ensemble->step(30);
  for (int k = 0; k < ensemble->member_count(); ++k) {
    ASSERT_EQ(ensemble->status(k), k == failing ? MemberStatus::failed : MemberStatus::finished) << k;
    if (k == failing) continue;
    EXPECT_TRUE(same_bits(ensemble->member(k).displacement(),
                          final_displacement(models[static_cast<std::size_t>(k)], cuda_float)))
        << k;
  }
}

/// Names as the filter of tools/gpu-check.sh wants them.
TEST(GpuEnsemble, MembersOnCudaAreTheirSingleRuns) {
  if (!gpu_expected()) GTEST_SKIP() << "not run: no GPU here, or a build without CUDA";
  std::vector<Model> models;
  for (int k = 0; k < 7; ++k) models.push_back(member(k));
  models[3].time.step = 1;  // fails
  models[3].time.total = 100;
  expect_single_runs(models, 3, 3);
}

/// One group of 40 where 32 fit into a launch, and two groups on threads of their own.
TEST(GpuEnsemble, MoreMembersOnCudaThanFitIntoOneLaunchWithTwoLawsAndOneFailing) {
  if (!gpu_expected()) GTEST_SKIP() << "not run: no GPU here, or a build without CUDA";
  std::vector<Model> models;
  for (int k = 0; k < 70; ++k) {
    models.push_back(member(k));
    Section& section = models.back().sections[0];
    if (k % 3 == 1) section.material.law = "AB", section.material.parameters = {1000.0 + 50 * k, 2, 20000};
    if (k % 7 == 2) section.formulation = Formulation::t4anp;
  }
  models[5].time.step = 1;  // fails
  models[5].time.total = 100;
  expect_single_runs(models, 5, 2);
  models.resize(40);
  expect_single_runs(models, 5, 1);
}

}  // namespace
}  // namespace glisson::test
