// Along which axes nodes can be moved by a contact force.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/numbering.hpp>

namespace glisson::contact {

/// Axes along which each of these nodes of the mesh can move, as a bit mask: not fixed, not prescribed, no
/// plane across them. Planes that are not across an axis are left out: contact then gives way a little along
/// their normal.
std::vector<int> free_axes_of(const std::vector<int>& nodes, const Model& model, const Numbering& numbering);

}  // namespace glisson::contact
