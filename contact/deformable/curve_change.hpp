// What an amplitude does in the next steps.
#pragma once

#include <algorithm>
#include <cmath>

#include <glisson/core/load_curve.hpp>

namespace glisson::contact {

/// Largest change of the amplitude from t to any of the next `steps` steps of dt [-]
inline double largest_change(const LoadCurve& curve, double t, double dt, int steps) {
  const double now = curve(t);
  double change = 0;
  for (int k = 1; k <= steps; ++k) change = std::max(change, std::abs(curve(t + k * dt) - now));
  return change;
}

}  // namespace glisson::contact
