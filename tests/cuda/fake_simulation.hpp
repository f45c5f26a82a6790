// Whole simulations on the fake machine, put together as on a GPU.
#pragma once

#include <memory>

#include <glisson/core/any_simulation.hpp>
#include <glisson/cuda/device.hpp>
#include <tests/cuda/fake_runtime.hpp>

namespace glisson::cuda {

std::unique_ptr<AnySimulation> simulate_fake(const Model& model, std::unique_ptr<Device> device);

/// The only one of its device.
inline std::unique_ptr<AnySimulation> alone(const Model& model) {
  return simulate_fake(model, std::make_unique<Device>(fake_runtime, 0));
}

}  // namespace glisson::cuda
