// What every backend around a cuda::Device shares. Plain C++: the kernels come from a class that knows them,
// so that tests can put functions of the host in their place.
#pragma once

#include <cstring>
#include <memory>
#include <type_traits>

#include <glisson/core/backend.hpp>
#include <glisson/core/chunk_sums.hpp>
#include <glisson/cuda/device.hpp>
#include <glisson/cuda/joint_copies.hpp>

namespace glisson::cuda {

constexpr int threads_per_block = 128;

/// A kernel with these parameters.
template <class... Parameters>
struct TypedKernel {
  KernelPair pair;
};

/// A copy between the device and memory of the host that kernels reach.
struct CopyWords {
  const unsigned* from;
  unsigned* to;
  GLISSON_HD void operator()(int i) const { to[i] = from[i]; }
};

/// One device, one stream: launches run one after the other, so that each sees what those before it wrote.
/// They are sent in groups (cuda/launch_queue.hpp). A fault inside a kernel is reported by the next copy_out.
/// Kernels::each<F>() and chunks<F>() are TypedKernel<int, F>, for bodies and for those that leave sums.
template <class Kernels>
class DeviceBackend {
 public:
  static constexpr Space space = Space::device;

  explicit DeviceBackend(std::unique_ptr<Device> device) : device_(std::move(device)) {}

  const DeviceFacts& facts() const { return device_->facts(); }

  /// Zeroed.
  template <class T>
  Buffer<T> allocate(std::size_t count) {
    return buffer_of<T>(device_->allocate(count * sizeof(T)), count);
  }
  /// Members of a group share what has the same bytes.
  template <class T>
  Buffer<T> upload_constant(const T* from, std::size_t count) {
    if (void* shared = device_->share(from, count * sizeof(T))) return buffer_of<T>(shared, count);
    auto buffer = allocate<T>(count);
    copy_in(from, buffer.get(), count);
    return buffer;
  }
  template <class T>
  void copy_in(const T* from, T* to, std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (unsigned* place = in_words<T> ? device_->place_to_copy_in(bytes) : nullptr) {
      std::memcpy(place, from, bytes);
      copy_words(place, reinterpret_cast<unsigned*>(to), bytes);
    } else {
      device_->copy_in(from, to, bytes);
    }
  }
  template <class T>
  void copy_out(const T* from, T* to, std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (joint_.asks()) {
      if (in_words<T> && bytes > 0) joint_.ask(from, bytes);
    } else if (const void* here = joint_.read(from, bytes)) {
      std::memcpy(static_cast<void*>(to), here, bytes);
    } else if (unsigned* place = in_words<T> ? device_->place_to_copy_out(bytes) : nullptr) {
      copy_words(reinterpret_cast<const unsigned*>(from), place, bytes);
      wait();
      std::memcpy(static_cast<void*>(to), place, bytes);
    } else {
      device_->copy_out(from, to, bytes);
    }
  }
  /// See glisson::copy_together(). Copies are launches, sent with those that are still waiting.
  template <class Read>
  void copy_together(const Read& read) {
    struct End {
      JointCopies& joint;
      ~End() { joint.end(); }
    } end{joint_};
    joint_.begin();
    read();
    if (unsigned* place = device_->place_for_joint_copies(joint_.bytes())) {
      joint_.to(place,
                [&](const unsigned* from, unsigned* to, std::size_t bytes) { copy_words(from, to, bytes); });
      wait();
      joint_.arrived(place);
    } else {
      joint_.end();  // one by one
    }
    read();
  }
  template <class F>
  void for_each(int n, F body) {
    static_assert(std::is_trivially_copyable_v<F>, "what travels to a device is plain data");
    if (n <= 0) return;
    constexpr int threads = threads_per_block;
    if constexpr (SumsChunks<F>) {
      constexpr int chunks = threads / chunk_lanes<F>;
      launch((n - 1) / chunks + 1, threads, 0, Kernels::template chunks<F>(), n, body);
    } else {
      launch((n - 1) / threads + 1, threads, 0, Kernels::template each<F>(), n, body);
    }
  }
  /// Any kernel, in order with all others.
  template <class... Parameters>
  void launch(int blocks, int threads, std::size_t shared_bytes, const TypedKernel<Parameters...>& kernel,
              const std::type_identity_t<Parameters>&... arguments) {
    device_->launch(kernel.pair, blocks, threads, shared_bytes, arguments...);
  }
  /// Until everything that was launched is done; reports what failed in it.
  void wait() { device_->wait(); }
  /// Between two steps of a simulation; see cuda/launch_queue.hpp.
  void step_done() { device_->step_done(); }
  /// Launches wait in a queue: wait() comes before anything else is put on the stream.
  void* stream() { return device_->stream(); }

 private:
  template <class T>
  static constexpr bool in_words = alignof(T) >= alignof(unsigned);

  template <class T>
  Buffer<T> buffer_of(void* memory, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    auto release = [](void* device, T* data, std::size_t) { static_cast<Device*>(device)->release(data); };
    return Buffer<T>(static_cast<T*>(memory), {release, device_.get(), count});
  }
  void copy_words(const unsigned* from, unsigned* to, std::size_t bytes) {
    for_each(static_cast<int>(bytes / sizeof(unsigned)), CopyWords{from, to});
  }

  std::unique_ptr<Device> device_;  // on the heap: buffers point to it and must survive a move of the backend
  JointCopies joint_;
};

}  // namespace glisson::cuda
