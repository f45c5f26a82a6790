// The backend for an NVIDIA GPU. Included only by .cu files.
#pragma once

#include <bit>
#include <type_traits>

#include <glisson/core/backend.hpp>
#include <glisson/core/chunk_sums.hpp>
#include <glisson/cuda/device.hpp>

namespace glisson {
namespace cuda {

constexpr int threads_per_block = 128;

template <class F>
__global__ void __launch_bounds__(threads_per_block) for_each_kernel(int n, F body) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n) body(i);
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
__global__ void __launch_bounds__(threads_per_block) chunk_kernel(int n, F body) {
  constexpr int lanes = chunk_lanes<F>;
  const int thread = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  const int c = thread / lanes, lane = thread % lanes;
  // chunks past the end take part in the shuffles of their warp
  auto sum = c < n ? sum_of_entries(body, c, lane, lanes) : typename F::Sum{};
  for (int step = lanes / 2; step > 0; step /= 2) F::join(sum, shuffled_down(sum, step, lanes));
  if (lane == 0 && c < n) body.leave(c, sum);
}

}  // namespace cuda

/// One device, one stream: launches run one after the other, so that each sees what those before it wrote.
/// They are sent in groups (cuda/launch_queue.hpp). A fault inside a kernel is reported by the next copy_out.
class Cuda {
 public:
  static constexpr Space space = Space::device;

  explicit Cuda(int number = 0) : device_(std::make_unique<cuda::Device>(cuda::real_runtime(), number)) {}

  const cuda::DeviceFacts& facts() const { return device_->facts(); }

  /// Zeroed.
  template <class T>
  Buffer<T> allocate(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    auto release = [](void* device, T* memory, std::size_t) {
      static_cast<cuda::Device*>(device)->release(memory);
    };
    return Buffer<T>(static_cast<T*>(device_->allocate(count * sizeof(T))), {release, device_.get(), count});
  }
  template <class T>
  void copy_in(const T* from, T* to, std::size_t count) {
    device_->copy_in(from, to, count * sizeof(T));
  }
  template <class T>
  void copy_out(const T* from, T* to, std::size_t count) {
    device_->copy_out(from, to, count * sizeof(T));
  }
  template <class F>
  void for_each(int n, F body) {
    static_assert(std::is_trivially_copyable_v<F>, "what travels to a device is plain data");
    if (n <= 0) return;
    constexpr int threads = cuda::threads_per_block;
    if constexpr (SumsChunks<F>) {
      constexpr int chunks = threads / chunk_lanes<F>;
      launch((n - 1) / chunks + 1, threads, 0, cuda::chunk_kernel<F>, n, body);
    } else {
      launch((n - 1) / threads + 1, threads, 0, cuda::for_each_kernel<F>, n, body);
    }
  }
  /// Any kernel, in order with all others.
  template <class... Parameters>
  void launch(int blocks, int threads, std::size_t shared_bytes, void (*kernel)(Parameters...),
              const std::type_identity_t<Parameters>&... arguments) {
    device_->launch(reinterpret_cast<const void*>(kernel), blocks, threads, shared_bytes, arguments...);
  }
  /// Until everything that was launched is done; reports what failed in it.
  void wait() { device_->wait(); }
  /// Between two steps of a simulation; see cuda/launch_queue.hpp.
  void step_done() { device_->step_done(); }
  /// Launches wait in a queue: wait() comes before anything else is put on the stream.
  void* stream() { return device_->stream(); }

 private:
  std::unique_ptr<cuda::Device>
      device_;  // on the heap: buffers point to it and must survive a move of the backend
};

static_assert(Backend<Cuda>);

}  // namespace glisson
