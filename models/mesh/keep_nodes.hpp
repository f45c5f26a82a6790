// Takes nodes out of a mesh: positions, point arrays and connectivity together.
#pragma once

#include <vector>

#include <glisson/core/mesh/mesh.hpp>

namespace glisson::detail {

/// renumber: old -> new number; -1 removes the node. New numbers grow with the first old number that has
/// them, and of several old nodes with one new number the first gives position and array rows.  [node_count]
inline void keep_nodes(Mesh& mesh, const std::vector<int>& renumber) {
  std::vector<std::size_t> kept;
  for (std::size_t n = 0; n < renumber.size(); ++n)
    if (renumber[n] == static_cast<int>(kept.size())) kept.push_back(n);
  for (std::size_t k = 0; k < kept.size(); ++k) mesh.X[k] = mesh.X[kept[k]];
  mesh.X.resize(kept.size());
  for (auto& [name, array] : mesh.point_arrays) {
    const auto components = static_cast<std::size_t>(array.components);
    for (std::size_t k = 0; k < kept.size(); ++k)
      for (std::size_t c = 0; c < components; ++c)
        array.values[k * components + c] = array.values[kept[k] * components + c];
    array.values.resize(kept.size() * components);
  }
  for (int& n : mesh.nodes) n = renumber[static_cast<std::size_t>(n)];
  for (auto& triangle : mesh.triangles)
    for (int& n : triangle) n = renumber[static_cast<std::size_t>(n)];
}

}  // namespace glisson::detail
