// Loop bodies of the constraints: what they demand of a vector at a node, setting u and v, and the reactions.
#pragma once

#include <glisson/core/constraints/constraint_list.hpp>
#include <glisson/core/loads/list_forces.hpp>

namespace glisson {

/// One number per load curve, by value when there are few (the usual case needs no copy to a device).
struct CurveValues {
  static constexpr int by_value = 16;
  double few[by_value] = {};
  const double* many = nullptr;  ///< [curve_count], when there are more
  GLISSON_HD double operator[](int k) const { return many ? many[k] : few[k]; }
};

/// The list on the backend.
struct ConstraintView {
  const int* nodes;
  const unsigned* axes;
  const int* value_begin;
  const PrescribedValue* values;
  const int* plane_begin;
  const PlaneProjection* planes;

  /// a with the constraints of entry i: prescribed axes get sum amplitude value, in double, planes keep only
  /// the tangent.
  template <class R>
  GLISSON_HD Vec3<R> constrain(int i, const Vec3<R>& a, const CurveValues& amplitude) const {
    const unsigned constrained = axes[i];
    double sum[3] = {0, 0, 0};
    for (int k = value_begin[i]; k < value_begin[i + 1]; ++k)
      for (int axis = 0; axis < 3; ++axis)
        if (values[k].axes & (1u << axis)) sum[axis] += amplitude[values[k].curve] * values[k].value;
    Vec3<R> b{constrained & 1u ? R(sum[0]) : a.x, constrained & 2u ? R(sum[1]) : a.y,
              constrained & 4u ? R(sum[2]) : a.z};
    for (int k = plane_begin[i]; k < plane_begin[i + 1]; ++k) {
      const Vec3<double> n = planes[k].normal, d = planes[k].direction;
      const double out = n.x * double(b.x) + n.y * double(b.y) + n.z * double(b.z);
      b = {R(double(b.x) - out * d.x), R(double(b.y) - out * d.y), R(double(b.z) - out * d.z)};
    }
    return b;
  }
  /// u and v of a node with the constraints of entry i.
  template <class R>
  GLISSON_HD void constrain(int i, Vec4<R>& u, Vec4<R>& v, const CurveValues& displacement,
                            const CurveValues& velocity) const {
    const Vec3<R> p = constrain(i, xyz(u), displacement), w = constrain(i, xyz(v), velocity);
    u = {p.x, p.y, p.z, u.w};
    v = {w.x, w.y, w.z, v.w};
  }
};

/// u(n+1) and v(n+1/2) of constrained nodes, exactly.
template <class R>
struct ConstrainNodes {
  static constexpr int cost = 10;
  ConstraintView list;
  Vec4<R>*u, *v;  ///< [node_count]
  int node_count;
  CurveValues displacement, velocity;

  GLISSON_HD int node(int i) const { return list.nodes[i]; }
  GLISSON_HD void operator()(int i) const {
    const int n = list.nodes[i];
    list.constrain(i, u[n], v[n], displacement, velocity);
  }
};

/// a <- its part in the free directions: residual forces without reactions, velocities that the constraints
/// allow; with amplitudes, displacements as the constraints demand them.
template <class R>
struct ProjectNodes {
  ConstraintView list;
  Vec4<R>* a;  ///< [node_count]
  CurveValues amplitude{};
  GLISSON_HD void operator()(int i) const {
    const int n = list.nodes[i];
    const Vec3<R> b = list.constrain(i, xyz(a[n]), amplitude);
    a[n] = {b.x, b.y, b.z, a[n].w};
  }
};

/// Reaction that makes the stepper itself arrive at the constrained velocity: r = (v_c - v_free) / (kick /
/// m), where v_free is what the stepper would give without it. A massless node just has its force cancelled.
template <class R, class Stepper>
struct Reaction : LastForces<R> {
  ConstraintView list;
  const Vec4<R>*v, *f;  ///< [node_count]
  CurveValues velocity;
  Stepper stepper;

  GLISSON_HD Vec3<R> force(int i, int n) const { return of(i, v[n], f[n]); }
  GLISSON_HD Vec3<R> of(int i, const Vec4<R>& v_old, const Vec4<R>& f_all) const {
    const R inverse_mass = v_old.w;
    if (!(inverse_mass > R(0))) return R(-1) * xyz(f_all);
    const Vec3<R> v_free = stepper.velocity(xyz(v_old), xyz(f_all), inverse_mass);
    const Vec3<R> change = list.constrain(i, v_free, velocity) - v_free;
    return (R(1) / (stepper.kick * inverse_mass)) * change;
  }
};

}  // namespace glisson
