// Joining sub-models: one after the other into one numbering, then near nodes into one.
#pragma once

#include <glisson/models/format/reader.hpp>

namespace glisson::detail {

/// Appends `part` with its nodes and elements numbered after those of `whole`.
void append(Part& whole, Part part);

/// For each node the one it becomes: the first kept node closer than `distance` [m], or itself.  [node_count]
/// Result in new numbers, without gaps.
std::vector<int> merged_numbers(const std::vector<Vec3<double>>& X, double distance);

/// Renumbers everything by merged_numbers() and drops merged nodes. Returns how many went. Throws
/// Error(input) at `place` when an element would lose a node.
int merge_nodes(Part& part, double distance, const XmlElement& place);

}  // namespace glisson::detail
