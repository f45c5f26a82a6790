// A sum that a device may still be working on.
#pragma once

#include <functional>
#include <utility>

namespace glisson {

/// Hosts give the number itself, devices what copies it when it is read. It may be read until what it is the
/// sum of is summed again.
class PendingSum {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): a number is a sum that is done
  PendingSum(double value = 0) : value_(value) {}
  explicit PendingSum(std::function<double()> wait_for_it) : wait_for_it_(std::move(wait_for_it)) {}

  /// Waits for a device; see copy_together().
  double read() const { return wait_for_it_ ? wait_for_it_() : value_; }

 private:
  double value_ = 0;
  std::function<double()> wait_for_it_;
};

}  // namespace glisson
