// A model's rigid body in double: checked, with unit axes, and where it is at a time.
#pragma once

#include <vector>

#include <glisson/contact/analytic/shapes.hpp>
#include <glisson/core/model.hpp>

namespace glisson::contact {

class RigidMotion {
 public:
  /// Throws Error(input) for a body without extent.
  explicit RigidMotion(const RigidBody& body);

  const RigidBody& body() const { return body_; }
  /// The point that shapes are relative to, at rest [m].
  const Vec3<double>& reference() const {
    return body_.shape == RigidShape::plate ? body_.corners[0] : body_.origin;
  }
  /// How far the reference point has moved at time t [m].
  Vec3<double> shift(double t) const { return body_.motion(t) * body_.displacement; }
  double radius(double t) const { return body_.radius + body_.motion(t) * body_.radius_change; }

  Plate<double> plate() const;
  Cylinder<double> cylinder(double t) const { return {body_.axis, side_, radius(t), body_.length}; }

 private:
  RigidBody body_;
  Vec3<double> side_;  ///< unit, normal to the axis
};

/// Nodes of the user's numbering that a body may touch: those listed, or all nodes of the outer surface.
std::vector<int> candidate_nodes(const std::vector<int>& listed, const Mesh& mesh);

template <class R>
Vec3<R> narrowed(const Vec3<double>& a) {
  return {R(a.x), R(a.y), R(a.z)};
}
/// Shapes of a body at time t in the number type of a run.
template <class R>
void shape_at(const RigidMotion& motion, double, Plate<R>& out) {
  const Plate<double> p = motion.plate();
  out = {narrowed<R>(p.normal), narrowed<R>(p.ab), narrowed<R>(p.ac),
         R(p.ab_squared),       R(p.ac_squared),   R(p.reach)};
}
template <class R>
void shape_at(const RigidMotion& motion, double t, Cylinder<R>& out) {
  const Cylinder<double> c = motion.cylinder(t);
  out = {narrowed<R>(c.axis), narrowed<R>(c.side), R(c.radius), R(c.length)};
}
template <class R>
void shape_at(const RigidMotion& motion, double t, Probe<R>& out) {
  const Cylinder<double> c = motion.cylinder(t);
  out = {narrowed<R>(c.axis), narrowed<R>(c.side), R(c.radius), R(c.length)};
}

}  // namespace glisson::contact
