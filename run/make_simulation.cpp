#include <glisson/run/make_simulation.hpp>

#include <algorithm>
#include <thread>

#include <glisson/core/base/error.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson {
namespace {

int thread_count(int asked) {
  if (asked < 0 || asked > 1024)
    throw Error(ErrorKind::usage, "A run cannot have " + std::to_string(asked) +
                                      " threads. Use 1 to 1024, or 0 for all cores.");
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

[[noreturn]] void refuse_device(const std::string& device) {
  if (device.rfind("cuda", 0) == 0)
    throw Error(ErrorKind::device, "The device '" + device +
                                       "' is not available: this Glisson was built without CUDA. "
                                       "Use --device cpu, or --device auto to let it choose.");
  throw Error(ErrorKind::usage, "There is no device '" + device + "'. Choose auto, cpu, serial or cuda[:N].");
}

}  // namespace

std::unique_ptr<AnySimulation> make_simulation(const Model& model, const SimulationOptions& options) {
  const bool in_double = options.precision == Precision::double_precision;
  const std::string& device = options.device;
  if (device == "serial")
    return in_double ? detail::simulate_serial_double(model) : detail::simulate_serial_float(model);
  if (device == "emulated")
    return in_double ? detail::simulate_emulated_double(model) : detail::simulate_emulated_float(model);
  if (device != "cpu" && device != "auto") refuse_device(device);
  const int threads = thread_count(options.threads);
  if (in_double) return detail::simulate_threads_double(model, threads);
  return detail::simulate_threads_float(model, threads, options.instruction_set);
}

}  // namespace glisson
