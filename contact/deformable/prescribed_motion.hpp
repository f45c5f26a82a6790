// How far nodes whose displacement is prescribed will go, and rigid bodies that push others: known ahead.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glisson/contact/deformable/curve_change.hpp>
#include <glisson/core/model.hpp>

namespace glisson::contact {

class PrescribedMotion {
 public:
  explicit PrescribedMotion(const Model& model) {
    for (const PrescribedDisplacement& its : model.displacements) {
      double most = 0;
      for (const double value : its.values) most = std::max(most, std::abs(value));
      lists_.push_back({std::sqrt(3.0) * most, its.curve});  // on three axes at most
    }
    for (const RigidBody& its : model.bodies)
      lists_.push_back({size(its.displacement) + std::abs(its.radius_change), its.motion});
    for (const RigidSurface& its : model.surfaces)
      if (its.poses.empty()) lists_.push_back({farthest(its), its.motion});
  }
  /// Nothing of it is farther in any of the next `steps` steps of dt than this from where it is at t [m].
  /// Several may move one node. Tables of poses are left out.
  double ahead(double t, double dt, int steps) const {
    double sum = 0;
    for (const auto& [most, curve] : lists_) sum += most * largest_change(curve, t, dt, steps);
    return sum;
  }

 private:
  static double size(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }
  static double farthest(const RigidSurface& surface) {
    double radius = 0;
    for (const Vec3<double>& X : surface.surface.X) radius = std::max(radius, size(X - surface.centre));
    return size(surface.displacement) + radius * size(surface.angles);
  }
  std::vector<std::pair<double, LoadCurve>> lists_;  ///< largest displacement at amplitude 1 [m]
};

}  // namespace glisson::contact
