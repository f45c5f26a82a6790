// Forces of all contacts of a step at once: loop bodies of a projected Jacobi iteration.
//
// Johnsen 2016 computes each contact's force as if it were alone and then keeps, at every node, the largest
// projection on the mean direction (algorithm 5.3). That changes the two sides of a contact by different
// factors, so that momentum is not conserved. Here every contact keeps one multiplier for both sides, and the
// multipliers are found together: lambda <- max(0, lambda + gain (target - gap(lambda))), with the gain
// 1 / sum_n |w_n| / m_n sum_c' |w_c'n| of all contacts c' at the nodes n. That row sum bounds the matrix of
// the constraints, so the iteration converges for every mesh (Gershgorin), and a single contact gets its
// whole force at once. Friction follows in the same way, bounded by mu lambda (eq. 5.24-5.25).
//
// Penalty response: lambda = s gain max(0, -gap(0)) once, with the share s in (0, 1]; friction iterates below
// mu lambda. It leaves the stable step as it is: with P = M^-1 sum gain w w^T, whose eigenvalues lie in [0,
// 1] by the same bound, a step of the linearised contact is
//   x(n+1) = (1 - s P) (2 x(n) - x(n-1) - dt^2 M^-1 K x(n)).
// 1 - s P is symmetric in the masses, between 1 - s and 1. So each mode has m z^2 + (a - 2) z + 1 = 0 with m
// >= 1 from its inverse and a = dt^2 <K> / <M>, and |z| <= 1 as long as a <= 4, which is the step that is
// stable without contact. That needs the force from the gap at the end of the step; from that at its
// beginning, s would have to stay below 4 - a. The price is damping of the approach, a share sqrt(s) / 2 of
// the critical one for a mass that hits something rigid.
#pragma once

#include <glisson/contact/deformable/surface_view.hpp>
#include <glisson/contact/deformable/touch.hpp>
#include <glisson/contact/geometry/row.hpp>

namespace glisson::contact {

/// Nodes of the present candidates and the slots that may push each. What the iterations go through again and
/// again lies by entry, in the order of the entries: threads then share no cache line but at their borders.
template <class R>
struct PushedNodes {
  const int* nodes;           ///< of the surface                          [count]
  const int* entry;           ///< the other way round                     [surface nodes]
  const int* incident_begin;  ///<                                         [count + 1]
  const int* incident;        ///< slots
  int* pushing;               ///< slots that do push                      [incident]
  R* weight;                  ///< of the node in them [-]                 [incident]
  int* pushing_count;         ///<                                         [count]
  R* share;                   ///< motion by a unit force in each contact [m/N]  [count]
  Vec4<R>* mobility;          ///< motion by a unit force along each axis [m/N]  [count]
  Vec4<R>* guess;             ///< of SurfaceView [m]                            [count]
  Vec4<R>* moved;             ///< by contact in this step less what it was in the last one [m]  [count]
  Vec4<R>* push;              ///< on the side of weight > 0 of each contact [N]                 [slots]
  R* deepest;                 ///< deepest it was behind a facet since the start [m]  [surface nodes]
  Vec4<R>* force;             ///< [N]                                               [surface nodes]
};

/// Which contacts push node i, and its share in what they move. Each node looks at all slots that may push
/// it: many times more than do, but devices have a thread for every node.
template <class R>
struct ListPushing {
  static constexpr int cost = 30;
  PushedNodes<R> nodes;
  const Touch<R>* touches;
  SurfaceView<R> surface;

  GLISSON_HD void operator()(int i) const {
    begin(i);
    for (int j = nodes.incident_begin[i]; j < nodes.incident_begin[i + 1]; ++j) {
      const Touch<R>& t = touches[nodes.incident[j]];
      for (int m = 0; t.used && m < most_touch_nodes; ++m)
        if (t.node[m] == nodes.nodes[i]) add(i, nodes.incident[j], m);
    }
    nodes.share[i] *= surface.to[nodes.nodes[i]].w;
  }

 protected:
  GLISSON_HD void begin(int i) const {
    const int k = nodes.nodes[i];
    const Vec3<R> guess = xyz(surface.guess[k]), mobility = surface.moved_by(k, {R(1), R(1), R(1), R(0)});
    nodes.guess[i] = {guess.x, guess.y, guess.z, R(0)};
    nodes.mobility[i] = {mobility.x, mobility.y, mobility.z, R(0)};
    nodes.moved[i] = {-guess.x, -guess.y, -guess.z, R(0)};
    nodes.force[k] = {};
    nodes.pushing_count[i] = 0;
    nodes.share[i] = R(0);
  }
  /// Node m of the touch in a slot is entry i.
  GLISSON_HD void add(int i, int slot, int m) const {
    const Touch<R>& t = touches[slot];
    const int place = nodes.incident_begin[i] + nodes.pushing_count[i]++;
    nodes.pushing[place] = slot;
    nodes.weight[place] = t.weight[m];
    nodes.share[i] += t.weight[m] < R(0) ? -t.weight[m] : t.weight[m];
    R& deepest = nodes.deepest[nodes.nodes[i]];
    if (-t.before > deepest) deepest = -t.before;
  }
};

/// The same on a host, where few threads each go through all touches and list those of their own nodes.
template <class R>
struct DealTouches : ListPushing<R> {
  static constexpr int cost = 10000;
  int part_count, entry_count, slot_count;

  void operator()(int part) const {
    const auto cut = [&](int p) { return static_cast<int>(1LL * entry_count * p / part_count); };
    const int first = cut(part), end = cut(part + 1);
    for (int i = first; i < end; ++i) this->begin(i);
    for (int c = 0; c < slot_count; ++c) {
      const Touch<R>& t = this->touches[c];
      for (int m = 0; t.used && m < most_touch_nodes && t.node[m] >= 0; ++m) {
        const int i = this->nodes.entry[t.node[m]];
        if (i >= first && i < end) this->add(i, c, m);
      }
    }
    for (int i = first; i < end; ++i) this->nodes.share[i] *= this->surface.to[this->nodes.nodes[i]].w;
  }
};

/// Also leaves the touch with entries in place of nodes, as the iterations need them.
template <class R>
struct SetGain {
  static constexpr int cost = 10;
  Touch<R>* touches;
  const int* entry;
  const R* share;

  GLISSON_HD void operator()(int c) const {
    Touch<R>& t = touches[c];
    if (!t.used) return;
    R sum = R(0);
    for (int m = 0; m < most_touch_nodes && t.node[m] >= 0; ++m) {
      t.node[m] = entry[t.node[m]];
      sum += (t.weight[m] < R(0) ? -t.weight[m] : t.weight[m]) * share[t.node[m]];
    }
    t.gain = sum > R(0) ? R(1) / sum : R(0);  // 0: both sides are held
  }
};

template <class R>
struct PushTouches {
  static constexpr int cost = 4;
  Touch<R>* touches;
  const Vec4<R>* moved;
  Vec4<R>* push;
  R ahead;  ///< share of the last change that is added; 0 in the last iteration
  R share;  ///< of the gain along the normal: 1, or of penalties once s, then 0

  GLISSON_HD void operator()(int c) const {
    Touch<R>& t = touches[c];
    if (!t.used) return;
    Row<R> sum{};
    for (int m = 0; m < most_touch_nodes && t.node[m] >= 0; ++m)
      sum = sum + t.weight[m] * Row<R>::of(moved[t.node[m]]);
    const Vec3<R> d = xyz(sum.value());
    const R along = dot(d, t.normal);
    const R pressing = positive(t.pressing_ahead + share * t.gain * (t.target - t.gap - along));
    t.pressing_ahead = positive(pressing + ahead * (pressing - t.pressing));
    t.pressing = pressing;
    Vec3<R> force = t.pressing_ahead * t.normal;
    if (t.friction > R(0)) {
      const Vec3<R> rubbing =
          bounded(t.rubbing_ahead - t.gain * (t.slip + d - along * t.normal), t.friction * t.pressing);
      t.rubbing_ahead = bounded(rubbing + ahead * (rubbing - t.rubbing), t.friction * t.pressing_ahead);
      t.rubbing = rubbing;
      force = force + t.rubbing_ahead;
    }
    push[c] = {force.x, force.y, force.z, R(0)};
  }

 private:
  GLISSON_HD static R positive(R a) { return a > R(0) ? a : R(0); }
  GLISSON_HD static Vec3<R> bounded(const Vec3<R>& a, R most) {
    const R squared = dot(a, a);
    return squared > most * most ? (most / square_root(squared)) * a : a;
  }
};

/// Sums the forces on node i; its motion is told relative to that of the last step's force, at which the
/// gaps were measured.
template <class R>
struct MovePushed {
  static constexpr int cost = 4;
  PushedNodes<R> nodes;
  bool last;  ///< iteration: leaves the force

  GLISSON_HD void operator()(int i) const {
    const int first = nodes.incident_begin[i], count = nodes.pushing_count[i];
    if (count == 0) return;  // as ListPushing left it
    Row<R> f{};
    for (int j = first; j < first + count; ++j)
      f = f + nodes.weight[j] * Row<R>::of(nodes.push[nodes.pushing[j]]);
    nodes.moved[i] = (Row<R>::of(nodes.mobility[i]) * f - Row<R>::of(nodes.guess[i])).value();
    if (last) nodes.force[nodes.nodes[i]] = f.value();
  }
};

/// What ListWork adds: the forces found above.
template <class R>
struct FoundForce {
  const int* list;       ///< surface nodes of the entries
  const Vec4<R>* found;  ///< [N]  [surface nodes]
  Vec4<R>* last;         ///< [N]  [surface nodes]

  GLISSON_HD Vec3<R> force(int i, int) const { return xyz(found[list[i]]); }
  GLISSON_HD Vec3<R> before(int i, int) const { return xyz(last[list[i]]); }
  GLISSON_HD void remember(int i, const Vec3<R>& g) const { last[list[i]] = {g.x, g.y, g.z, R(0)}; }
};

}  // namespace glisson::contact
