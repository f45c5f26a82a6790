// The part of touches in the iterations of resolve_touches.hpp: the multiplier and the friction of each from
// the motion of its nodes. On hosts a few touches at a time, one in each lane.
#pragma once

#include <glisson/contact/deformable/touch.hpp>
#include <glisson/contact/geometry/row.hpp>

namespace glisson::contact {

constexpr int touches_abreast = 8;  // in a pack: their numbers lie side by side, for the lanes of a host

/// A pack of touches that something has to be done about, as the iterations need them. Corners that one lacks
/// name the first one with weight 0.
template <class R>
struct alignas(32) PressingPack {
  static constexpr int width = touches_abreast;
  R normal[3][width];                  ///< unit
  int place[most_touch_nodes][width];  ///< of its nodes
  R weight[most_touch_nodes][width];   ///< [-]
  R missing[width];                    ///< target less gap if contact pushes as in the last step [m]
  R gain[width];                       ///< force per gap that is missing [N/m]
  R pressing[width];                   ///< the multiplier lambda [N]
  R pressing_ahead[width];             ///< the same extrapolated along the last change [N]
  int slot[width];                     ///< -1: no touch
};
/// Their friction.
template <class R>
struct alignas(32) RubbingPack {
  static constexpr int width = touches_abreast;
  R friction[width];          ///< [-]
  R slip[3][width];           ///< tangential motion if contact pushes as in the last step [m]
  R rubbing[3][width];        ///< force [N]
  R rubbing_ahead[3][width];  ///< the same extrapolated [N]
};

/// The touches of a step. On hosts only those that are used, in the order of their slots; on devices, which
/// would have to wait to know how many these are, one for each slot.
template <class R>
struct PressingTouches {
  const Touch<R>* found;      ///< [slots]
  const unsigned char* used;  ///< [slots]
  PressingPack<R>* pressing;
  RubbingPack<R>* rubbing;  ///< null: nothing rubs
  Vec4<R>* push;            ///< on the side of weight > 0 [N]
};

/// Makes ready what the iterations go through, and the push that they start from.
template <class R>
struct StartPressing {
  static constexpr int cost = 10;
  PressingTouches<R> touches;
  const int* slots;          ///< of the touches; null: each slot has one
  const int *entry, *place;  ///< of the surface nodes
  const R* share;

  GLISSON_HD void operator()(int c) const {
    const int slot = slots ? slots[c] : c, l = c % touches_abreast;
    PressingPack<R>& p = touches.pressing[c / touches_abreast];
    p.slot[l] = touches.used[slot] ? slot : -1;
    if (p.slot[l] < 0) return;
    const Touch<R>& t = touches.found[slot];
    R sum = R(0);
    for (int m = 0; m < most_touch_nodes; ++m) {
      const bool there = t.node[m] >= 0;
      p.place[m][l] = place[t.node[there ? m : 0]];
      p.weight[m][l] = t.weight[m];
      if (there) sum += (t.weight[m] < R(0) ? -t.weight[m] : t.weight[m]) * share[entry[t.node[m]]];
    }
    put(p.normal, l, t.normal);
    p.missing[l] = t.target - t.gap;
    p.gain[l] = sum > R(0) ? R(1) / sum : R(0);  // 0: both sides are held
    p.pressing[l] = p.pressing_ahead[l] = t.pressing;
    touches.push[c] = (t.pressing * Row<R>::of({t.normal.x, t.normal.y, t.normal.z, R(0)})).value();
    if (touches.rubbing) start(touches.rubbing[c / touches_abreast], l, t);
  }

 private:
  GLISSON_HD static void start(RubbingPack<R>& r, int l, const Touch<R>& t) {
    r.friction[l] = t.friction;
    put(r.slip, l, t.slip);
    put(r.rubbing, l, {});
    put(r.rubbing_ahead, l, {});
  }
  GLISSON_HD static void put(R (&to)[3][touches_abreast], int l, const Vec3<R>& a) {
    to[0][l] = a.x;
    to[1][l] = a.y;
    to[2][l] = a.z;
  }
};

/// Each call for the touches c to c + lane_count<L> - 1.
template <class R, class L = R>
struct PushTouches {
  static constexpr int cost = 4, width = lane_count<L>;
  PressingTouches<R> touches;
  const Vec4<R>* moved;
  R ahead;         ///< share of the last change that is added; 0 in the last iteration
  R share;         ///< of the gain along the normal: 1, or of penalties once s, then 0
  Touch<R>* last;  ///< of the last iteration: what the next step starts from

  /// The same with other lanes.
  template <class Other>
  PushTouches<R, Other> with_lanes() const {
    return {touches, moved, ahead, share, last};
  }
  GLISSON_HD void operator()(int c) const {
    const int l = c % touches_abreast;
    PressingPack<R>& t = touches.pressing[c / touches_abreast];
    if (width == 1 && t.slot[l] < 0) return;
    const Vec3<L> by = moved_by(t, l), normal = three(t.normal, l);
    const L along = dot(by, normal), before = one(t.pressing, l), gain = one(t.gain, l);
    const L pressing = positive(one(t.pressing_ahead, l) + L(share) * gain * (one(t.missing, l) - along));
    const L pressing_ahead = positive(pressing + L(ahead) * (pressing - before));
    put_lanes(pressing, t.pressing + l);
    put_lanes(pressing_ahead, t.pressing_ahead + l);
    Vec3<L> force = pressing_ahead * normal;
    if (touches.rubbing)
      rub(touches.rubbing[c / touches_abreast], l, by - along * normal, {gain, pressing, pressing_ahead},
          force);
    put_rows(force, touches.push + c);
    if (last)
      for (int k = l; k < l + width; ++k) last[t.slot[k]].pressing = t.pressing[k];
  }

 private:
  struct Pressing {
    L gain, now, ahead;
  };
  /// The motion of one side relative to the other.
  GLISSON_HD Vec3<L> moved_by(const PressingPack<R>& t, int l) const {
    Row<R> sum[width];
    for (int k = 0; k < width; ++k) {
      sum[k] = of_node(t, 0, l + k);
      for (int m = 1; m + 1 < most_touch_nodes; ++m) sum[k] = sum[k] + of_node(t, m, l + k);
    }
    constexpr int of_quad = most_touch_nodes - 1;
    if (bits_of(one(t.weight[of_quad], l) != L(R(0))))
      for (int k = 0; k < width; ++k) sum[k] = sum[k] + of_node(t, of_quad, l + k);
    return turned<L>(sum);
  }
  GLISSON_HD Row<R> of_node(const PressingPack<R>& t, int m, int l) const {
    return t.weight[m][l] * Row<R>::of(moved[t.place[m][l]]);
  }
  /// Adds the friction to the force.
  GLISSON_HD void rub(RubbingPack<R>& r, int l, const Vec3<L>& aside, const Pressing& pressing,
                      Vec3<L>& force) const {
    const L friction = one(r.friction, l);
    if (!bits_of(friction > L(R(0)))) return;
    const Vec3<L> slip = three(r.slip, l) + aside;
    const Vec3<L> rubbing =
        bounded(three(r.rubbing_ahead, l) - pressing.gain * slip, friction * pressing.now);
    const Vec3<L> further = rubbing + L(ahead) * (rubbing - three(r.rubbing, l));
    const Vec3<L> rubbing_ahead = bounded(further, friction * pressing.ahead);
    put(rubbing, r.rubbing, l);
    put(rubbing_ahead, r.rubbing_ahead, l);
    force = force + rubbing_ahead;
  }
  GLISSON_HD static L one(const R* from, int l) { return lanes_at<L>(from + l); }
  GLISSON_HD static Vec3<L> three(const R (&from)[3][touches_abreast], int l) {
    return {one(from[0], l), one(from[1], l), one(from[2], l)};
  }
  GLISSON_HD static void put(const Vec3<L>& a, R (&to)[3][touches_abreast], int l) {
    put_lanes(a.x, to[0] + l);
    put_lanes(a.y, to[1] + l);
    put_lanes(a.z, to[2] + l);
  }
  GLISSON_HD static L positive(L a) { return select(a > L(R(0)), a, L(R(0))); }
  GLISSON_HD static Vec3<L> bounded(const Vec3<L>& a, L most) {
    const L squared = dot(a, a), unit(R(1));
    return select(squared > most * most, most / square_root(squared), unit) * a;
  }
};

}  // namespace glisson::contact
