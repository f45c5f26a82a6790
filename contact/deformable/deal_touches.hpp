// The touches of a step dealt out to the threads of a host: few, who each go through all that are used. What
// the iterations read then lies without gaps, touches are pushed a pack at a time, and nodes that equally
// many touches push lie side by side, so that a core can guess where the sum of each ends.
#pragma once

#include <glisson/contact/deformable/resolve_touches.hpp>

namespace glisson::contact {

/// A push on an entry.
template <class R>
struct DealtPush {
  int entry;
  Push<R> push;
};

/// What each thread writes for the entries of its part. Those that something pushes get places, from the
/// first entry of the part on, where lies what the iterations read of them.
template <class R>
struct DealtTouches {
  int* slots;           ///< of the touches that are used, rising; the last fills up its pack  [slots]
  int* touch_count;     ///< how many are used
  int* found_entry;     ///< entries that something pushes, in that order, by part     [entries]
  int* pushed;          ///< the same by place: entry of each place               [entries]
  int* place;           ///< the other way round                                  [surface nodes]
  int* push_end;        ///< where the pushes of each place end, in those of the part  [entries]
  DealtPush<R>* found;  ///< pushes in the order of the touches, by part          [incident]
  int part_count, entry_count, slot_count;

  int first_entry(int part) const { return static_cast<int>(1LL * entry_count * part / part_count); }
};
/// How many a thread has found: touches of all parts, and pushes and pushed entries of its own.
struct DealtCounts {
  int touches = 0, pushes = 0, pushed = 0;

  int packs() const { return (touches + touches_abreast - 1) / touches_abreast; }
};

/// Does what ListPushes does for the entries of a part, but for those that nothing pushes.
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
    give_places(first, count.pushed);
    sort_pushes(first, count);
    if (part == 0) end_slots(count);
    *counts = count;
  }

 private:
  void deal(int slot, int first, int end, DealtCounts& count) const {
    const Touch<R>& t = this->touches.found[slot];
    DealtPush<R>* pushes = dealt.found + this->nodes.incident_begin[first];
    for (int m = 0; m < most_touch_nodes && t.node[m] >= 0; ++m) {
      const int i = this->nodes.entry[t.node[m]];
      if (i < first || i >= end) continue;
      if (this->nodes.push_count[i] == 0) {
        this->nodes.share[i] = R(0);
        dealt.found_entry[first + count.pushed++] = i;
      }
      pushes[count.pushes++] = {i, this->push_of(i, t, m, count.touches)};
    }
  }
  /// By the number of pushes.
  void give_places(int first, int pushed) const {
    constexpr int classes = 16;
    const int* found = dealt.found_entry + first;
    const auto class_of = [&](int i) {
      const int its = this->nodes.push_count[i];
      return its < classes ? its : classes;
    };
    int next[classes + 2] = {};
    for (int j = 0; j < pushed; ++j) ++next[class_of(found[j]) + 1];
    for (int k = 0; k <= classes; ++k) next[k + 1] += next[k];
    for (int j = 0; j < pushed; ++j) dealt.pushed[first + next[class_of(found[j])]++] = found[j];
  }
  /// By place, those of each in the order of the touches.
  void sort_pushes(int first, const DealtCounts& count) const {
    const int begin = this->nodes.incident_begin[first];
    int end = 0;
    for (int place = first; place < first + count.pushed; ++place) {
      const int i = dealt.pushed[place], its = this->nodes.push_count[i];
      dealt.place[this->nodes.nodes[i]] = place;
      this->start(i, place);
      this->end(i);
      this->nodes.push_count[i] = end;  // from here on: where its next one belongs
      end += its;
      dealt.push_end[place] = end;
    }
    for (const DealtPush<R>*p = dealt.found + begin, *last = p + count.pushes; p != last; ++p)
      this->nodes.pushes[begin + this->nodes.push_count[p->entry]++] = p->push;
  }
  void end_slots(const DealtCounts& count) const {
    *dealt.touch_count = count.touches;
    for (int c = count.touches; c < count.packs() * touches_abreast; ++c)
      dealt.slots[c] = dealt.slots[count.touches - 1];
  }
};

/// PushTouches a pack at a time.
template <class R, class L = FacetLanes<R>>
struct PushDealt : PushTouches<R, L> {
  static constexpr int cost = PushTouches<R>::cost * touches_abreast;

  void operator()(int pack) const {
    const int first = pack * touches_abreast;
    for (int l = 0; l < touches_abreast; l += lane_count<L>) PushTouches<R, L>::operator()(first + l);
  }
};

/// MovePushed for the places of a part.
template <class R>
struct MoveDealt : MovePushed<R> {
  static constexpr int cost = 10000;
  DealtTouches<R> dealt;
  DealtCounts count;  ///< of this thread

  void operator()(int part) const {
    const int first = dealt.first_entry(part);
    const Push<R>*pushes = this->nodes.pushes + this->nodes.incident_begin[first], *its = pushes;
    for (int place = first; place < first + count.pushed; ++place) {
      const Push<R>* end = pushes + dealt.push_end[place];
      this->move(dealt.pushed[place], place, its, end);
      its = end;
    }
  }
};

}  // namespace glisson::contact
