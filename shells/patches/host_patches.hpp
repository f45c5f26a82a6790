// Sections of membranes and shells as blocks of elements that can be cut into patches.
#pragma once

#include <vector>

#include <glisson/core/numbering.hpp>
#include <glisson/core/solids/host_blocks.hpp>
#include <glisson/shells/shell_blocks.hpp>

namespace glisson::shells {

/// The places of the triangles of a section along the space-filling curve  [elements].
std::vector<int> locality_order(const ShellSection& section, const Numbering& numbering);

/// Only nodes and constants [element_count] are filled, in that order.
template <class R>
HostBlock<R> patch_block(const HostShells& host, const std::vector<int>& order, const Numbering& numbering);

}  // namespace glisson::shells
