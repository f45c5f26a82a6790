#include <cuda_runtime.h>

#include <memory>
#include <vector>

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
  int driver = 0;
  if (const int code = cudaDriverGetVersion(&driver)) return code;
  const bool large = driver >= 12010 && properties.major >= 7;
  *facts = {properties.name, properties.major, properties.minor, properties.totalGlobalMem,
            large ? std::size_t{32764} : std::size_t{4096}};
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

dim3 grid_of(const KernelCall& call) {
  return {static_cast<unsigned>(call.blocks), static_cast<unsigned>(call.members)};
}

int launch(const KernelCall& call, void* stream) {
  return cudaLaunchKernel(call.kernel, grid_of(call), dim3(static_cast<unsigned>(call.threads)),
                          call.arguments, call.shared_bytes, stream_of(stream));
}

cudaKernelNodeParams node_of(const KernelCall& call) {
  cudaKernelNodeParams node = {};
  node.func = const_cast<void*>(call.kernel);
  node.gridDim = grid_of(call);
  node.blockDim = dim3(static_cast<unsigned>(call.threads));
  node.sharedMemBytes = static_cast<unsigned>(call.shared_bytes);
  node.kernelParams = call.arguments;
  return node;
}

/// A chain of kernels. The graph stays: its nodes name those of what was instantiated from it.
struct Chain {
  cudaGraph_t graph = nullptr;
  cudaGraphExec_t ready = nullptr;
  std::vector<cudaGraphNode_t> nodes{};

  Chain() = default;
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;
  ~Chain() {
    if (ready) cudaGraphExecDestroy(ready);
    if (graph) cudaGraphDestroy(graph);
  }
  int add(const KernelCall& call) {
    const cudaKernelNodeParams node = node_of(call);
    cudaGraphNode_t added = nullptr;
    const cudaGraphNode_t* before = nodes.empty() ? nullptr : &nodes.back();
    const int code = cudaGraphAddKernelNode(&added, graph, before, nodes.empty() ? 0 : 1, &node);
    nodes.push_back(added);
    return code;
  }
};

int make_graph(void** graph, const KernelCall* calls, int count) {
  auto chain = std::make_unique<Chain>();
  if (const int code = cudaGraphCreate(&chain->graph, 0)) return code;
  for (int k = 0; k < count; ++k)
    if (const int code = chain->add(calls[k])) return code;
  if (const int code = cudaGraphInstantiate(&chain->ready, chain->graph, 0)) return code;
  *graph = chain.release();
  return status::done;
}

Chain& chain_of(void* graph) { return *static_cast<Chain*>(graph); }

int replace_in_graph(void* graph, int k, const KernelCall& call) {
  const cudaKernelNodeParams node = node_of(call);
  Chain& chain = chain_of(graph);
  return cudaGraphExecKernelNodeSetParams(chain.ready, chain.nodes[static_cast<std::size_t>(k)], &node);
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
    [](void** memory, std::size_t bytes) -> int {
      return cudaHostAlloc(memory, bytes, cudaHostAllocPortable | cudaHostAllocMapped);
    },
    [](void* memory) -> int { return cudaFreeHost(memory); },
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
    launch,
    []() -> int { return cudaGetLastError(); },
    make_graph,
    replace_in_graph,
    [](void* graph, void* stream) -> int {
      return cudaGraphLaunch(chain_of(graph).ready, stream_of(stream));
    },
    [](void* graph) { delete static_cast<Chain*>(graph); },
    [](int code) -> const char* { return cudaGetErrorString(static_cast<cudaError_t>(code)); },
};

}  // namespace

const Runtime& real_runtime() { return table; }

}  // namespace glisson::cuda
