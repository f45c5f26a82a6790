// The node update and its prediction. Every node is treated as free; constraints correct their lists
// afterwards.
#pragma once

#include <cmath>

#include <glisson/core/chunk_sums.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

template <class R>
GLISSON_HD Vec3<R> vector_part(const Vec4<R>& a) {
  return {a.x, a.y, a.z};
}

/// u, v <- next step; f is consumed and left at zero for the next sum.
template <class R, class Stepper>
struct AdvanceNodes {
  Vec4<R>* u;  ///< displacement [m]                [node_count]
  Vec4<R>* v;  ///< velocity [m/s], w: 1/mass [1/kg] [node_count]
  Vec4<R>* f;  ///< force [N], w: 0                 [node_count]
  typename Stepper::Rows stepper;
  int node_count;

  /// What a sweep sums besides energies: nothing here, see CompleteNodes.
  struct Tally {};
  GLISSON_HD static void join(Tally&, const Tally&) {}
  GLISSON_HD void leave(int, const Tally&) const {}

  GLISSON_HD int node(int n) const { return n; }
  GLISSON_HD const Vec4<R>& velocity(int n) const { return v[n]; }
  GLISSON_HD void operator()(int n) const { advance(n, v[n]); }
  GLISSON_HD Vec4<R> advance(int n, const Vec4<R>& v_old, Tally&) const { return advance(n, v_old); }
  /// Returns the new v. All loads come before the stores: the arrays might overlap for all that a compiler
  /// knows.
  GLISSON_HD Vec4<R> advance(int n, const Vec4<R>& v_old) const {
    const Vec4<R> v_new = stepper.velocity(v_old, f[n]), u_new = u[n] + stepper.drift * v_new;
    v[n] = v_new;
    u[n] = u_new;
    f[n] = {};
    return v_new;
  }
};

/// AdvanceNodes with compensated summation of u (Kahan 1965): a relaxation ends with steps that are smaller
/// than the rounding of u in float; without the carry they would be lost and the run would stall at a force
/// residual of 1e-4.
template <class R, class Stepper>
struct AdvanceNodesCompensated {
  AdvanceNodes<R, Stepper> nodes;
  Vec4<R>* carry;  ///< what u still owes [m], w: 0  [node_count]
  int node_count = nodes.node_count;

  GLISSON_HD int node(int n) const { return n; }
  GLISSON_HD void operator()(int n) const {
    const Vec4<R> before = nodes.u[n], owed = carry[n];
    const Vec4<R> v_new = nodes.stepper.velocity(nodes.v[n], nodes.f[n]);
    const Vec4<R> add = nodes.stepper.drift * v_new - owed, sum = before + add;
    carry[n] = (sum - before) - add;
    nodes.v[n] = v_new;
    nodes.u[n] = sum;
    nodes.f[n] = {};
  }
};

/// u_predicted = u(t + dt) under the forces summed so far.
template <class R, class Stepper>
struct PredictNodes {
  const Vec4<R>*u, *v, *f;
  Vec4<R>* u_predicted;  ///< [m]  [node_count]
  Stepper stepper;
  int node_count;

  GLISSON_HD int node(int n) const { return n; }
  GLISSON_HD void operator()(int n) const {
    const Vec3<R> w = stepper.velocity(vector_part(v[n]), vector_part(f[n]), v[n].w);
    const R dt = stepper.drift;
    u_predicted[n] = {u[n].x + dt * w.x, u[n].y + dt * w.y, u[n].z + dt * w.z, u[n].w};
  }
};

/// The same for listed nodes.
template <class R, class Stepper>
struct PredictListed {
  static constexpr int cost = 3;
  PredictNodes<R, Stepper> predict;
  const int* nodes;  ///< ascending [count]
  int node_count = predict.node_count;

  GLISSON_HD int node(int i) const { return nodes[i]; }
  GLISSON_HD void operator()(int i) const { predict(nodes[i]); }
};

constexpr int node_energy_chunk = 64;  ///< nodes

/// Energy terms of one chunk of nodes around a step.
struct NodeEnergies {
  double kinetic = 0;        ///< of this step: sum m v(n-1/2).v(n+1/2) / 2 [J]
  double damping = 0;        ///< dissipated since the start, up to t(n) + dt/2 [J]
  double damping_ahead = 0;  ///< the part of it that belongs to t(n) .. t(n) + dt/2 [J]
};

/// AdvanceNodes over chunks of nodes, with the energies of the step. With KE(n) = sum m v(n-1/2).v(n+1/2) / 2
/// the change of KE over a step is exactly (F(n) + F(n+1)) / 2 . (u(n+1) - u(n)), F all forces with damping:
/// the balance of a linear system closes to round-off at any stable dt.
template <class R, class Stepper, class Nodes = AdvanceNodes<R, Stepper>>
struct AdvanceNodesMonitored {
  static constexpr int chunk = node_energy_chunk, cost = 4 * chunk;
  Nodes nodes;
  NodeEnergies* energies;  ///< [ceil(node_count / chunk)]
  int node_count;
  double damping;   ///< [1/s]
  double dt;        ///< [s]
  bool first_step;  ///< nothing lies before t = 0

  struct Sum {
    double kinetic = 0, before = 0, ahead = 0;
    typename Nodes::Tally tally{};
  };
  GLISSON_HD int node(int c) const { return c * chunk; }
  GLISSON_HD int entry_count() const { return node_count; }
  GLISSON_HD void add(int n, Sum& sum) const {
    const Vec4<R> a = nodes.velocity(n), b = nodes.advance(n, a, sum.tally);
    if (!(a.w > R(0))) return;  // massless nodes do not move
    const double m = 1 / double(a.w);
    const double ab = double(a.x * b.x + a.y * b.y + a.z * b.z),
                 aa = double(a.x * a.x + a.y * a.y + a.z * a.z),
                 bb = double(b.x * b.x + b.y * b.y + b.z * b.z);
    sum.kinetic += m * ab;
    sum.before += m * (aa + ab);
    sum.ahead += m * (ab + bb);
  }
  GLISSON_HD static void join(Sum& a, const Sum& b) {
    a.kinetic += b.kinetic, a.before += b.before, a.ahead += b.ahead;
    Nodes::join(a.tally, b.tally);
  }
  GLISSON_HD void leave(int c, const Sum& sum) const {
    NodeEnergies& e = energies[c];
    const double share =
        0.25 * damping * dt;  // damping force m alpha (a + b)/2 on the half paths dt a/2 and dt b/2
    e.kinetic = 0.5 * sum.kinetic;
    e.damping += share * ((first_step ? 0 : sum.before) + sum.ahead);
    e.damping_ahead = share * sum.ahead;
    nodes.leave(c, sum.tally);
  }
  GLISSON_HD void operator()(int c) const { run_chunk(*this, c); }
};

/// The same between two accounts: only the dissipation, m |a + b|^2 with a = v(n-1/2), b = v(n+1/2), goes on.
/// The sum over a chunk is in R, lane by lane: a third of the time.
template <class R, class Stepper, class Nodes = AdvanceNodes<R, Stepper>>
struct AdvanceNodesDamped {
  static constexpr int chunk = node_energy_chunk, cost = 2 * chunk;
  Nodes nodes;
  NodeEnergies* energies;  ///< [ceil(node_count / chunk)]
  int node_count;
  double damping;  ///< [1/s]
  double dt;       ///< [s]

  struct Sum {
    Vec4<R> squares{};
    typename Nodes::Tally tally{};
  };
  GLISSON_HD int node(int c) const { return c * chunk; }
  GLISSON_HD int entry_count() const { return node_count; }
  GLISSON_HD void add(int n, Sum& sum) const {
    const Vec4<R> a = nodes.velocity(n), both = a + nodes.advance(n, a, sum.tally);
    const R mass = a.w > R(0) ? R(1) / a.w : R(0);
    sum.squares = sum.squares + mass * (both * both);
  }
  GLISSON_HD static void join(Sum& a, const Sum& b) {
    a.squares = a.squares + b.squares;
    Nodes::join(a.tally, b.tally);
  }
  GLISSON_HD void leave(int c, const Sum& sum) const {
    const Vec4<R>& s = sum.squares;
    energies[c].damping += 0.25 * damping * dt * (double(s.x) + double(s.y) + double(s.z));
    nodes.leave(c, sum.tally);
  }
  GLISSON_HD void operator()(int c) const { run_chunk(*this, c); }
};

template <class R>
struct ZeroForces {
  Vec4<R>* f;
  GLISSON_HD void operator()(int n) const { f[n] = {}; }
};

}  // namespace glisson
