// The backend for an NVIDIA GPU. Included only by .cu files.
#pragma once

#include <bit>

#include <cuda_runtime_api.h>

#include <glisson/cuda/device_backend.hpp>

namespace glisson {
namespace cuda {

/// What the parameters of a kernel may have in this build; the driver decides whether it takes as much.
constexpr std::size_t most_parameter_bytes = CUDART_VERSION >= 12010 ? 32764 : 4096;

/// Members of an ensemble in one launch: as many bodies as fit, but no more than keep a GPU busy, because all
/// these bytes travel with every launch, however many members it has.
template <class F>
constexpr int several_capacity = [] {
  const std::size_t fit = (most_parameter_bytes - SeveralKernel::room_in_front) / sizeof(F);
  return static_cast<int>(fit < 32 ? fit : 32);
}();

/// The bodies of the members in the parameters of a kernel, where every thread of a block reads the same one.
template <class F>
struct Several {
  F body[several_capacity<F>];
};

template <class F>
__global__ void __launch_bounds__(threads_per_block) for_each_kernel(int n, F body) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n) body(i);
}

template <class F>
__global__ void __launch_bounds__(threads_per_block)
    several_for_each_kernel(int n, const __grid_constant__ Several<F> bodies) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n) bodies.body[blockIdx.y](i);
}

/// The value of the lane `distance` further on among `lanes` that share a chunk.
template <class T>
__device__ T shuffled_down(const T& value, int distance, int lanes) {
  static_assert(sizeof(T) % sizeof(unsigned) == 0);
  struct Words {
    unsigned word[sizeof(T) / sizeof(unsigned)];
  };
  Words words = std::bit_cast<Words>(value);
  for (unsigned& word : words.word) word = __shfl_down_sync(0xffffffffu, word, distance, lanes);
  return std::bit_cast<T>(words);
}

/// Bodies that leave one sum per chunk: see core/chunk_sums.hpp, whose run_chunk_in_lanes is the twin.
template <class F>
__device__ void sum_in_lanes(int n, const F& body) {
  constexpr int lanes = chunk_lanes<F>;
  const int thread = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  const int c = thread / lanes, lane = thread % lanes;
  // chunks past the end take part in the shuffles of their warp
  auto sum = c < n ? sum_of_entries(body, c, lane, lanes) : typename F::Sum{};
  for (int step = lanes / 2; step > 0; step /= 2) F::join(sum, shuffled_down(sum, step, lanes));
  if (lane == 0 && c < n) body.leave(c, sum);
}

template <class F>
__global__ void __launch_bounds__(threads_per_block) chunk_kernel(int n, F body) {
  sum_in_lanes(n, body);
}

template <class F>
__global__ void __launch_bounds__(threads_per_block)
    several_chunk_kernel(int n, const __grid_constant__ Several<F> bodies) {
  sum_in_lanes(n, bodies.body[blockIdx.y]);
}

/// A kernel and its twin for several members, whose last parameters are a body and several.
template <class F, class... Front>
TypedKernel<Front..., F> with_twin(void (*one)(Front..., F), void (*several)(Front..., Several<F>)) {
  static const SeveralKernel twin{reinterpret_cast<const void*>(several), sizeof(F), several_capacity<F>};
  return {{reinterpret_cast<const void*>(one), &twin}};
}

struct GpuKernels {
  template <class F>
  static TypedKernel<int, F> each() {
    return with_twin<F, int>(for_each_kernel<F>, several_for_each_kernel<F>);
  }
  template <class F>
  static TypedKernel<int, F> chunks() {
    return with_twin<F, int>(chunk_kernel<F>, several_chunk_kernel<F>);
  }
};

}  // namespace cuda

class Cuda : public cuda::DeviceBackend<cuda::GpuKernels> {
 public:
  using DeviceBackend::DeviceBackend;
  explicit Cuda(int number = 0)
      : DeviceBackend(std::make_unique<cuda::Device>(cuda::real_runtime(), number)) {}
};

static_assert(Backend<Cuda>);

}  // namespace glisson
