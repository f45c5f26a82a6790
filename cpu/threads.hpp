// The backend for the cores of this machine.
#pragma once

#include <algorithm>
#include <cstring>

#include <glisson/core/backend.hpp>
#include <glisson/cpu/flush_to_zero.hpp>
#include <glisson/cpu/host_copies.hpp>
#include <glisson/cpu/memory.hpp>
#include <glisson/cpu/node_kernels.hpp>
#include <glisson/cpu/team.hpp>

namespace glisson {

/// Loops in equal shares over a persistent team. Bodies write disjoint places, so no result depends on the
/// number of threads.
class Threads : public HostCopies {
 public:
  /// Loops that cost less than so many cheap bodies run on the caller: waking the others would take longer.
  static constexpr int serial_below = 2048;
  /// Entries of a list of nodes: their rows lie in the caches of all cores, and each that must come from
  /// another one takes as long as waking the team.
  static constexpr int serial_nodes_below = 8;

  /// threads = 0: as many as this process may use.
  explicit Threads(int threads = 0, const char* instruction_set = "auto")
      : team_(threads), node_kernels_(&node_kernels(instruction_set)) {}

  Team& team() { return team_; }
  int thread_count() const { return team_.size(); }

  /// Zeroed; each page is touched first by the thread that for_each gives it to.
  template <class T>
  Buffer<T> allocate(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    T* data = static_cast<T*>(detail::allocate_untouched(count, sizeof(T)));
    const std::size_t bytes = count * sizeof(T), block = std::max<std::size_t>(4096, bytes >> 20);
    for_each(static_cast<int>((bytes + block - 1) / block), [=](int i) {
      const std::size_t first = static_cast<std::size_t>(i) * block;
      std::memset(reinterpret_cast<char*>(data) + first, 0, std::min(block, bytes - first));
    });
    return Buffer<T>(
        data, {[](void*, T* memory, std::size_t) { detail::release_untouched(memory); }, nullptr, count});
  }
  template <class F>
  void for_each(int n, F body) {
    static_assert(std::is_trivially_copyable_v<F>);
    constexpr int cost = cost_of_body<F>(),
                  serial = ListsNodes<F> ? serial_nodes_below : (serial_below + cost - 1) / cost;
    if (n < serial || thread_count() == 1) {
      const detail::FlushToZero flush;
      run_body(body, 0, n);
      return;
    }
    team_.run([this, n, body](int thread) {
      const Share share = share_of_body(n, thread, body);
      run_body(body, share.first, share.last);
    });
  }
  /// As glisson::run_loops.
  template <class Script>
  void run_loops(long long cost, const Script& script) {
    if (cost < serial_below || thread_count() == 1) {
      const detail::FlushToZero flush;
      script(LoopsOfThread{*this, 0, 1});
    } else {
      team_.run([&](int thread) { script(LoopsOfThread{*this, thread, team_.size()}); });
    }
  }

 private:
  /// What a script sees of the loops in one thread of the team.
  struct LoopsOfThread {
    Threads& threads;
    int thread, team_size;
    bool started = false;
    template <class F>
    void operator()(int n, const F& body) {
      if (started && team_size > 1) threads.team_.barrier();
      started = true;
      const Share share = team_size > 1 ? threads.share_of_body(n, thread, body) : Share{0, n};
      threads.run_body(body, share.first, share.last);
    }
  };
  template <class F>
  static constexpr int grain_of() {
    return std::max(1, 64 / cost_of_body<F>());
  }
  template <class F>
  Share share_of_body(int n, int thread, const F& body) const {
    if constexpr (WeighsCalls<F>)
      return weighed_share(n, thread, team_.size(), [&](int i) { return body.work_before(i); });
    else if constexpr (ListsNodes<F>)
      return listed_share(n, thread, team_.size(), body.node_count, [&](int i) { return body.node(i); });
    else
      return share_of(n, thread, team_.size(), grain_of<F>());
  }

  template <class F>
  void run_body(const F& body, int first, int last) const {
    if constexpr (requires { node_kernels_->run(body, first, last); })
      node_kernels_->run(body, first, last);
    else if constexpr (requires { body.run(first, last); })
      body.run(first, last);
    else
      for (int i = first; i < last; ++i) body(i);
  }

  Team team_;
  const NodeKernels* node_kernels_;
};

static_assert(Backend<Threads>);

}  // namespace glisson
