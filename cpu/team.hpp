// A fixed team of threads that waits by spinning for a short while: starting a loop costs less than a
// microsecond.
#pragma once

#include <memory>
#include <type_traits>

namespace glisson {

/// Threads 1 .. size() - 1 are owned by the team; thread 0 is whoever calls run(). One caller at a time, no
/// nesting, and what is run must not throw. Idle members spin for some 50 us, then sleep until they are
/// needed.
class Team {
 public:
  /// threads = 0: as many as this process may use. Throws Error(usage) if negative or beyond max_size.
  explicit Team(int threads = 0);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  static constexpr int max_size = 1024;
  int size() const { return size_; }

  /// body(thread) on every thread of the team; returns when all have returned and their writes are visible.
  template <class F>
  void run(F&& body) {
    using Body = std::remove_reference_t<F>;
    run_erased([](void* it, int thread) { (*static_cast<Body*>(it))(thread); },
               const_cast<void*>(static_cast<const void*>(&body)));
  }

  /// Inside run(): waits for all threads; what they wrote before is visible after. Every thread must call it
  /// equally often.
  void barrier();

 private:
  struct State;
  void run_erased(void (*call)(void*, int), void* body);
  static void work(State& state, int thread);
  void close();

  int size_;
  std::unique_ptr<State> state_;
};

/// Places first .. last - 1 of n that belong to a thread: equal shares, cut at multiples of `grain`.
struct Share {
  int first, last;
};
constexpr Share share_of(int n, int thread, int thread_count, int grain = 64) {
  auto cut = [&](int t) {
    const long long grains = (static_cast<long long>(n) + grain - 1) / grain,
                    at = grains * t / thread_count * grain;
    return static_cast<int>(at < n ? at : n);
  };
  return {cut(thread), cut(thread + 1)};
}

/// Places that a thread has equal work with: work_before(i) rises from 0 to that of all n.
template <class WorkBefore>
constexpr Share weighed_share(int n, int thread, int thread_count, WorkBefore&& work_before) {
  const long long all = work_before(n);
  auto cut = [&](int t) {
    int first = 0, last = n;
    while (first < last) {
      const int middle = first + (last - first) / 2;
      if (work_before(middle) < all * t / thread_count)
        first = middle + 1;
      else
        last = middle;
    }
    return first;
  };
  return {cut(thread), thread + 1 == thread_count ? n : cut(thread + 1)};
}

/// The entries of a list of n that belong to a thread: those whose ascending nodes lie in its share of all
/// nodes.
template <class NodeOf>
constexpr Share listed_share(int n, int thread, int thread_count, int node_count, NodeOf&& node) {
  auto first_from = [&](int bound) {
    int first = 0, last = n;
    while (first < last) {
      const int middle = first + (last - first) / 2;
      if (node(middle) < bound)
        first = middle + 1;
      else
        last = middle;
    }
    return first;
  };
  const Share own = share_of(node_count, thread, thread_count);
  return {thread == 0 ? 0 : first_from(own.first), thread + 1 == thread_count ? n : first_from(own.last)};
}

}  // namespace glisson
