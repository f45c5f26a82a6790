// The distances that contact between deformable bodies works with.
#pragma once

#include <glisson/contact/deformable/contact_rules.hpp>

namespace glisson::contact {

/// [m]
struct ContactDistances {
  double offset = 0;  ///< gap that surfaces keep
  double close = 0;   ///< above the offset: an approach is slowed
  double reach = 0;   ///< contacts are looked for up to here, on both sides of a facet
  double slack = 0;   ///< depth that is resolved in one step
  double room = 0;    ///< how far nodes may move, but for what all have in common, before a search
  double steps = 0;   ///< for as many steps they may in any case [-]
  double penalty = 0;  ///< 0: multipliers; else PenaltyShare [-]
  double swing = 1;   ///< how far points beside nodes move then, over room: their facets turn [-]
};
ContactDistances contact_distances(const DeformableContact& contact, const ContactMesh& mesh);

}  // namespace glisson::contact
