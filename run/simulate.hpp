// One function per backend and precision, each in a file of its own, so that they compile side by side.
#pragma once

#include <memory>

#include <glisson/core/any_simulation.hpp>
#include <glisson/cuda/device_group.hpp>
#include <glisson/run/make_simulation.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_serial_double(const Model& model);
std::unique_ptr<AnySimulation> simulate_serial_float(const Model& model);
std::unique_ptr<AnySimulation> simulate_threads_double(const Model& model, int threads);
std::unique_ptr<AnySimulation> simulate_threads_float(const Model& model, int threads,
                                                      const std::string& instruction_set);
/// "cuda:N" of this machine; in builds without CUDA they throw Error(device).
std::unique_ptr<cuda::Device> open_gpu(int number);
std::unique_ptr<cuda::DeviceGroup> open_gpu_group(int number,
                                                  std::shared_ptr<cuda::ConstantArrays> constants);
std::unique_ptr<AnySimulation> simulate_cuda_double(const Model& model, std::unique_ptr<cuda::Device> device);
std::unique_ptr<AnySimulation> simulate_cuda_float(const Model& model, std::unique_ptr<cuda::Device> device);
/// conflicts: look for them, see EmulatedDevice
std::unique_ptr<AnySimulation> simulate_emulated_double(const Model& model, bool conflicts);
std::unique_ptr<AnySimulation> simulate_emulated_float(const Model& model, bool conflicts);

}  // namespace glisson::detail
