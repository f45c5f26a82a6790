// Contact of nodes with an analytic rigid body, by the force that ends each step on its surface.
#pragma once

#include <glisson/contact/analytic/rigid_motion.hpp>
#include <glisson/contact/list_contact.hpp>
#include <glisson/contact/rigid_response.hpp>

namespace glisson::contact {

/// With u(t + dt) = u_predicted + advance_per_force f / m, the force f = m depth out / advance_per_force ends
/// the step on the surface of the body at t + dt (the kinematic correction of Johnsen 2016, section 4.5.8.1,
/// written as a force); friction is that of rigid surfaces.
template <class R, class Shape>
struct ContactForce : LastForces<R> {
  Shape shape;
  Vec3<R> shift;     ///< of the body at the end of the step [m]
  Vec3<R> shifted;   ///< during the step [m]
  const Vec4<R>* X;  ///< rest position from the body's reference point, w: gap to keep [m]     [entry_count]
  const Vec4<R>* from;  ///< displacement at the beginning [m] [node_count]
  const Vec4<R>* to;  ///< and, as predicted, at the end [m]                                     [node_count]
  const Vec4<R>* v;   ///< w: 1/mass [1/kg]                                                      [node_count]
  R advance_per_force;  ///< [s^2]
  RigidResponse<R> response;
  AllowedDepth<R> allowed;

  GLISSON_HD Penetration<R> penetration(int i, int n) const {
    Penetration<R> p = shape(xyz(X[i]) + xyz(to[n]) - shift, X[i].w);
    p.depth -= allowed(i);
    return p;
  }
  GLISSON_HD Vec3<R> force(int i, int n) const {
    const Penetration<R> p = penetration(i, n);
    const R mobility = advance_per_force * v[n].w;
    if (!(p.depth > R(0)) || !(mobility > R(0))) return {};
    return (R(1) / mobility) * response(p, xyz(to[n]) - xyz(from[n]) - shifted);
  }
};

template <Backend B, class R, class Shape>
class RigidContact final : public ListContact<B, R> {
 public:
  /// gaps: that the nodes of the mesh keep [m]
  RigidContact(B& backend, RigidMotion motion, const std::vector<int>& nodes, const std::vector<double>& gaps,
               StartRelease<B, R> start, const Mesh& mesh, const Numbering& numbering)
      : ListContact<B, R>(backend, motion.body().name,
                          ListContact<B, R>::entries_of(nodes, motion.reference(), mesh, numbering, gaps),
                          std::move(start)),
        motion_(std::move(motion)) {}

  void add_forces(const StepView<R>& step) override {
    if (this->count() == 0) return;
    const double t = this->end_of(step);
    ContactForce<R, Shape> next = rule(step, t, step.u_predicted);
    next.allowed = this->allowed_depth(t);
    this->touch(step, rule(step, step.t, step.u), next);
  }

 private:
  ContactForce<R, Shape> rule(const StepView<R>& step, double t, const Vec4<R>* to) const {
    const Vec3<double> begin = motion_.shift(step.t), end = motion_.shift(t);
    ContactForce<R, Shape> result{{this->last()},
                                  {},
                                  narrowed<R>(end),
                                  narrowed<R>(end - begin),
                                  this->X(),
                                  step.u,
                                  to,
                                  step.v,
                                  step.advance_per_force,
                                  {R(motion_.body().friction)},
                                  {}};
    shape_at(motion_, t, result.shape);
    return result;
  }

  RigidMotion motion_;
};

}  // namespace glisson::contact
