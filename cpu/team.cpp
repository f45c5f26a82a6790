// The only place that knows Boost.Thread.
#include <glisson/cpu/team.hpp>

#include <atomic>
#include <thread>
#include <vector>

#include <boost/thread/condition_variable.hpp>
#include <boost/thread/mutex.hpp>
#include <boost/thread/thread.hpp>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/flush_to_zero.hpp>
#include <glisson/cpu/memory.hpp>

namespace glisson {
namespace {

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

int checked(int threads) {
  if (threads < 0 || threads > Team::max_size)
    throw Error(ErrorKind::usage, "A team of " + std::to_string(threads) +
                                      " threads is not possible. Use 1 to " + std::to_string(Team::max_size) +
                                      ", or 0 for as many as the machine has.");
  const int available = static_cast<int>(std::thread::hardware_concurrency());
  return threads > 0 ? threads : std::min(std::max(available, 1), Team::max_size);
}

}  // namespace

/// `round` counts calls of run(); a thread works when it sees a round that it has not worked in. The order of
/// the two sequentially consistent operations (round then sleepers here, sleepers then round in
/// `wait_for_round`) makes sure that either the caller sees the sleeper or the sleeper sees the round.
struct Team::State {
  alignas(detail::cache_line) std::atomic<unsigned> round{0};
  alignas(detail::cache_line) std::atomic<int> working{0};
  alignas(detail::cache_line) std::atomic<int> arrived{0};
  alignas(detail::cache_line) std::atomic<unsigned> phase{0};
  alignas(detail::cache_line) std::atomic<int> sleepers{0};
  std::atomic<bool> closing{false};
  void (*call)(void*, int) = nullptr;
  void* body = nullptr;
  int size = 1;
  int spins = 0;  ///< looks before a thread gives its core away
  boost::mutex mutex;
  boost::condition_variable wake;
  std::vector<boost::thread> threads;

  template <class Condition>
  void spin_then_yield(Condition reached) const {
    for (int i = 0; !reached(); ++i) i < spins ? pause() : std::this_thread::yield();
  }

  void wait_for_round(unsigned seen) {
    for (int i = 0; i < spins; ++i) {
      if (round.load(std::memory_order_acquire) != seen) return;
      pause();
    }
    boost::unique_lock<boost::mutex> lock(mutex);
    sleepers.fetch_add(1);
    while (round.load() == seen) wake.wait(lock);
    sleepers.fetch_sub(1);
  }
  void start_round() {
    round.fetch_add(1);
    if (sleepers.load() > 0) {
      boost::lock_guard<boost::mutex> lock(mutex);
      wake.notify_all();
    }
  }
};

void Team::work(State& state, int thread) {
  const detail::FlushToZero flush;
  for (unsigned seen = 0;; ++seen) {
    state.wait_for_round(seen);
    if (state.closing.load(std::memory_order_relaxed)) return;
    state.call(state.body, thread);
    state.working.fetch_sub(1, std::memory_order_release);
  }
}

Team::Team(int threads) : size_(checked(threads)), state_(std::make_unique<State>()) {
  state_->size = size_;
  // A pause takes 10 to 40 ns. With more threads than cores, spinning keeps the awaited thread from running.
  state_->spins = size_ <= static_cast<int>(std::thread::hardware_concurrency()) ? 2000 : 0;
  try {
    for (int t = 1; t < size_; ++t)
      state_->threads.emplace_back([state = state_.get(), t] { work(*state, t); });
  } catch (...) {
    close();
    throw Error(ErrorKind::run,
                "The system refuses to start " + std::to_string(size_) + " threads. Use fewer.");
  }
}

Team::~Team() { close(); }

void Team::close() {
  state_->closing.store(true, std::memory_order_relaxed);
  state_->start_round();
  for (boost::thread& thread : state_->threads) thread.join();
}

void Team::run_erased(void (*call)(void*, int), void* body) {
  if (size_ > 1) {
    state_->call = call;
    state_->body = body;
    state_->working.store(size_ - 1, std::memory_order_relaxed);
    state_->start_round();
  }
  {
    const detail::FlushToZero flush;
    call(body, 0);
  }
  if (size_ > 1)
    state_->spin_then_yield([this] { return state_->working.load(std::memory_order_acquire) == 0; });
}

void Team::barrier() {
  if (size_ == 1) return;
  State& state = *state_;
  const unsigned phase = state.phase.load(std::memory_order_relaxed);
  if (state.arrived.fetch_add(1, std::memory_order_acq_rel) == size_ - 1) {
    state.arrived.store(0, std::memory_order_relaxed);
    state.phase.store(phase + 1, std::memory_order_release);
  } else {
    state.spin_then_yield([&] { return state.phase.load(std::memory_order_acquire) != phase; });
  }
}

}  // namespace glisson
