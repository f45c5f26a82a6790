// The touches of a step dealt out to the threads of a host: few, who each go through all that are used. What
// the iterations read then lies without gaps.
#pragma once

#include <glisson/contact/deformable/resolve_touches.hpp>

namespace glisson::contact {

/// What each thread writes for the entries of its part.
template <class R>
struct DealtTouches {
  int* slots;        ///< of the touches that are used, rising      [slots]
  int* pushed;       ///< entries that something pushes, by part    [entries]
  int* touch_count;  ///< how many are used
  int part_count, entry_count, slot_count;

  int first_entry(int part) const { return static_cast<int>(1LL * entry_count * part / part_count); }
};
/// How many a thread has found: touches of all parts, and pushes and pushed entries of its own.
struct DealtCounts {
  int touches = 0, pushes = 0, pushed = 0;
};

/// Does what ListPushes does for the entries of a part, but for those that nothing pushes, and leaves the
/// pushes in the order of the touches.
template <class R>
struct DealTouches : ListPushes<R> {
  static constexpr int cost = 10000;
  DealtTouches<R> dealt;
  DealtCounts* counts;  ///< of this thread

  void operator()(int part) const {
    const int first = dealt.first_entry(part), end = dealt.first_entry(part + 1);
    for (int i = first; i < end; ++i) this->clear(i);
    DealtCounts count;
    for (int c = 0; c < dealt.slot_count; ++c) {
      if (!this->touches.used[c]) continue;
      if (part == 0) dealt.slots[count.touches] = c;
      deal(c, first, end, count);
      ++count.touches;
    }
    for (int j = 0; j < count.pushed; ++j) this->end(dealt.pushed[first + j]);
    if (part == 0) *dealt.touch_count = count.touches;
    *counts = count;
  }

 private:
  void deal(int slot, int first, int end, DealtCounts& count) const {
    const Touch<R>& t = this->touches.found[slot];
    Push<R>* pushes = this->nodes.pushes + this->nodes.incident_begin[first];
    for (int m = 0; m < most_touch_nodes && t.node[m] >= 0; ++m) {
      const int i = this->nodes.entry[t.node[m]];
      if (i < first || i >= end) continue;
      if (this->nodes.push_count[i] == 0) {
        this->start(i);
        dealt.pushed[first + count.pushed++] = i;
      }
      pushes[count.pushes++] = this->push_of(i, t, m, count.touches);
    }
  }
};

/// MovePushed for the entries of a part that something pushes. Each gets its pushes in the same order.
template <class R>
struct MoveDealt : MovePushed<R> {
  static constexpr int cost = 10000;
  DealtTouches<R> dealt;
  DealtCounts count;  ///< of this thread

  void operator()(int part) const {
    const int first = dealt.first_entry(part);
    const Push<R>* pushes = this->nodes.pushes + this->nodes.incident_begin[first];
    Vec4<R>* sum = this->nodes.sum;
    for (int j = 0; j < count.pushes; ++j) {
      const Push<R>& p = pushes[j];
      sum[p.entry] = (Row<R>::of(sum[p.entry]) + p.weight * Row<R>::of(this->push[p.touch])).value();
    }
    for (int j = 0; j < count.pushed; ++j) {
      const int i = dealt.pushed[first + j];
      this->move(i, Row<R>::of(sum[i]));
      sum[i] = {};
    }
  }
};

}  // namespace glisson::contact
