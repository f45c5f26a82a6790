// What a mesh file holds before elements or facets are chosen from it: the common result of all format
// readers.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include <glisson/core/mesh/mesh.hpp>
#include <glisson/models/mesh/cell_types.hpp>
#include <glisson/models/mesh/read_mesh.hpp>

namespace glisson::detail {

/// Cells of any kind in the order of the file. Node numbers are 0-based and may be out of range until a mesh
/// is made.
struct RawMesh {
  std::vector<Vec3<double>> X;        ///< [-]  [point_count]
  std::vector<std::uint8_t> code;     ///< CellCode [-]                          [cell_count]
  std::vector<std::size_t> begin{0};  ///< first entry in nodes [-]           [cell_count + 1]
  std::vector<int> nodes;             ///< connectivity [-]                      [begin.back()]
  std::vector<int> label;             ///< [-]  [cell_count] or empty
  std::map<std::string, NamedArray> cell_arrays, point_arrays;  ///< a NaN stands where the file gave no value
  bool polygons_only = true;  ///< of VTP: false where other cells make the arrays of cells useless
  std::vector<std::string> warnings;

  std::size_t cell_count() const { return code.size(); }
  std::span<const int> cell(std::size_t c) const {
    return {nodes.data() + begin[c], begin[c + 1] - begin[c]};
  }
  void add_cell(int its_code, std::span<const int> its_nodes) {
    code.push_back(static_cast<std::uint8_t>(its_code));
    nodes.insert(nodes.end(), its_nodes.begin(), its_nodes.end());
    begin.push_back(nodes.size());
  }
};

/// Tetrahedra and hexahedra of the file, turned where needed. Error(input) when there is none, or a solid
/// that is neither. `file` is named in errors; warnings are added to raw.warnings.
Mesh solid_mesh(RawMesh& raw, const std::string& file);

/// Rows of an array.
NamedArray chosen_rows(const NamedArray& array, const std::vector<std::size_t>& chosen);

/// Facets that the file lists, with labels and arrays; none when there are only solids.
LabelledSurface labelled_surface(RawMesh& raw, const std::string& file);

/// Triangles and quadrilaterals of the file; larger polygons are cut into fans. Without any, the outer
/// surface of the solids. Nodes keep their numbers.
SurfaceMesh surface_mesh(RawMesh& raw, const std::string& file);

}  // namespace glisson::detail
