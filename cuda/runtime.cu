#include <cuda_runtime.h>

#include <glisson/cuda/runtime.hpp>

namespace glisson::cuda {
namespace {

static_assert(cudaSuccess == status::done && cudaErrorMemoryAllocation == status::out_of_memory &&
              cudaErrorInsufficientDriver == status::old_driver && cudaErrorNoDevice == status::no_device &&
              cudaErrorInvalidDevice == status::invalid_device &&
              cudaErrorNoKernelImageForDevice == status::no_kernel_image &&
              cudaErrorECCUncorrectable == status::ecc_error &&
              cudaErrorUnsupportedPtxVersion == status::unsupported_ptx &&
              cudaErrorIllegalAddress == status::illegal_address &&
              cudaErrorLaunchFailure == status::launch_failure);

__global__ void probe() {}

cudaStream_t stream_of(void* stream) { return static_cast<cudaStream_t>(stream); }

int describe(int device, DeviceFacts* facts) {
  cudaDeviceProp properties;
  if (const int code = cudaGetDeviceProperties(&properties, device)) return code;
  *facts = {properties.name, properties.major, properties.minor, properties.totalGlobalMem};
  return status::done;
}

int check_kernels() {
  cudaFuncAttributes attributes;
  return cudaFuncGetAttributes(&attributes, probe);
}

int create_stream(void** stream) {
  cudaStream_t created = nullptr;
  const int code = cudaStreamCreateWithFlags(&created, cudaStreamNonBlocking);
  *stream = created;
  return code;
}

// From and to ordinary memory: waits, because the source may go out of scope right after the call.
int copy(const void* from, void* to, std::size_t bytes, cudaMemcpyKind kind, void* stream) {
  if (const int code = cudaMemcpyAsync(to, from, bytes, kind, stream_of(stream))) return code;
  return cudaStreamSynchronize(stream_of(stream));
}

const Runtime table{
    [](int* count) -> int { return cudaGetDeviceCount(count); },
    describe,
    [](int device) -> int { return cudaSetDevice(device); },
    check_kernels,
    create_stream,
    [](void* stream) -> int { return cudaStreamDestroy(stream_of(stream)); },
    [](void** memory, std::size_t bytes) -> int { return cudaMalloc(memory, bytes); },
    [](void* memory) -> int { return cudaFree(memory); },
    [](std::size_t* available, std::size_t* total) -> int { return cudaMemGetInfo(available, total); },
    [](void* memory, std::size_t bytes, void* stream) -> int {
      return cudaMemsetAsync(memory, 0, bytes, stream_of(stream));
    },
    [](const void* from, void* to, std::size_t bytes, void* stream) -> int {
      return copy(from, to, bytes, cudaMemcpyHostToDevice, stream);
    },
    [](const void* from, void* to, std::size_t bytes, void* stream) -> int {
      return copy(from, to, bytes, cudaMemcpyDeviceToHost, stream);
    },
    [](void* stream) -> int { return cudaStreamSynchronize(stream_of(stream)); },
    []() -> int { return cudaGetLastError(); },
    [](int code) -> const char* { return cudaGetErrorString(static_cast<cudaError_t>(code)); },
};

}  // namespace

const Runtime& real_runtime() { return table; }

}  // namespace glisson::cuda
