#include <glisson/cpu/bandwidth.hpp>

#include <algorithm>
#include <chrono>
#include <vector>

namespace glisson {
namespace {

template <class Pass>
double best_seconds(Pass&& pass) {
  double best = 1e30;
  for (int repeat = 0; repeat < 6; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    pass();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

}  // namespace

Bandwidth measure_bandwidth(Threads& threads, std::size_t bytes) {
  const std::size_t count = std::max<std::size_t>(bytes / sizeof(float) / 64 * 64, 64), blocks = count / 64;
  const auto a = threads.allocate<float>(count), b = threads.allocate<float>(count),
             c = threads.allocate<float>(count);
  const auto sums = threads.allocate<float>(static_cast<std::size_t>(threads.thread_count()) * 16);
  auto over_blocks = [&](auto&& body) {
    threads.team().run([&](int thread) {
      const auto team = static_cast<std::size_t>(threads.thread_count()),
                 t = static_cast<std::size_t>(thread);
      body(thread, blocks * t / team * 64, blocks * (t + 1) / team * 64);
    });
  };
  const double read = best_seconds([&] {
    over_blocks([&](int thread, std::size_t first, std::size_t last) {
      float part[64] = {};  // 64 chains, so that additions do not limit the pass
      for (std::size_t i = first; i < last; i += 64)
        for (std::size_t k = 0; k < 64; ++k) part[k] += b[i + k];
      float sum = 0;
      for (const float p : part) sum += p;
      sums[static_cast<std::size_t>(thread) * 16] += sum;
    });
  });
  const double triad = best_seconds([&] {
    over_blocks([&](int, std::size_t first, std::size_t last) {
      float* to = a.get();
      const float *from = b.get(), *scaled = c.get();
      for (std::size_t i = first; i < last; ++i) to[i] = from[i] + 1.5f * scaled[i];
    });
  });
  const double array = static_cast<double>(count * sizeof(float));
  return {array / read, 3 * array / triad};
}

}  // namespace glisson
