// Whole simulations on the fake machine, put together as on a GPU.
#pragma once

#include <memory>

#include <glisson/core/solids/staged_solids.hpp>
#include <glisson/run/assemble.hpp>
#include <tests/cuda/fake_backend.hpp>

namespace glisson::cuda {

inline std::unique_ptr<AnySimulation> simulate_fake(const Model& model, std::unique_ptr<Device> device) {
  const std::string name = device->named();
  return assemble<FakeGpu, float>(model, std::make_unique<FakeGpu>(std::move(device)), name,
                                  make_staged_solids<FakeGpu, float>, make_plain_shells<FakeGpu, float>);
}

/// The only one of its device.
inline std::unique_ptr<AnySimulation> alone(const Model& model) {
  return simulate_fake(model, std::make_unique<Device>(fake_runtime, 0));
}

}  // namespace glisson::cuda
