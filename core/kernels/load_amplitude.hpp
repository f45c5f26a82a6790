// The amplitude of a load curve from plain data, on the host and on a device.
#pragma once

#include <cmath>
#include <numbers>

#include <glisson/core/base/host_device.hpp>
#include <glisson/core/load_curve.hpp>

namespace glisson {

/// An entry of a table, as std::pair has it.
struct CurvePoint {
  double first, second;  ///< time [s], amplitude [-]
};

/// A LoadCurve whose table lies elsewhere. Point: CurvePoint or the pair of LoadCurve::table.
template <class Point>
struct CurveView {
  LoadShape shape;
  bool release_after_end;
  double start, end;
  const Point* table;
  int size;

  GLISSON_HD double table_value(double t) const {
    if (size == 0) return 0;
    if (t <= table[0].first) return table[0].second;
    if (t >= table[size - 1].first) return table[size - 1].second;
    int before = 0, after = size - 1;  // table[before].first <= t < table[after].first
    while (after - before > 1) {
      const int middle = (before + after) / 2;
      (t < table[middle].first ? after : before) = middle;
    }
    const Point &a = table[before], &b = table[after];
    return a.second + (t - a.first) / (b.first - a.first) * (b.second - a.second);
  }

  /// r: relative time, 0 to 1.
  GLISSON_HD double shape_value(double r) const {
    switch (shape) {
      case LoadShape::poly345:
        return r * r * r * (10 + r * (-15 + 6 * r));
      case LoadShape::ramp:
        return r;
      case LoadShape::ramp_hold:
        return 10 * r < 1 ? 10 * r : 1;
      case LoadShape::hilly:
        return r * ::exp(::cos(4 * std::numbers::pi * r) - 1);
      case LoadShape::step:
      case LoadShape::table:
        break;
    }
    return 1;
  }

  GLISSON_HD double operator()(double t) const {
    if (t < start || (release_after_end && t > end)) return 0;
    if (shape == LoadShape::table) return table_value(t);
    const double r = end > start ? (t - start) / (end - start) : 1;
    return shape_value(r < 1 ? r : 1);
  }
};

}  // namespace glisson
