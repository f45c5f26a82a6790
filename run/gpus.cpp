#include <glisson/run/gpus.hpp>

#include <glisson/core/base/error.hpp>
#include <glisson/cuda/bandwidth.hpp>
#include <glisson/cuda/device.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson {

#ifdef GLISSON_WITH_CUDA

bool built_with_cuda() { return true; }

std::vector<Gpu> find_gpus() {
  std::vector<Gpu> gpus;
  for (const auto& facts : cuda::find_devices(cuda::real_runtime()))
    gpus.push_back(
        {facts.name, std::to_string(facts.major) + "." + std::to_string(facts.minor), facts.memory});
  return gpus;
}

namespace detail {

std::unique_ptr<cuda::Device> open_gpu(int number) {
  return std::make_unique<cuda::Device>(cuda::real_runtime(), number);
}
std::unique_ptr<cuda::DeviceGroup> open_gpu_group(int number,
                                                  std::shared_ptr<cuda::ConstantArrays> constants) {
  return std::make_unique<cuda::DeviceGroup>(cuda::real_runtime(), number, std::move(constants));
}

}  // namespace detail

void require_gpu(const std::string& device) { detail::open_gpu(cuda::device_number(device)); }

double gpu_copy_bandwidth(const std::string& device) {
  return cuda::measure_copy_bandwidth(cuda::device_number(device), std::size_t{256} << 20);
}

#else

bool built_with_cuda() { return false; }

std::vector<Gpu> find_gpus() { return {}; }

namespace detail {
namespace {

[[noreturn]] void refuse(int number) {
  throw Error(ErrorKind::device, "The device 'cuda:" + std::to_string(number) +
                                     "' is not available: this Glisson was built without CUDA. "
                                     "Use --device cpu, or --device auto to let it choose.");
}

}  // namespace

std::unique_ptr<cuda::Device> open_gpu(int number) { refuse(number); }
std::unique_ptr<cuda::DeviceGroup> open_gpu_group(int number, std::shared_ptr<cuda::ConstantArrays>) {
  refuse(number);
}
std::unique_ptr<AnySimulation> simulate_cuda_double(const Model&, std::unique_ptr<cuda::Device>) {
  refuse(0);
}
std::unique_ptr<AnySimulation> simulate_cuda_float(const Model&, std::unique_ptr<cuda::Device>) { refuse(0); }

}  // namespace detail

void require_gpu(const std::string& device) { detail::refuse(cuda::device_number(device)); }

double gpu_copy_bandwidth(const std::string& device) { detail::refuse(cuda::device_number(device)); }

#endif

}  // namespace glisson
