// The few calls of the CUDA runtime that the backend needs, behind a table: no CUDA header is needed to use
// it, and tests put a table of their own in its place, so that every failure can be tried on a machine
// without a GPU.
#pragma once

#include <cstddef>
#include <string>

namespace glisson::cuda {

struct DeviceFacts {
  std::string name;          ///< "NVIDIA H100"
  int major = 0, minor = 0;  ///< compute capability
  std::size_t memory = 0;    ///< [bytes]
  /// That the parameters of one kernel may have: 4096 before CUDA 12.1 and compute capability 7.0.
  std::size_t parameter_bytes = 4096;
};

/// Status codes are those of cudaError_t; 0 is success.
namespace status {
constexpr int done = 0, out_of_memory = 2, old_driver = 35, no_device = 100, invalid_device = 101,
              no_kernel_image = 209, ecc_error = 214, unsupported_ptx = 222, illegal_address = 700,
              launch_failure = 719;
}  // namespace status

/// `arguments` points to one pointer per argument of the kernel, as cudaLaunchKernel takes them.
struct KernelCall {
  const void* kernel;
  int blocks, threads;
  int members;  ///< second extent of the grid
  std::size_t shared_bytes;
  void** arguments;
};

struct Runtime {
  int (*device_count)(int* count);
  int (*describe)(int device, DeviceFacts* facts);
  int (*select)(int device);
  int (*check_kernels)();  ///< whether this build holds code for the selected device
  int (*create_stream)(void** stream);
  int (*destroy_stream)(void* stream);
  int (*allocate)(void** memory, std::size_t bytes);
  int (*release)(void* memory);
  /// Memory of the host that kernels can read and write at the same address.
  int (*allocate_pinned)(void** memory, std::size_t bytes);
  int (*release_pinned)(void* memory);
  int (*memory_info)(std::size_t* available, std::size_t* total);
  int (*clear)(void* memory, std::size_t bytes, void* stream);
  int (*copy_in)(const void* from, void* to, std::size_t bytes, void* stream);
  int (*copy_out)(const void* from, void* to, std::size_t bytes, void* stream);
  int (*wait)(void* stream);
  int (*launch)(const KernelCall& call, void* stream);
  int (*launch_status)();  ///< of the last call that failed, and forgets it
  /// A graph in which each call waits for the one before it.
  int (*make_graph)(void** graph, const KernelCall* calls, int count);
  /// Another call of the same kernel as call k, for the launches of the graph to come.
  int (*replace_in_graph)(void* graph, int k, const KernelCall& call);
  int (*launch_graph)(void* graph, void* stream);
  void (*destroy_graph)(void* graph);
  const char* (*text)(int code);
};

/// The real one; only in builds with CUDA.
const Runtime& real_runtime();

}  // namespace glisson::cuda
