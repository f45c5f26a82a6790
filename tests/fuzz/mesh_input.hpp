// What the fuzzers of the mesh readers share: any bytes give a mesh that holds together, or an Error, nothing
// else.
#pragma once

#include <cstdlib>
#include <glisson/core/base/error.hpp>
#include <glisson/models/mesh/read_mesh.hpp>
#include <string_view>

namespace glisson::test {

inline void require(bool holds) {
  if (!holds) std::abort();
}

inline void try_solid(std::string_view text, MeshFormat format) {
  try {
    const Mesh mesh = parse_solid_mesh(text, "input", format);
    require(mesh.element_count() > 0 && mesh.begin.size() == mesh.shape.size() + 1);
    require(mesh.label.empty() || mesh.label.size() == mesh.shape.size());
    for (const int n : mesh.nodes) require(n >= 0 && n < mesh.node_count());
    for (const auto& [name, array] : mesh.cell_arrays)
      require(array.values.size() == mesh.shape.size() * static_cast<std::size_t>(array.components));
    for (const auto& [name, array] : mesh.point_arrays)
      require(array.values.size() == mesh.X.size() * static_cast<std::size_t>(array.components));
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::input && error.place().file == "input");
  }
}

inline void try_surface(std::string_view text, MeshFormat format) {
  try {
    const auto surface = parse_surface_mesh(text, "input", format);
    for (const auto& facet : surface.facets)
      for (int a = 0; a < facet.node_count(); ++a) {
        const int n = facet.nodes[static_cast<std::size_t>(a)];
        require(n >= 0 && static_cast<std::size_t>(n) < surface.X.size());
      }
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::input && error.place().file == "input");
  }
}

inline int try_mesh(const unsigned char* data, std::size_t size, MeshFormat format) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try_solid(text, format);
  try_surface(text, format);
  return 0;
}

}  // namespace glisson::test
