// How a load or a boundary value grows over time.
#pragma once

#include <utility>
#include <vector>

namespace glisson {

/// The shapes of the NiftySim format and a table; each maps relative time 0..1 to an amplitude.
enum class LoadShape { poly345, ramp, ramp_hold, step, hilly, table };

/// Amplitude [-] of a load at time t [s]. Relative time runs from 0 at `start` to 1 at `end`; before `start`
/// the amplitude is 0, after `end` the value at `end` is held (or 0 when `release_after_end`).
///   poly345: 10 r^3 - 15 r^4 + 6 r^5;  ramp: r;  ramp_hold: min(10 r, 1);  step: 1;
///   hilly: r exp(cos(4 pi r) - 1);     table: linear between (time [s], value), constant outside.
struct LoadCurve {
  LoadShape shape = LoadShape::ramp;
  double start = 0;  ///< [s]
  double end = 1;    ///< [s]
  bool release_after_end = false;
  std::vector<std::pair<double, double>> table;  ///< (time [s], value [-]), times increasing

  double operator()(double t) const;
};

}  // namespace glisson
