// Sections of membranes and shells as blocks of elements that can be cut into patches.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/numbering.hpp>
#include <glisson/core/solids/host_patches.hpp>
#include <glisson/shells/shell_blocks.hpp>

namespace glisson::shells {

/// The places of the triangles of a section along the space-filling curve  [elements].
std::vector<int> locality_order(const ShellSection& section, const Numbering& numbering);

/// Only the nodes are filled, in that order.
template <class R>
HostBlock<R> patch_block(const HostShells& host, const std::vector<int>& order, const Numbering& numbering);

/// X of RestView and the arrays of SectionRest; thickness and along have one value where all triangles have
/// the same.
template <class R>
struct HostRest {
  std::vector<R> X, thickness, gradients, images;
  std::vector<Vec3<R>> along;
};

template <class R>
HostRest<R> make_rest(const HostShells& host, const std::vector<int>& order, const HostPatches& patches,
                      const Mesh& mesh, const Numbering& numbering);

}  // namespace glisson::shells
