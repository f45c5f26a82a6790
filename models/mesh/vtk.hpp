// What the parts of the legacy VTK reader share: blocks of numbers as text or bytes.
#pragma once

#include <optional>

#include <glisson/models/mesh/raw_mesh.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson::detail {

/// A file in work. Keywords may be written in any case.
struct VtkReader {
  Scanner scanner;
  RawMesh raw;
  int major = 0, minor = 0;
  bool polydata = false;

  /// The next token, which is a number type; nothing for strings.
  std::optional<NumberType> number_type(bool& is_bit);
  /// `count` numbers of one type; the rest of the line before them is passed over.
  std::vector<double> numbers(std::size_t count, NumberType type, bool is_bit, const char* what);
  std::vector<std::int64_t> integers(std::size_t count, NumberType type, const char* what);
  /// Product of two counts, checked against the bytes that are left.
  std::size_t room_for(std::int64_t count, std::int64_t components, NumberType type, bool is_bit,
                       const char* what);
};

/// CELLS, POLYGONS and the like, behind the keyword. code: of every cell; nothing: CELL_TYPES follows.
void read_vtk_cells(VtkReader& reader, std::optional<int> code);
void read_vtk_cell_types(VtkReader& reader);
/// One attribute (SCALARS, VECTORS, FIELD, ...) behind its keyword, for `count` tuples. False: not an
/// attribute.
bool read_vtk_attribute(VtkReader& reader, std::string_view keyword, std::int64_t count,
                        std::map<std::string, NamedArray>& arrays);
/// METADATA, up to the empty line at its end.
void pass_over_metadata(Scanner& scanner);

}  // namespace glisson::detail
