// The GPUs that simulations can run on.
#pragma once

#include <string>
#include <vector>

namespace glisson {

struct Gpu {
  std::string name;        ///< "NVIDIA H100"
  std::string capability;  ///< "9.0"
  std::size_t memory_bytes = 0;
};

/// Whether this build holds the CUDA backend.
bool built_with_cuda();

/// cuda:0, cuda:1, ... of this machine; empty without a driver, a device, or CUDA in the build.
std::vector<Gpu> find_gpus();

/// Throws Error(device) with the reason if no simulation can run on "cuda" or "cuda:N".
void require_gpu(const std::string& device);

/// Bytes read and written per second by a copy in the memory of "cuda" or "cuda:N". Takes 512 MB of it and a
/// few milliseconds. Throws Error(device) where simulations on it would.
double gpu_copy_bandwidth(const std::string& device);

}  // namespace glisson
