#include <glisson/run/make_simulation.hpp>

#include <algorithm>
#include <thread>

#include <glisson/core/base/error.hpp>
#include <glisson/cuda/device.hpp>
#include <glisson/run/gpus.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson {
namespace {

int thread_count(int asked) {
  if (asked < 0 || asked > 1024)
    throw Error(ErrorKind::usage, "A run cannot have " + std::to_string(asked) +
                                      " threads. Use 1 to 1024, or 0 for all cores.");
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::unique_ptr<AnySimulation> simulate_cuda(const Model& model, const std::string& device, bool in_double) {
  auto gpu = detail::open_gpu(cuda::device_number(device));
  return in_double ? detail::simulate_cuda_double(model, std::move(gpu))
                   : detail::simulate_cuda_float(model, std::move(gpu));
}

}  // namespace

std::string automatic_device_text() {
  if (!built_with_cuda()) return "auto chose the CPU: this build has no CUDA";
  return find_gpus().empty() ? "auto chose the CPU: no CUDA device here" : "auto chose the GPU";
}

std::unique_ptr<AnySimulation> make_simulation(const Model& model, const SimulationOptions& options) {
  const bool in_double = options.precision == Precision::double_precision;
  const std::string& device = options.device;
  if (!options.validated) validate(model);
  if (device == "serial")
    return in_double ? detail::simulate_serial_double(model) : detail::simulate_serial_float(model);
  if (const bool conflicts = device == "emulated:conflicts"; conflicts || device == "emulated")
    return in_double ? detail::simulate_emulated_double(model, conflicts)
                     : detail::simulate_emulated_float(model, conflicts);
  const bool gpu_chosen = device == "auto" && !find_gpus().empty();
  if (gpu_chosen) return simulate_cuda(model, "cuda:0", in_double);
  if (device != "cpu" && device != "auto") return simulate_cuda(model, device, in_double);
  const int threads = thread_count(options.threads);
  if (in_double) return detail::simulate_threads_double(model, threads);
  return detail::simulate_threads_float(model, threads, options.instruction_set);
}

}  // namespace glisson
