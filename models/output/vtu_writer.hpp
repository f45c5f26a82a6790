// VTK XML unstructured grids (.vtu): inline base64, compressed with zlib; the encoding that ParaView, VTK and
// meshio all read.
#pragma once

#include <filesystem>
#include <glisson/core/mesh/mesh.hpp>
#include <glisson/models/output/fields.hpp>
#include <iosfwd>
#include <optional>

namespace glisson {

enum class OutputPrecision { single, full };

struct VtuOptions {
  OutputPrecision precision = OutputPrecision::single;  ///< of the fields; points and times are always double
  bool mesh_arrays = true;                              ///< also writes the arrays that came with the mesh
  int compression = 1;                                  ///< zlib level, 1 (fast) to 9 (small)
  std::optional<double> time;                           ///< written as TimeValue [s]
};

/// Points are the rest positions; labels become the cell array "label". An array of `fields` hides one of the
/// mesh with the same name. Nothing is written when a value is not finite (Error(run)) or a size does not fit
/// (Error(usage)). `state` ends the message when the disk is full, see write_atomically.
void write_vtu(const std::filesystem::path& path, const Mesh& mesh, const Fields& fields = {},
               const VtuOptions& options = {}, const std::string& state = {});
void write_vtu(std::ostream& out, const Mesh& mesh, const Fields& fields = {},
               const VtuOptions& options = {});

}  // namespace glisson
