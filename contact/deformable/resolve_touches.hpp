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

/// A touch that something has to be done about, as the iterations need it. Corners that it lacks name the
/// first one with weight 0, but for the last.
template <class R>
struct alignas(16) PressingTouch {
  Vec4<R> normal;               ///< unit, w is 0
  int entry[most_touch_nodes];  ///< of PushedNodes; the last is -1 but for quadrilaterals, the first of no
                                ///< touch
  R weight[most_touch_nodes];   ///< [-]
  R missing;                    ///< target less gap if contact pushes as in the last step [m]
  R gain;                       ///< force per gap that is missing [N/m]
  R pressing;                   ///< the multiplier lambda [N]
  R pressing_ahead;             ///< the same extrapolated along the last change [N]
  int slot;
};
/// Its friction.
template <class R>
struct RubbingTouch {
  R friction;             ///< [-]
  Vec3<R> slip;           ///< tangential motion if contact pushes as in the last step [m]
  Vec3<R> rubbing;        ///< force [N]
  Vec3<R> rubbing_ahead;  ///< the same extrapolated [N]
};

/// What a touch has in the force on a node.
template <class R>
struct Push {
  int touch, entry;
  R weight;  ///< of the node in it [-]
};

/// The touches of a step. On hosts only those that are used, in the order of their slots; on devices, which
/// would have to wait to know how many these are, one for each slot.
template <class R>
struct PressingTouches {
  const Touch<R>* found;      ///< [slots]
  const unsigned char* used;  ///< [slots]
  PressingTouch<R>* pressing;
  RubbingTouch<R>* rubbing;  ///< null: nothing rubs
  Vec4<R>* push;             ///< on the side of weight > 0 [N]
};

/// Nodes of the present candidates and the touches that push each. What the iterations go through again and
/// again lies by entry, in the order of the entries: threads then share no cache line but at their borders.
template <class R>
struct PushedNodes {
  const int* nodes;           ///< of the surface                          [count]
  const int* entry;           ///< the other way round                     [surface nodes]
  const int* incident_begin;  ///<                                         [count + 1]
  const int* incident;        ///< slots that may push the node
  Push<R>* pushes;            ///< those that do                           [incident]
  int* push_count;            ///<                                         [count]
  R* share;                   ///< motion by a unit force in each contact [m/N]  [count]
  Vec4<R>* mobility;          ///< motion by a unit force along each axis [m/N]  [count]
  Vec4<R>* guess;             ///< of SurfaceView [m]                            [count]
  Vec4<R>* moved;             ///< by contact in this step less what it was in the last one [m]  [count]
  Vec4<R>* sum;               ///< of hosts, 0 between the loops [N]             [count]
  R* deepest;                 ///< deepest it was behind a facet since the start [m]  [surface nodes]
  Vec4<R>* force;             ///< [N]                                               [surface nodes]
};

/// Which touches push node i, and its share in what they move. Each node looks at all slots that may push
/// it: many times more than do, but devices have a thread for every node.
template <class R>
struct ListPushes {
  static constexpr int cost = 30;
  PushedNodes<R> nodes;
  PressingTouches<R> touches;
  SurfaceView<R> surface;

  GLISSON_HD void operator()(int i) const {
    clear(i);
    start(i);
    for (int j = nodes.incident_begin[i]; j < nodes.incident_begin[i + 1]; ++j) {
      const int slot = nodes.incident[j];
      if (!touches.used[slot]) continue;
      const Touch<R>& t = touches.found[slot];
      for (int m = 0; m < most_touch_nodes; ++m)
        if (t.node[m] == nodes.nodes[i]) {
          const int place = nodes.incident_begin[i] + nodes.push_count[i];  // before it is counted
          nodes.pushes[place] = push_of(i, t, m, slot);
        }
    }
    end(i);
  }

 protected:
  GLISSON_HD void clear(int i) const {
    nodes.force[nodes.nodes[i]] = {};
    nodes.push_count[i] = 0;
  }
  GLISSON_HD void start(int i) const {
    const int k = nodes.nodes[i];
    const Vec3<R> guess = xyz(surface.guess[k]), mobility = surface.moved_by(k, {R(1), R(1), R(1), R(0)});
    nodes.guess[i] = {guess.x, guess.y, guess.z, R(0)};
    nodes.mobility[i] = {mobility.x, mobility.y, mobility.z, R(0)};
    nodes.moved[i] = {-guess.x, -guess.y, -guess.z, R(0)};
    nodes.share[i] = R(0);
  }
  /// Of node m of a touch, which is entry i; counts it.
  GLISSON_HD Push<R> push_of(int i, const Touch<R>& t, int m, int touch) const {
    ++nodes.push_count[i];
    nodes.share[i] += t.weight[m] < R(0) ? -t.weight[m] : t.weight[m];
    R& deepest = nodes.deepest[nodes.nodes[i]];
    if (-t.before > deepest) deepest = -t.before;
    return {touch, i, t.weight[m]};
  }
  GLISSON_HD void end(int i) const { nodes.share[i] *= surface.to[nodes.nodes[i]].w; }
};

/// Makes ready what the iterations go through.
template <class R>
struct StartPressing {
  static constexpr int cost = 10;
  PressingTouches<R> touches;
  const int* slots;  ///< of the touches; null: each slot has one
  const int* entry;
  const R* share;

  GLISSON_HD void operator()(int c) const {
    const int slot = slots ? slots[c] : c;
    PressingTouch<R>& p = touches.pressing[c];
    p.entry[0] = -1;
    if (!touches.used[slot]) return;
    const Touch<R>& t = touches.found[slot];
    R sum = R(0);
    for (int m = 0; m < most_touch_nodes; ++m) {
      const bool there = t.node[m] >= 0;
      p.entry[m] = there ? entry[t.node[m]] : m + 1 < most_touch_nodes ? p.entry[0] : -1;
      p.weight[m] = t.weight[m];
      if (there) sum += (t.weight[m] < R(0) ? -t.weight[m] : t.weight[m]) * share[p.entry[m]];
    }
    p.normal = {t.normal.x, t.normal.y, t.normal.z, R(0)};
    p.missing = t.target - t.gap;
    p.gain = sum > R(0) ? R(1) / sum : R(0);  // 0: both sides are held
    p.pressing = p.pressing_ahead = t.pressing;
    p.slot = slot;
    if (touches.rubbing) touches.rubbing[c] = {t.friction, t.slip, {}, {}};
  }
};

template <class R>
struct PushTouches {
  static constexpr int cost = 4;
  PressingTouches<R> touches;
  const Vec4<R>* moved;
  R ahead;         ///< share of the last change that is added; 0 in the last iteration
  R share;         ///< of the gain along the normal: 1, or of penalties once s, then 0
  Touch<R>* last;  ///< of the last iteration: what the next step starts from

  GLISSON_HD void operator()(int c) const {
    PressingTouch<R>& t = touches.pressing[c];
    if (t.entry[0] < 0) return;
    Row<R> sum{};
    for (int m = 0; m + 1 < most_touch_nodes; ++m) sum = sum + t.weight[m] * Row<R>::of(moved[t.entry[m]]);
    constexpr int of_quad = most_touch_nodes - 1;
    if (t.entry[of_quad] >= 0) sum = sum + t.weight[of_quad] * Row<R>::of(moved[t.entry[of_quad]]);
    const Row<R> normal = Row<R>::of(t.normal);
    const Vec4<R> parts = (sum * normal).value();
    const R along = parts.x + parts.y + parts.z;
    const R pressing = positive(t.pressing_ahead + share * t.gain * (t.missing - along));
    t.pressing_ahead = positive(pressing + ahead * (pressing - t.pressing));
    t.pressing = pressing;
    Row<R> force = t.pressing_ahead * normal;
    if (touches.rubbing) force = force + rub(touches.rubbing[c], t, sum - along * normal);
    touches.push[c] = force.value();
    if (last) last[t.slot].pressing = pressing;
  }

 private:
  GLISSON_HD Row<R> rub(RubbingTouch<R>& r, const PressingTouch<R>& t, const Row<R>& aside) const {
    if (!(r.friction > R(0))) return {};
    const Vec3<R> slip = r.slip + xyz(aside.value());
    const Vec3<R> rubbing = bounded(r.rubbing_ahead - t.gain * slip, r.friction * t.pressing);
    r.rubbing_ahead = bounded(rubbing + ahead * (rubbing - r.rubbing), r.friction * t.pressing_ahead);
    r.rubbing = rubbing;
    return Row<R>::of({r.rubbing_ahead.x, r.rubbing_ahead.y, r.rubbing_ahead.z, R(0)});
  }
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
  const Vec4<R>* push;
  bool last;  ///< iteration: leaves the force

  GLISSON_HD void operator()(int i) const {
    const int count = nodes.push_count[i];
    if (count == 0) return;  // as it was at the start
    const Push<R>* its = nodes.pushes + nodes.incident_begin[i];
    Row<R> f{};
    for (int j = 0; j < count; ++j) f = f + its[j].weight * Row<R>::of(push[its[j].touch]);
    move(i, f);
  }

 protected:
  GLISSON_HD void move(int i, const Row<R>& f) const {
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
