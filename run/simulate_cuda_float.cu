#include <glisson/core/solids/staged_solids.hpp>
#include <glisson/cuda/solids/dispatch.cuh>
#include <glisson/run/assemble.hpp>
#include <glisson/run/simulate.hpp>
#include <glisson/shells/patches/make_staged_shells.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_cuda_float(const Model& model, std::unique_ptr<cuda::Device> device) {
  const std::string name = "CUDA float, " + device->named();
  auto backend = std::make_unique<Cuda>(std::move(device));
  return assemble<Cuda, float>(model, std::move(backend), name, make_staged_solids<Cuda, float>,
                               make_staged_shells<Cuda, float>);
}

}  // namespace glisson::detail
