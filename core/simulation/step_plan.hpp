// When the steps of a run happen. Time comes from an integer step counter, so that n steps of dt end exactly
// at n dt and the run ends exactly at its total time.
#pragma once

#include <cstdint>

namespace glisson {

class StepPlan {
 public:
  StepPlan() = default;
  /// Equal steps of at most `dt_wish` that end at `total` [s].
  StepPlan(double total, double dt_wish);
  /// Steps of dt without an end (dynamic relaxation).
  static StepPlan endless(double dt);

  double dt() const { return dt_; }
  double time(std::int64_t step) const { return base_time_ + double(step - base_step_) * dt_; }
  /// Interval between the velocities before and after `step` [s]: half a step at the start, a mean where dt
  /// changed.
  double force_interval(std::int64_t step) const;
  std::int64_t last_step() const { return last_step_; }  ///< 0: endless
  bool finished(std::int64_t step) const { return last_step_ > 0 && step >= last_step_; }
  /// From `step` on, steps of at most `dt_max`, still ending at the total time.
  void shorten(std::int64_t step, double dt_max);

 private:
  double total_ = 0, dt_ = 0, dt_before_ = 0, base_time_ = 0;
  std::int64_t base_step_ = 0, last_step_ = 0;
};

}  // namespace glisson
