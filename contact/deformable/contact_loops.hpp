// The loops of a step that a host may have compiled for the instruction set of the machine.
#pragma once

#include <glisson/contact/deformable/deal_touches.hpp>
#include <glisson/contact/deformable/find_touches.hpp>

namespace glisson::contact {

/// Indices first .. end - 1 of a loop body.
template <class Body>
using BodyRange = void (*)(const Body& body, int first, int end);

/// null: as compiled for every machine.
template <class R>
struct ContactLoops {
  const char* set = nullptr;  ///< name of the instruction set
  BodyRange<FindFacetTouch<R>> find_facets = nullptr;
  BodyRange<PushDealt<R>> push = nullptr;
  BodyRange<MoveDealt<R>> move = nullptr;
};

/// A body whose range a backend may have run by somebody else.
template <class Body>
struct RangedBody : Body {
  BodyRange<Body> range;
  void run(int first, int end) const { range(*this, first, end); }
};

template <class Loop, class Body>
void loop_ranged(Loop& loop, int n, const Body& body, BodyRange<Body> range) {
  if (range)
    loop(n, RangedBody<Body>{body, range});
  else
    loop(n, body);
}

/// Of an instruction set by name. Throws as choose_instruction_set does.
const ContactLoops<float>& contact_loops(const char* set);

}  // namespace glisson::contact
