// The readers of the formats, one per file; each turns the bytes of a whole file into a RawMesh or throws
// Error(input).
#pragma once

#include <string>
#include <string_view>

#include <glisson/models/mesh/raw_mesh.hpp>

namespace glisson::detail {

RawMesh parse_gmsh(std::string_view text, const std::string& file);     ///< MSH 2.x and 4.1
RawMesh parse_vtk(std::string_view text, const std::string& file);      ///< legacy VTK
RawMesh parse_vtk_xml(std::string_view text, const std::string& file);  ///< VTU and VTP
RawMesh parse_stl(std::string_view text, const std::string& file);
RawMesh parse_ply(std::string_view text, const std::string& file);
RawMesh parse_off(std::string_view text, const std::string& file);
RawMesh parse_obj(std::string_view text, const std::string& file);

}  // namespace glisson::detail
