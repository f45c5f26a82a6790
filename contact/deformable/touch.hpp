// One contact of a node with a facet or of two edges: the constraint on the gap between them and the force
// that keeps it.
#pragma once

#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

/// Distances of a run [m].
template <class R>
struct TouchLimits {
  R reach = R(0);   ///< how deep behind a facet a node is still found
  R offset = R(0);  ///< gap that surfaces keep
  R close = R(0);   ///< epsilon_r of Johnsen 2016: gap below which an approach is slowed
  R slack = R(0);   ///< what lies deeper, from the start, comes out down to it by a tenth a step
  R penalty = R(0);  ///< 0: multipliers; else PenaltyShare [-]
};

constexpr int most_touch_nodes = 5;  // a node and the corners of a quadrilateral

/// gap = normal . sum weight x - offset. The weights of one side sum to 1, those of the other to -1, so that
/// the forces weight * force on the nodes have neither a resultant nor, along the normal, a moment.
/// Of one that nothing has to be done about only `came` and `pressing`, which is then 0, mean anything.
template <class R>
struct Touch {
  int node[most_touch_nodes];  ///< of the surface; -1 where there are fewer
  R weight[most_touch_nodes];  ///< [-]
  int came;                    ///< TouchSide, of this and the next step
  Vec3<R> normal;              ///< unit, from the side of weight < 0 to the other
  R before;                    ///< gap at the beginning of the step [m]
  R gap;                       ///< at the end of the step if contact pushes as in the last one [m]
  R target;                    ///< least gap at the end of the step [m]
  R pressing;                  ///< the multiplier lambda [N]
  R friction;                  ///< [-]
  Vec3<R> slip;                ///< tangential motion during the step up to there [m]
};

/// On which side of a thin thing something came near: inside of it, depth does not tell the side.
enum TouchSide : int { came_from_nowhere, came_from_front, came_from_behind };

/// Weights of one node add up: sides of a sheet share their nodes.
template <class R>
GLISSON_HD void add_node(Touch<R>& t, int& count, int node, R weight) {
  for (int m = 0; m < count; ++m)
    if (t.node[m] == node) {
      t.weight[m] += weight;
      return;
    }
  t.node[count] = node;
  t.weight[count++] = weight;
}
template <class R>
GLISSON_HD void end_nodes(Touch<R>& t, int count) {
  for (int m = count; m < most_touch_nodes; ++m) {
    t.node[m] = -1;
    t.weight[m] = R(0);
  }
}

/// Decides by the depth at the beginning of the step, once until what came has left again. The touch is
/// complete but for its target. Returns false for what came from behind.
/// entry: of Candidates
template <class R>
GLISSON_HD bool enters(Touch<R>& t, R entry) {
  if (t.came == came_from_nowhere) t.came = t.before > -entry ? came_from_front : came_from_behind;
  return t.came == came_from_front;
}

/// Share m of its last multiplier that a contact starts with, and share b of a depth that one step takes
/// back. A combination of contacts that the iterations resolve only to a share c per step, and to which the
/// bodies give neither stiffness nor damping, grows from step to step by 1 + s with
///   s^3 + (1 - m + c (1 + b + m)) s^2 + c (1 + 2 b) s + c b = 0.
/// It dies out where c > (b / (1 + 2 b) - (1 - m)) / (1 + b + m) (Routh), here 0.05; below, it swings and
/// grows by less than 0.03 a step, which the damping of bodies has to hold. At rest it keeps the gap
/// (1 - m) (1 / c - 1) load / b, which makes the stress at an interface uneven.
///
/// Measured with 10 iterations and b - (1 - m) = 0.15, as here: blocks that are pressed by 60 % are quiet. In
/// patch tests of 3 x 3 on 4 x 4 cells the stress varies by 0.2 to 0.4 % at m = 0.99, by 0.7 to 1.3 % at 0.95
/// (16 iterations: 0.3 to 0.6 %), not at all at 1. But of 100 heaps of undamped boxes that were thrown at
/// each other one gained 26 % of energy at m = 0.999 and at 1, and none more than 9 % at 0.99. With 8
/// iterations friction is too weak by more than the tests allow.
constexpr double touch_memory = 0.99, depth_share = 0.16;

/// What the gap must be at the end of the step. Behind the surface: on it, as the penetration response of
/// Johnsen 2016, eq. 5.13, demands, or, if it was behind before, nearer by a share of the depth; nodes that
/// were deep at the beginning of the run come out by a tenth a step. In front of it and nearer than `close`:
/// the approach keeps the share gap / close of its speed (eq. 5.19-5.22). Penalties act behind the surface
/// only. Returns false where nothing has to be done. predicted: the gap without any contact force [m]
template <class R>
GLISSON_HD bool set_target(Touch<R>& t, R predicted, const TouchLimits<R>& limits) {
  if (limits.penalty > R(0)) {
    t.target = R(0);
    return predicted < R(0);
  }
  const R closing = t.before - predicted;
  if (predicted < R(0)) {
    const R deep = t.before + limits.slack;
    t.target = deep < R(0) ? R(0.9) * deep : t.before < R(0) ? R(1 - depth_share) * t.before : R(0);
    return t.target > predicted;
  }
  if (!(predicted < limits.close) || !(closing > R(0))) return false;
  t.target = predicted + (R(1) - predicted / limits.close) * closing;
  return true;
}

/// Completes a touch whose nodes, weights, normal and gap are set; `pressing` is that of the last step.
/// motion, guess: of SurfaceView; entry: of Candidates
template <class R>
GLISSON_HD bool complete_touch(Touch<R>& t, const Vec4<R>* motion, const Vec4<R>* guess,
                               const TouchLimits<R>& limits, R entry) {
  Vec3<R> path, pushed;
  for (int m = 0; m < most_touch_nodes && t.node[m] >= 0; ++m) {
    const Vec4<R> d = motion[t.node[m]];
    const Vec4<R> g = guess[t.node[m]];
    path = path + t.weight[m] * Vec3<R>{d.x, d.y, d.z};
    pushed = pushed + t.weight[m] * Vec3<R>{g.x, g.y, g.z};
  }
  const R along = dot(path, t.normal);
  t.before = t.gap - along;
  t.slip = path - along * t.normal;
  t.pressing = limits.penalty > R(0) ? R(0) : R(touch_memory) * t.pressing;
  return enters(t, entry) && set_target(t, t.gap - dot(pushed, t.normal), limits);
}

}  // namespace glisson::contact
