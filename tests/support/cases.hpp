// The matrix that every scenario runs on: backend x precision. No test name contains a backend.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <glisson/core/base/error.hpp>
#include <glisson/run/gpus.hpp>
#include <glisson/run/make_simulation.hpp>

namespace glisson::test {

struct Case {
  const char* name;
  const char* device;
  Precision precision;
  /// What single precision may add to an error, relative to the largest displacement.
  double rounding() const { return precision == Precision::single_precision ? 2e-5 : 1e-10; }
};

/// Names of tests must not hold the bytes of pointers.
inline void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

inline std::unique_ptr<AnySimulation> simulate(const Model& model, const Case& c, int threads = 2) {
  SimulationOptions options;
  options.device = c.device;
  options.precision = c.precision;
  options.threads = threads;
  return make_simulation(model, options);
}

/// Runs to the end and gives the displacement.
inline std::vector<Vec3<double>> final_displacement(const Model& model, const Case& c) {
  auto simulation = simulate(model, c);
  while (!simulation->finished()) simulation->step(100);
  return simulation->displacement();
}

constexpr Case serial_double{"SerialDouble", "serial", Precision::double_precision};
constexpr Case threads_float{"ThreadsFloat", "cpu", Precision::single_precision};
constexpr Case emulated_float{"EmulatedFloat", "emulated", Precision::single_precision};
constexpr Case cuda_float{"CudaFloat", "cuda", Precision::single_precision};

/// Every row that runs on the CPU.
inline const Case all_cases[] = {serial_double,
                                 {"SerialFloat", "serial", Precision::single_precision},
                                 {"ThreadsDouble", "cpu", Precision::double_precision},
                                 threads_float,
                                 emulated_float};

inline std::vector<Case> cases_with_gpu() {
  std::vector<Case> cases(std::begin(all_cases), std::end(all_cases));
  cases.push_back({"CudaDouble", "cuda", Precision::double_precision});
  cases.push_back(cuda_float);
  return cases;
}

/// Rows of the GPU are skipped where there is none. Where there is a driver, or GLISSON_GPU=required is in
/// the environment, a device that cannot be used is a failure.
inline bool gpu_expected() {
  const char* wish = std::getenv("GLISSON_GPU");
  if (wish && std::string(wish) == "required") return true;
  return built_with_cuda() && std::filesystem::exists("/proc/driver/nvidia/version");
}

class Matrix : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (std::string(GetParam().device) == "cuda" && !gpu_expected())
      GTEST_SKIP() << "not run: no GPU here, or a build without CUDA";
  }
};

inline std::string case_name(const testing::TestParamInfo<Case>& info) { return info.param.name; }

}  // namespace glisson::test

#define GLISSON_ALL_CASES(suite)                                                           \
  INSTANTIATE_TEST_SUITE_P(All, suite, testing::ValuesIn(glisson::test::cases_with_gpu()), \
                           glisson::test::case_name)
