#include <glisson/core/load_curve.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glisson {
namespace {

double table_value(const std::vector<std::pair<double, double>>& table, double t) {
  if (table.empty()) return 0;
  if (t <= table.front().first) return table.front().second;
  if (t >= table.back().first) return table.back().second;
  const auto after = std::upper_bound(table.begin(), table.end(), t,
                                      [](double time, const auto& entry) { return time < entry.first; });
  const auto before = after - 1;
  const double share = (t - before->first) / (after->first - before->first);
  return before->second + share * (after->second - before->second);
}

double shape_value(LoadShape shape, double r) {
  switch (shape) {
    case LoadShape::poly345:
      return r * r * r * (10 + r * (-15 + 6 * r));
    case LoadShape::ramp:
      return r;
    case LoadShape::ramp_hold:
      return std::min(10 * r, 1.0);
    case LoadShape::hilly:
      return r * std::exp(std::cos(4 * std::numbers::pi * r) - 1);
    case LoadShape::step:
    case LoadShape::table:
      break;
  }
  return 1;
}

}  // namespace

double LoadCurve::operator()(double t) const {
  if (t < start || (release_after_end && t > end)) return 0;
  if (shape == LoadShape::table) return table_value(table, t);
  const double r = end > start ? std::min((t - start) / (end - start), 1.0) : 1.0;
  return shape_value(shape, r);
}

}  // namespace glisson
