// Writes meshes for other programs and for `glisson convert`: Gmsh 2.2, legacy VTK 4.2, VTU; surfaces as STL.
#pragma once

#include <iosfwd>
#include <string>

#include <glisson/core/mesh/mesh.hpp>

namespace glisson {

enum class Encoding { text, binary };

/// By the extension: .msh (Gmsh 2.2, text), .vtk (legacy 4.2, in the encoding asked for), .vtu (compressed),
/// .stl (outer surface, binary). Error(usage) for other extensions, Error(run) when the file cannot be
/// written.
void write_mesh(const std::string& path, const Mesh& mesh, Encoding encoding = Encoding::binary);
/// Binary STL in single precision; quadrilaterals as two triangles.
void write_surface(const std::string& path, const SurfaceMesh& surface);

/// Labels become both tags; arrays of 1, 3 and 9 components become $NodeData and $ElementData, others are
/// padded with zeros to the next of these numbers, since Gmsh knows no other.  Error(usage) above 9
/// components.
void write_gmsh(std::ostream& out, const Mesh& mesh);
/// Labels become the cell array "label", all arrays one FIELD.
void write_vtk(std::ostream& out, const Mesh& mesh, Encoding encoding);
void write_stl(std::ostream& out, const SurfaceMesh& surface);

}  // namespace glisson
