#include <glisson/app/bandwidth.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <thread>
#include <vector>

namespace glisson::app {

double measured_bandwidth(int threads) {
  constexpr std::size_t count = 16 << 20;  // 3 arrays of 64 MB
  std::vector<float> a(count, 0.0f), b(count, 1.0f), c(count, 2.0f);
  const auto sweep = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) a[i] = b[i] + 0.5f * c[i];
  };
  double best = 0;
  for (int repeat = 0; repeat < 7; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::jthread> team;
    const auto n = static_cast<std::size_t>(std::max(1, threads));
    for (std::size_t t = 0; t < n; ++t) team.emplace_back(sweep, count * t / n, count * (t + 1) / n);
    team.clear();  // joins
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    best = std::max(best, 3.0 * sizeof(float) * static_cast<double>(count) / seconds);
  }
  return best;
}

}  // namespace glisson::app
