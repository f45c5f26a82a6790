#include "tests/cuda/fake_simulation.hpp"

#include <glisson/core/solids/staged_solids.hpp>
#include <glisson/run/assemble.hpp>
#include <tests/cuda/fake_backend.hpp>

namespace glisson::cuda {

std::unique_ptr<AnySimulation> simulate_fake(const Model& model, std::unique_ptr<Device> device) {
  const std::string name = device->named();
  return assemble<FakeGpu, float>(model, std::make_unique<FakeGpu>(std::move(device)), name,
                                  make_staged_solids<FakeGpu, float>, make_plain_shells<FakeGpu, float>);
}

}  // namespace glisson::cuda
