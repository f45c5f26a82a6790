// The cells that mesh files hold, by their codes in VTK and Gmsh, and which of them become elements or
// facets.
#pragma once

#include <cstdint>
#include <string>

namespace glisson::detail {

/// Codes of VTK (vtkCellType.h) that have a meaning here.
enum CellCode : std::uint8_t {
  cell_vertex = 1,
  cell_line = 3,
  cell_triangle = 5,
  cell_strip = 6,
  cell_polygon = 7,
  cell_pixel = 8,
  cell_quad = 9,
  cell_tetrahedron = 10,
  cell_voxel = 11,
  cell_hexahedron = 12,
};

enum class CellUse : std::uint8_t {
  point_or_line,  ///< skipped
  facet,          ///< linear surface cell
  curved_facet,   ///< surface cell of higher order: skipped in solid meshes, refused in surfaces
  solid,          ///< tetrahedron, hexahedron or voxel
  other_solid,    ///< refused
  unknown,        ///< refused
};

CellUse use_of(int code);
/// "10-node tetrahedron"; "cell of type 99" when the code is not known.
std::string name_of_cell(int code);
/// Nodes of a cell; 0: any number.
int nodes_of_cell(int code);

struct GmshType {
  int code;   ///< of VTK, or of the nearest relative in VTK
  int nodes;  ///< 0: the type is not known
};
GmshType gmsh_type(std::int64_t type);

}  // namespace glisson::detail
