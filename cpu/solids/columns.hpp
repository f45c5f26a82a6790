// Rows of up to three hexahedra that share opposite faces.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glisson/cpu/solids/patch.hpp>

namespace glisson::patches {

/// Hexahedron j of a column has the nodes node[4 j] .. node[4 j + 7] in standard brick order, turned so that
/// the column leaves it through its last four. A short column repeats its last face.
struct Column {
  std::array<int, column_corners> node;
  std::array<int, column_length> element{-1, -1, -1};  ///< place in the list; -1: none
  int corners() const { return 4 * (1 + (element[0] >= 0) + (element[1] >= 0) + (element[2] >= 0)); }
};

/// Each hexahedron in exactly one column. Nodes are 0 .. 65535. Full columns are cut along the axis that
/// gives most of them, then along the other axes from what is left, then shorter ones.
std::vector<Column> build_columns(std::span<const std::array<int, 8>> hexahedra);

}  // namespace glisson::patches
