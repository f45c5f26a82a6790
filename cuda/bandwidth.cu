#include <algorithm>
#include <chrono>

#include <glisson/core/tensor/tensor.hpp>
#include <glisson/cuda/backend.cuh>
#include <glisson/cuda/bandwidth.hpp>

namespace glisson::cuda {
namespace {

struct CopyRows {
  const Vec4<float>* from;
  Vec4<float>* to;
  GLISSON_HD void operator()(int i) const { to[i] = from[i]; }
};

}  // namespace

double measure_copy_bandwidth(int number, std::size_t bytes) {
  using Clock = std::chrono::steady_clock;
  constexpr int copies = 20;  // in one measurement: the launch and the wait cost little then
  Cuda backend(number);
  const int rows = static_cast<int>(std::min<std::size_t>(bytes / sizeof(Vec4<float>), 1u << 30));
  const auto from = backend.allocate<Vec4<float>>(static_cast<std::size_t>(rows));
  const auto to = backend.allocate<Vec4<float>>(static_cast<std::size_t>(rows));
  double best = 1e30;
  for (int repeat = 0; repeat < 10; ++repeat) {
    backend.wait();
    const auto start = Clock::now();
    for (int i = 0; i < copies; ++i) backend.for_each(rows, CopyRows{from.get(), to.get()});
    backend.wait();
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return 2.0 * copies * double(rows) * sizeof(Vec4<float>) / best;
}

}  // namespace glisson::cuda
