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

/// A body whose calls take different times says what those before call i take together, in any unit and for i
/// up to the end of the loop: a backend can then give each of its threads the same work.
template <class F>
concept WeighsCalls = requires(const F& body, int i) {
  { body.work_before(i) } -> std::convertible_to<long long>;
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

/// Loops of a backend one after the other, without a team.
template <Backend B>
struct LoopsOneByOne {
  B& backend;
  static constexpr int team_size = 1;
  template <class F>
  void operator()(int n, const F& body) const {
    backend.for_each(n, body);
  }
};

/// Loops one after the other: script(loop) calls loop(n, body) for each, which stands for for_each(n, body).
/// A backend with a team runs the script on each of its threads, which then start once and wait for each
/// other between the loops only; so the script must come to the same loops on each, and change nothing
/// itself. loop.team_size: calls that all run at a time, for bodies that divide something by themselves.
/// cost: of the longest loop, as cost_of_body.
template <Backend B, class Script>
void run_loops(B& backend, long long cost, const Script& script) {
  if constexpr (requires { backend.run_loops(cost, script); })
    backend.run_loops(cost, script);
  else
    script(LoopsOneByOne<B>{backend});
}

/// read() copies from the backend and changes nothing that it reads again. A device runs it twice, so that
/// all of its copies share one wait: first to learn what it copies, when nothing arrives.
template <Backend B, class Read>
void copy_together(B& backend, const Read& read) {
  if constexpr (requires { backend.copy_together(read); })
    backend.copy_together(read);
  else
    read();
}

/// A host array in the backend's memory, where it is only read from now on: a backend may give one place to
/// several simulations.
template <Backend B, class T>
Buffer<T> upload_constant(B& backend, const T* from, std::size_t count) {
  if constexpr (requires { backend.upload_constant(from, count); }) {
    return backend.upload_constant(from, count);
  } else {
    auto buffer = backend.template allocate<T>(count);
    backend.copy_in(from, buffer.get(), count);
    return buffer;
  }
}

}  // namespace glisson
