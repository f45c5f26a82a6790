// Sums over arrays in a backend's memory, without atomics.
#pragma once

#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/pending_sum.hpp>

namespace glisson {

/// sums[p] = values[p] + values[p + parts] + ...: neighbouring threads read neighbouring values.
struct SumStrided {
  const double* values;  ///< [count]
  int count, parts;
  double* sums;  ///< [parts]
  GLISSON_HD void operator()(int p) const {
    double sum = 0;
    for (int i = p; i < count; i += parts) sum += values[i];
    sums[p] = sum;
  }
};

/// The order of the additions depends on the length alone: the same bits every time. On a device two launches
/// leave 128 numbers to copy.
template <Backend B>
class ArraySum {
  static constexpr int first_parts = 8192, last_parts = 128;

 public:
  /// results: sums that may be pending at the same time.
  explicit ArraySum(B& backend, int results = 1)
      : backend_(backend),
        first_(backend.template allocate<double>(first_parts)),
        last_(backend.template allocate<double>(static_cast<std::size_t>(results) * last_parts)),
        host_(last_parts) {}

  PendingSum operator()(const double* values, int count, int result = 0) const {
    if constexpr (B::space == Space::host) {
      double sum = 0;
      for (int i = 0; i < count; ++i) sum += values[i];
      return sum;
    } else {
      if (count == 0) return 0;
      if (count > first_parts) {
        backend_.for_each(first_parts, SumStrided{values, count, first_parts, first_.get()});
        values = first_.get(), count = first_parts;
      }
      double* last = last_.get() + result * last_parts;
      backend_.for_each(last_parts, SumStrided{values, count, last_parts, last});
      return PendingSum([this, last] { return sum_of_last(last); });
    }
  }

 private:
  double sum_of_last(const double* last) const {
    backend_.copy_out(last, host_.data(), host_.size());
    double sum = 0;
    for (const double part : host_) sum += part;
    return sum;
  }

  B& backend_;
  Buffer<double> first_, last_;
  mutable std::vector<double> host_;
};

}  // namespace glisson
