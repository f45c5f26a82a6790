// Arrays as VTK's XML files hold them: inline base64, compressed with zlib. For the writers of .vtu and .vtp.
#pragma once

#include <cstdint>
#include <glisson/models/output/vtu_writer.hpp>
#include <iosfwd>
#include <span>
#include <string>

namespace glisson::detail {

/// A DataArray of float, double, int32 or uint8; `level` is that of zlib.
template <class T>
void write_array(std::ostream& out, const std::string& name, int components, std::span<const T> values,
                 int level);
/// In the precision of the options, whole numbers as Int32.
void write_field(std::ostream& out, const Field& field, const VtuOptions& options);

/// The head of the file up to the first Piece, with TimeValue. `type` is UnstructuredGrid or PolyData.
void begin_vtk_file(std::ostream& out, const char* type, const VtuOptions& options);

/// That the number type of the fields holds.
double largest_value(OutputPrecision precision);

}  // namespace glisson::detail
