#include <glisson/core/simulation/step_plan.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <glisson/core/base/error.hpp>

namespace glisson {
namespace {

/// Number of equal steps of at most dt in the interval; a ratio that is an integer but for rounding counts as
/// that integer.
std::int64_t steps_in(double interval, double dt) {
  const double ratio = interval / dt;
  constexpr double limit = 1e12;
  if (!(ratio < limit)) {
    std::ostringstream text;
    text << "The run would need " << ratio << " time steps of " << dt
         << " s, which never ends. Use a larger TimeStep, a coarser mesh or mass scaling.";
    throw Error(ErrorKind::input, text.str());
  }
  const double nearest = std::round(ratio);
  const bool whole = std::abs(ratio - nearest) < 1e-6 * std::max(1.0, nearest) && nearest >= 1;
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(whole ? nearest : std::ceil(ratio)));
}

}  // namespace

StepPlan::StepPlan(double total, double dt_wish) : total_(total) {
  last_step_ = steps_in(total, dt_wish);
  dt_ = total / double(last_step_);
  dt_before_ = dt_;
}

StepPlan StepPlan::endless(double dt) {
  StepPlan plan;
  plan.dt_ = plan.dt_before_ = dt;
  return plan;
}

double StepPlan::force_interval(std::int64_t step) const {
  if (step == 0) return 0.5 * dt_;
  return step == base_step_ ? 0.5 * (dt_before_ + dt_) : dt_;
}

void StepPlan::shorten(std::int64_t step, double dt_max) {
  const double now = time(step);
  base_time_ = now;
  base_step_ = step;
  dt_before_ = dt_;
  if (last_step_ == 0) {
    dt_ = dt_max;
    return;
  }
  const std::int64_t remaining = steps_in(total_ - now, dt_max);
  last_step_ = step + remaining;
  dt_ = (total_ - now) / double(remaining);
}

}  // namespace glisson
