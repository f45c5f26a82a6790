#include <glisson/core/solids/staged_solids.hpp>
#include <glisson/cuda/solids/dispatch.cuh>
#include <glisson/run/assemble.hpp>
#include <glisson/run/simulate.hpp>
#include <glisson/shells/patches/make_staged_shells.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_cuda_double(const Model& model, int number) {
  auto backend = std::make_unique<Cuda>(number);
  const std::string device = "CUDA double, cuda:" + std::to_string(number) + " " + backend->facts().name;
  return assemble<Cuda, double>(model, std::move(backend), device, make_staged_solids<Cuda, double>,
                                make_staged_shells<Cuda, double>);
}

}  // namespace glisson::detail
