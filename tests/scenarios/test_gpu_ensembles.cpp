// Ensembles on a GPU: members on streams of their own. Those on the CPU are in tests/run/test_ensemble.cpp.
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

/// Name as the filter of tools/gpu-check.sh wants it.
TEST(GpuEnsemble, MembersOnCudaAreTheirSingleRuns) {
  if (!gpu_expected()) GTEST_SKIP() << "not run: no GPU here, or a build without CUDA";
  std::vector<Model> models;
  for (int k = 0; k < 7; ++k) models.push_back(member(k));
  models[3].time.step = 1;  // fails
  models[3].time.total = 100;
  SimulationOptions options;
  options.device = "cuda";
  options.threads = 3;
  const auto ensemble = make_ensemble(models, options);
  while (!ensemble->finished()) ensemble->step(30);
  for (int k = 0; k < 7; ++k) {
    ASSERT_EQ(ensemble->status(k), k == 3 ? MemberStatus::failed : MemberStatus::finished) << k;
    if (k == 3) continue;
    EXPECT_TRUE(same_bits(ensemble->member(k).displacement(),
                          final_displacement(models[static_cast<std::size_t>(k)], cuda_float)))
        << k;
  }
}

}  // namespace
}  // namespace glisson::test
