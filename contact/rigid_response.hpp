// How something rigid moves a node that comes too near: the explicit Lagrange multiplier of Johnsen 2016, eq.
// 5.13, with all of the gap on the node (beta_s = 1), the gap rate-proportional force of eq. 5.19-5.22 in
// front of it, and Coulomb friction by eq. 5.24-5.25. A penalty is a share of that multiplier:
// deformable/resolve_touches.hpp says why it keeps the stable step.
#pragma once

#include <glisson/contact/analytic/shapes.hpp>

namespace glisson::contact {

template <class R>
struct RigidResponse {
  R friction = R(0);  ///< Coulomb's coefficient [-]
  R share = R(1);     ///< of the depth that the step takes back: 1, less of penalties [-]
  R close = R(0);     ///< epsilon_r: gap below which an approach is slowed [m]

  /// By how much the contact moves the node within the step [m]; the force is that over the node's mobility.
  /// p: at the end of the step, depth -gap in front; path: motion relative to the body in the step [m]
  GLISSON_HD Vec3<R> operator()(const Penetration<R>& p, const Vec3<R>& path) const {
    const R along = dot(path, p.out), push = push_of(p.depth, along);
    if (!(push > R(0))) return {};
    const Vec3<R> aside = path - along * p.out;
    const R length = square_root(dot(aside, aside)), most = friction * push;
    const R stopped = length > most ? most / length : (friction > R(0) ? R(1) : R(0));
    return push * p.out - stopped * aside;
  }

 private:
  /// In front of the surface the approach keeps the share gap / close of its speed, as between deformable
  /// bodies.
  GLISSON_HD R push_of(R depth, R along) const {
    if (depth > R(0)) return share * depth;
    const R near = close + depth;
    return near > R(0) && along < R(0) ? R(0) - (near / close) * along : R(0);
  }
};

}  // namespace glisson::contact
