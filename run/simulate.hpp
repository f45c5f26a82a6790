// One function per backend and precision, each in a file of its own, so that they compile side by side.
#pragma once

#include <memory>

#include <glisson/core/any_simulation.hpp>
#include <glisson/run/make_simulation.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_serial_double(const Model& model);
std::unique_ptr<AnySimulation> simulate_serial_float(const Model& model);
std::unique_ptr<AnySimulation> simulate_threads_double(const Model& model, int threads);
std::unique_ptr<AnySimulation> simulate_threads_float(const Model& model, int threads,
                                                      const std::string& instruction_set);
/// Only in builds with CUDA.
std::unique_ptr<AnySimulation> simulate_cuda_double(const Model& model, int number);
std::unique_ptr<AnySimulation> simulate_cuda_float(const Model& model, int number);
/// conflicts: look for them, see EmulatedDevice
std::unique_ptr<AnySimulation> simulate_emulated_double(const Model& model, bool conflicts);
std::unique_ptr<AnySimulation> simulate_emulated_float(const Model& model, bool conflicts);

}  // namespace glisson::detail
