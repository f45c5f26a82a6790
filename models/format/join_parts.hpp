// Joining sub-models: one after the other into one numbering, then near nodes into one.
#pragma once

#include <glisson/models/format/reader.hpp>

namespace glisson::detail {

/// Appends `part` with its nodes and elements numbered after those of `whole`.
void append(Part& whole, Part part);

/// Appends rows of arrays, `added` of them; what only one side has is 0 on the other.
void append_arrays(std::map<std::string, NamedArray>& to, const std::map<std::string, NamedArray>& from,
                   std::size_t old_count, std::size_t added);

/// Nodes nearer than `distance` [m] to an earlier one become that one, in the mesh and in every list. Returns
/// how many went. Throws Error(input) at `place` when an element would lose a node.
int merge_nodes(Part& part, double distance, const XmlElement& place);

}  // namespace glisson::detail
