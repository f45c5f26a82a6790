// Mesh files: solids from Gmsh, VTK and VTU; surfaces from STL, PLY, OFF, OBJ and the former. See
// doc/meshes.md.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glisson/core/mesh/mesh.hpp>

namespace glisson {

enum class MeshFormat { gmsh, vtk, vtk_xml, stl, ply, off, obj };

using Warnings = std::vector<std::string>;

/// Tetrahedra and hexahedra of a file with labels and arrays, in the order of the file. Lines, surfaces and
/// points are skipped; nodes that no element uses stay (drop_unused_nodes). Inverted tetrahedra are turned,
/// which is said in `warnings`. Coordinates are taken as they are. Throws Error(input) with file and line,
/// byte or cell.
Mesh read_solid_mesh(const std::string& path, Warnings* warnings = nullptr);

/// Facets of a file of any format; of a file that has solids only, their outer surface. Polygons of more than
/// 4 vertices are cut into triangles; the vertices of STL files are merged where they are equal.
SurfaceMesh read_surface_mesh(const std::string& path, Warnings* warnings = nullptr);

/// Facets that a file lists, with the labels and arrays of its cells.
struct LabelledSurface {
  SurfaceMesh surface;
  std::vector<int> label;                    ///< [-]  [facet_count]; 0 where the file has none
  std::map<std::string, NamedArray> arrays;  ///< [facet_count]
};

/// The same facets; none when the file has solids only. Nodes keep their numbers.
LabelledSurface read_labelled_surface(const std::string& path, Warnings* warnings = nullptr);

/// The same from memory; `file` is named in messages.
Mesh parse_solid_mesh(std::string_view text, const std::string& file, MeshFormat format,
                      Warnings* warnings = nullptr);
SurfaceMesh parse_surface_mesh(std::string_view text, const std::string& file, MeshFormat format,
                               Warnings* warnings = nullptr);

/// By the extension of the name; without a known one, by how the text begins. Error(input) when neither
/// tells.
MeshFormat mesh_format(std::string_view text, const std::string& file);

/// Removes nodes that no element uses, with their rows of the point arrays. Returns old -> new number, -1
/// where removed. [node_count before]
std::vector<int> drop_unused_nodes(Mesh& mesh);

}  // namespace glisson
