// VTK XML polydata (.vtp) of triangles, in the encoding of the .vtu files.
#pragma once

#include <array>
#include <glisson/models/output/vtu_writer.hpp>

namespace glisson {

struct TriangleSurface {
  std::vector<Vec3<double>> X;                ///< [m]  [point_count]
  std::vector<std::array<int, 3>> triangles;  ///< [-]  [triangle_count]
};

/// As write_vtu: fields on points and triangles, nothing is written when a value is not finite.
void write_vtp(const std::filesystem::path& path, const TriangleSurface& surface, const Fields& fields,
               const VtuOptions& options = {}, const std::string& state = {});
void write_vtp(std::ostream& out, const TriangleSurface& surface, const Fields& fields,
               const VtuOptions& options = {});

}  // namespace glisson
