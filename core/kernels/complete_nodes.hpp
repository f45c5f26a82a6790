// The end of a step as one sweep over the nodes, for devices: there each launch costs as much as the work on
// a small mesh. What patches left of a force, the reaction of a constraint with its work, the update and the
// constraint itself, in the order in which they are separate loops elsewhere.
#pragma once

#include <glisson/core/constraints/constrain_nodes.hpp>
#include <glisson/core/kernels/advance_nodes.hpp>
#include <glisson/core/kernels/shared_forces.hpp>

namespace glisson {

/// The constraints of a run, found from the node.
template <class R, class Stepper>
struct NodeConstraints {
  const int* entry = nullptr;  ///< of the list, -1: free [node_count]; nullptr: there are none
  Reaction<R, Stepper> reaction{};
  CurveValues displacement{};
  double half_dt = 0;      ///< half of the step that ended now, 0 if none did [s]
  R share = R(1);          ///< share of this step's force that the next step counts [-]
  double* work = nullptr;  ///< since the start [J]  [ceil(node_count / node_energy_chunk)]

  GLISSON_HD int entry_of(int n) const { return entry ? entry[n] : -1; }
  /// f with the reaction of entry i; adds twice its work per half_dt to `sum`.
  GLISSON_HD Vec4<R> react(int i, const Vec4<R>& v, const Vec4<R>& f, double& sum) const {
    const Vec3<R> before = reaction.before(i, 0), g = reaction.of(i, v, f);
    sum += twice_power(before, g, v);
    reaction.remember(i, share * g);
    return {f.x + g.x, f.y + g.y, f.z + g.z, f.w};
  }
  GLISSON_HD void constrain(int i, Vec4<R>& u, Vec4<R>& v) const {
    reaction.list.constrain(i, u, v, displacement, reaction.velocity);
  }
};

/// Takes the place of AdvanceNodes in the bodies that keep energies.
template <class R, class Stepper>
struct CompleteNodes {
  using Tally = double;  ///< see NodeConstraints::react
  AdvanceNodes<R, Stepper> nodes;
  SharedForces<R> shared;
  NodeConstraints<R, Stepper> constraints;

  GLISSON_HD const Vec4<R>& velocity(int n) const { return nodes.v[n]; }
  /// Returns v as the stepper gives it from all forces, before the constraint sets it exactly.
  GLISSON_HD Vec4<R> advance(int n, const Vec4<R>& v_old, Tally& tally) const {
    const int i = constraints.entry_of(n);
    const Vec4<R> u_old = nodes.u[n];
    Vec4<R> f = shared.add_to_node(n, nodes.f[n]);
    if (i >= 0) f = constraints.react(i, v_old, f, tally);
    const Vec4<R> v_new = nodes.stepper.velocity(v_old, f);
    Vec4<R> u_set = u_old + nodes.stepper.drift * v_new, v_set = v_new;
    if (i >= 0) constraints.constrain(i, u_set, v_set);
    nodes.v[n] = v_set;
    nodes.u[n] = u_set;
    nodes.f[n] = {};
    return v_new;
  }
  GLISSON_HD static void join(Tally& a, const Tally& b) { a += b; }
  GLISSON_HD void leave(int c, const Tally& tally) const {
    if (constraints.entry && constraints.half_dt > 0) constraints.work[c] += constraints.half_dt * tally;
  }
};

/// The sweep without damping and between two energy accounts: only the work of the reactions goes on.
template <class R, class Stepper>
struct CompleteNodesOnly {
  static constexpr int chunk = node_energy_chunk;
  using Sum = double;
  CompleteNodes<R, Stepper> nodes;
  int node_count;

  GLISSON_HD int entry_count() const { return node_count; }
  GLISSON_HD void add(int n, Sum& sum) const { nodes.advance(n, nodes.velocity(n), sum); }
  GLISSON_HD static void join(Sum& a, const Sum& b) { a += b; }
  GLISSON_HD void leave(int c, const Sum& sum) const { nodes.leave(c, sum); }
  GLISSON_HD void operator()(int c) const { run_chunk(*this, c); }
};

}  // namespace glisson
