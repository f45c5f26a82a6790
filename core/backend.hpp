// What the engine asks of a backend: memory, copies and a loop. CUDA, threads and the emulated device all fit
// this.
#pragma once

#include <concepts>
#include <memory>

#include <glisson/core/base/host_device.hpp>
#include <glisson/core/force_provider.hpp>

namespace glisson {

template <class T>
struct BufferDeleter {
  void (*release)(void* context, T* data, std::size_t count) = nullptr;
  void* context = nullptr;
  std::size_t count = 0;
  void operator()(T* data) const {
    if (data) release(context, data, count);
  }
};
/// Memory of a backend; [size()] elements; freed by the backend that gave it, which must outlive it.
template <class T>
using Buffer = std::unique_ptr<T[], BufferDeleter<T>>;

struct NoBody {
  GLISSON_HD void operator()(int) const {}
};

/// What one call of a body takes in units of a cheap one (about 1 ns): bodies that stand for many nodes or
/// entries say so in `cost`, so that a backend can judge whether a short loop is worth its team.
template <class F>
constexpr int cost_of_body() {
  if constexpr (requires { F::cost; })
    return F::cost;
  else
    return 1;
}

/// A body over a list of nodes in ascending order says which node entry i stands for, and how many nodes
/// there are: a backend can then leave every node to the thread that has it in its cache.
template <class F>
concept ListsNodes = requires(const F& body, int i) {
  { body.node(i) } -> std::convertible_to<int>;
  { body.node_count } -> std::convertible_to<int>;
};

/// for_each runs body(0) ... body(n - 1) in any order and returns when they are visible to the next call.
/// Bodies are trivially copyable, write disjoint places and never see the host.
template <class B>
concept Backend = requires(B& backend, std::size_t n, const float* from, float* to, NoBody body) {
  { B::space } -> std::convertible_to<Space>;
  { backend.template allocate<float>(n) } -> std::same_as<Buffer<float>>;
  { backend.copy_in(from, to, n) } -> std::same_as<void>;   // host -> backend
  { backend.copy_out(from, to, n) } -> std::same_as<void>;  // backend -> host, waits
  { backend.for_each(int(n), body) } -> std::same_as<void>;
  { backend.stream() } -> std::same_as<void*>;
};

}  // namespace glisson
