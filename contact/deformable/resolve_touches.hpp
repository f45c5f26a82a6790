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

#include <glisson/contact/deformable/push_touches.hpp>
#include <glisson/contact/deformable/surface_view.hpp>

namespace glisson::contact {

/// What a touch has in the force on a node.
template <class R>
struct Push {
  int touch;
  R weight;  ///< of the node in it [-]
};

/// Nodes of the present candidates and the touches that push each. What the iterations go through again and
/// again lies by place, in the order of the entries: threads then share no cache line but at their borders.
/// The place of an entry is the entry itself on devices, that of DealtTouches on hosts.
template <class R>
struct PushedNodes {
  const int* nodes;           ///< of the surface                          [count]
  const int* entry;           ///< the other way round                     [surface nodes]
  const int* incident_begin;  ///<                                         [count + 1]
  const int* incident;        ///< slots that may push the node
  Push<R>* pushes;            ///< those that do                           [incident]
  int* push_count;            ///<                                         [count]
  R* share;                   ///< motion by a unit force in each contact [m/N]  [count]
  Vec4<R>* mobility;          ///< motion by a unit force along each axis [m/N]  [places]
  Vec4<R>* guess;             ///< of SurfaceView [m]                            [places]
  Vec4<R>* moved;             ///< by contact in this step less what it was in the last one [m]  [places]
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
    start(i, i);
    nodes.share[i] = R(0);
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
  GLISSON_HD void start(int i, int place) const {
    const int k = nodes.nodes[i];
    const Vec3<R> guess = xyz(surface.guess[k]), mobility = surface.moved_by(k, {R(1), R(1), R(1), R(0)});
    nodes.guess[place] = {guess.x, guess.y, guess.z, R(0)};
    nodes.mobility[place] = {mobility.x, mobility.y, mobility.z, R(0)};
    nodes.moved[place] = {-guess.x, -guess.y, -guess.z, R(0)};
  }
  /// Of node m of a touch, which is entry i; counts it.
  GLISSON_HD Push<R> push_of(int i, const Touch<R>& t, int m, int touch) const {
    ++nodes.push_count[i];
    nodes.share[i] += t.weight[m] < R(0) ? -t.weight[m] : t.weight[m];
    R& deepest = nodes.deepest[nodes.nodes[i]];
    if (-t.before > deepest) deepest = -t.before;
    return {touch, t.weight[m]};
  }
  GLISSON_HD void end(int i) const { nodes.share[i] *= surface.to[nodes.nodes[i]].w; }
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
    move(i, i, its, its + count);
  }

 protected:
  GLISSON_HD void move(int i, int place, const Push<R>* its, const Push<R>* end) const {
    Row<R> f{};
    for (; its != end; ++its) f = f + its->weight * Row<R>::of(push[its->touch]);
    nodes.moved[place] = (Row<R>::of(nodes.mobility[place]) * f - Row<R>::of(nodes.guess[place])).value();
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
