// When a load is about to change suddenly, which is known ahead.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <glisson/contact/deformable/curve_change.hpp>
#include <glisson/core/model.hpp>

namespace glisson::contact {

class LoadJumps {
 public:
  explicit LoadJumps(const Model& model) {
    for (const NodalForce& its : model.forces) add(its.curve);
    for (const Gravity& its : model.gravity) add(its.curve);
    for (const Pressure& its : model.pressures) add(its.curve);
    for (const Traction& its : model.tractions) add(its.curve);
    for (const Springs& its : model.springs) add(its.curve), add(its.target_curve);
  }
  /// Whether one changes within the next `steps` steps of dt after t by more than a tenth of its largest
  /// amplitude. A ramp in fewer than ten times these steps is a jump.
  bool within(double t, double dt, int steps) const {
    return std::any_of(loads_.begin(), loads_.end(), [&](const Load& its) {
      return largest_change(its.curve, t, dt, steps) > 0.1 * its.largest;
    });
  }

 private:
  struct Load {
    LoadCurve curve;
    double largest;  ///< amplitude [-]
  };
  void add(const LoadCurve& curve) {
    double largest = curve.shape == LoadShape::table ? 0 : 1;
    for (const auto& row : curve.table) largest = std::max(largest, std::abs(row.second));
    loads_.push_back({curve, largest});
  }
  std::vector<Load> loads_;
};

}  // namespace glisson::contact
