// The two explicit steppers. Both keep the velocity at half steps; see the note on Newmark.
#pragma once

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// Central difference with mass-proportional damping in velocity form (Johnsen 2016, eq. 4.13-4.14,
/// rearranged):
///   v(n+1/2) = ((1 - h) v(n-1/2) + dt f(n)/m) / (1 + h),   u(n+1) = u(n) + dt v(n+1/2),   h = damping dt
///   / 2.
/// It keeps digits in float that 2 u(n) - u(n-1) loses. Stable for dt < 2 / omega_max.
template <class R>
struct CentralDifference {
  R keep;   ///< (1 - h) / (1 + h)
  R kick;   ///< dt / (1 + h) [s]
  R drift;  ///< dt [s]

  /// dt_force: interval between the neighbouring velocities (dt, dt/2 in the first step, a mean when dt
  /// changes) [s].
  static CentralDifference make(double damping, double dt_force, double dt) {
    const double h = 0.5 * damping * dt_force;
    return {R((1 - h) / (1 + h)), R(dt_force / (1 + h)), R(dt)};
  }
  GLISSON_HD Vec3<R> velocity(const Vec3<R>& v, const Vec3<R>& f, R inverse_mass) const {
    const R g = kick * inverse_mass;
    return {keep * v.x + g * f.x, keep * v.y + g * f.y, keep * v.z + g * f.z};
  }

  /// The same for rows x y z w of nodes, where v.w is the inverse mass: factors for all four lanes, of which
  /// the last lets w pass. Compilers turn equal operations on four lanes into one.
  struct Rows {
    Vec4<R> keep, kick, drift;
    GLISSON_HD Vec4<R> velocity(const Vec4<R>& v, const Vec4<R>& f) const {
      return keep * v + (v.w * kick) * f;
    }
  };
  Rows rows() const {
    return {{keep, keep, keep, R(1)}, {kick, kick, kick, R(0)}, {drift, drift, drift, R(0)}};
  }
};

/// Explicit Newmark, beta = 0, gamma = 1/2 (Johnsen 2016, eq. 4.15). With v(n+1/2) = v(n) + dt/2 a(n) its
/// three lines become
///   a(n) = (f(n)/m - damping v(n-1/2)) / (1 + h),   v(n+1/2) = v(n-1/2) + dt a(n),   u(n+1) = u(n) + dt
///   v(n+1/2):
/// no acceleration has to be stored, and in exact arithmetic the displacements are those of the central
/// difference.
template <class R>
struct Newmark {
  R damping;  ///< [1/s]
  R kick;     ///< dt / (1 + h) [s]
  R drift;    ///< dt [s]

  static Newmark make(double damping, double dt_force, double dt) {
    return {R(damping), R(dt_force / (1 + 0.5 * damping * dt_force)), R(dt)};
  }
  GLISSON_HD Vec3<R> velocity(const Vec3<R>& v, const Vec3<R>& f, R inverse_mass) const {
    return {v.x + kick * (f.x * inverse_mass - damping * v.x),
            v.y + kick * (f.y * inverse_mass - damping * v.y),
            v.z + kick * (f.z * inverse_mass - damping * v.z)};
  }

  /// As in CentralDifference.
  struct Rows {
    R damping;
    Vec4<R> kick, drift;
    GLISSON_HD Vec4<R> velocity(const Vec4<R>& v, const Vec4<R>& f) const {
      return v + kick * (v.w * f - damping * v);
    }
  };
  Rows rows() const { return {damping, {kick, kick, kick, R(0)}, {drift, drift, drift, R(0)}}; }
};

}  // namespace glisson
