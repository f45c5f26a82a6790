// Legacy VTK files, versions 1 to 5.1, text and binary: header and geometry.
// Layout: "VTK file formats", simple legacy formats; cells with OFFSETS and CONNECTIVITY since version 5.
#include <glisson/models/mesh/vtk.hpp>

#include <glisson/models/mesh/formats.hpp>

namespace glisson::detail {

std::optional<NumberType> VtkReader::number_type(bool& is_bit) {
  constexpr std::pair<std::string_view, NumberType> names[] = {{"bit", NumberType::uint8},
                                                               {"char", NumberType::int8},
                                                               {"signed_char", NumberType::int8},
                                                               {"unsigned_char", NumberType::uint8},
                                                               {"short", NumberType::int16},
                                                               {"unsigned_short", NumberType::uint16},
                                                               {"int", NumberType::int32},
                                                               {"unsigned_int", NumberType::uint32},
                                                               {"long", NumberType::int64},
                                                               {"unsigned_long", NumberType::uint64},
                                                               {"vtkidtype", NumberType::int32},
                                                               {"vtktypeint64", NumberType::int64},
                                                               {"vtktypeuint64", NumberType::uint64},
                                                               {"vtktypeint32", NumberType::int32},
                                                               {"float", NumberType::float32},
                                                               {"double", NumberType::float64}};
  const auto word = scanner.token("a number type");
  is_bit = same_word(word, "bit");
  if (same_word(word, "string")) return {};
  for (const auto& [name, type] : names)
    if (same_word(word, name)) return type;
  scanner.fail(quoted(word) + " is no number type of VTK");
}

std::size_t VtkReader::room_for(std::int64_t count, std::int64_t components, NumberType type, bool is_bit,
                                const char* what) {
  if (components < 0 || components > 1'000'000)
    scanner.fail(std::to_string(components) + " components are not possible");
  if (is_bit && scanner.binary) {
    if (count < 0 || count > 8 * static_cast<std::int64_t>(scanner.remaining()) ||
        count * components > 8 * static_cast<std::int64_t>(scanner.remaining()))
      scanner.fail(std::to_string(count) + " as the " + what + " cannot be right: only " +
                   std::to_string(scanner.remaining()) + " bytes follow");
    return static_cast<std::size_t>(count * components);
  }
  const auto least = scanner.binary ? size_of(type) : 2;
  scanner.checked_count(count, what, least * static_cast<std::size_t>(components));
  return static_cast<std::size_t>(count * components);
}

std::vector<double> VtkReader::numbers(std::size_t count, NumberType type, bool is_bit, const char* what) {
  std::vector<double> values;
  if (!scanner.binary) {
    values.reserve(count);
    while (values.size() < count) values.push_back(scanner.number(what));
    return values;
  }
  scanner.line();
  if (is_bit) {
    const auto data = scanner.bytes((count + 7) / 8, what);
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(static_cast<unsigned char>(data[i / 8]) >> (7 - i % 8) & 1);
    return values;
  }
  const auto data = scanner.bytes(std::uint64_t{count} * size_of(type), what);
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(load_number(data.data() + i * size_of(type), type, scanner.swap()));
  return values;
}

std::vector<std::int64_t> VtkReader::integers(std::size_t count, NumberType type, const char* what) {
  std::vector<std::int64_t> values;
  if (!is_integer(type)) scanner.fail(std::string(what) + " must be whole numbers");
  if (!scanner.binary) {
    values.reserve(count);
    while (values.size() < count) values.push_back(scanner.integer(what));
    return values;
  }
  scanner.line();
  const auto data = scanner.bytes(std::uint64_t{count} * size_of(type), what);
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(load_integer(data.data() + i * size_of(type), type, scanner.swap()));
  return values;
}

void pass_over_metadata(Scanner& scanner) {
  scanner.line();
  while (scanner.remaining() > 0 && scanner.line().find_first_not_of(" \t") != std::string_view::npos) {
  }
}

namespace {

void read_header(VtkReader& reader) {
  Scanner& scanner = reader.scanner;
  scanner.section = "header";
  constexpr std::string_view magic = "# vtk DataFile Version ";
  const auto first = scanner.line();
  if (!first.starts_with(magic))
    scanner.fail("the first line does not begin with '" + std::string(magic) +
                 "': this is no legacy VTK file");
  const auto version = first.substr(magic.size());
  const auto dot = std::min(version.find('.'), version.size());
  reader.major = static_cast<int>(scanner.integer_of(version.substr(0, dot), "the version"));
  const auto minor = version.substr(std::min(dot + 1, version.size()));
  const auto end = std::min(minor.find_first_not_of("0123456789"), minor.size());
  reader.minor = static_cast<int>(scanner.integer_of(minor.substr(0, end), "the version"));
  if (reader.major < 1 || reader.major > 5 || (reader.major == 5 && reader.minor > 1))
    scanner.fail("version " + quoted(version) + " is not known; 1.0 to 5.1 are");
  scanner.line();  // the title
  const auto mode = scanner.token("ASCII or BINARY");
  if (!same_word(mode, "ASCII") && !same_word(mode, "BINARY"))
    scanner.fail(quoted(mode) + " stands where ASCII or BINARY should");
  scanner.binary = same_word(mode, "BINARY");
  scanner.big_endian = true;
}

void read_points(VtkReader& reader) {
  Scanner& scanner = reader.scanner;
  const auto count = scanner.integer("the number of points");
  bool is_bit = false;
  const auto type = reader.number_type(is_bit);
  if (!type || is_bit) scanner.fail("points must be numbers");
  const auto values = reader.numbers(reader.room_for(count, 3, *type, false, "number of points"), *type,
                                     false, "a coordinate");
  if (!reader.raw.X.empty()) scanner.fail("the points are there twice");
  for (std::size_t i = 0; i < values.size(); i += 3)
    reader.raw.X.push_back(scanner.finite({values[i], values[i + 1], values[i + 2]}));
}

/// True when the keyword is one of the geometry.
bool read_geometry(VtkReader& reader, std::string_view keyword) {
  struct Kind {
    const char* keyword;
    int code;
  };
  constexpr Kind kinds[] = {{"VERTICES", cell_vertex + 1},
                            {"LINES", cell_line + 1},
                            {"POLYGONS", cell_polygon},
                            {"TRIANGLE_STRIPS", cell_strip}};
  if (same_word(keyword, "POINTS")) {
    read_points(reader);
    return true;
  }
  if (!reader.polydata && same_word(keyword, "CELLS")) {
    read_vtk_cells(reader, {});
    return true;
  }
  if (!reader.polydata && same_word(keyword, "CELL_TYPES")) {
    read_vtk_cell_types(reader);
    return true;
  }
  for (const auto& kind : kinds)
    if (reader.polydata && same_word(keyword, kind.keyword)) {
      read_vtk_cells(reader, kind.code);
      return true;
    }
  return false;
}

void read_dataset(VtkReader& reader) {
  Scanner& scanner = reader.scanner;
  scanner.expect("DATASET");
  const auto kind = scanner.token("the kind of data set");
  reader.polydata = same_word(kind, "POLYDATA");
  if (!reader.polydata && !same_word(kind, "UNSTRUCTURED_GRID"))
    scanner.fail("a data set " + quoted(kind) + " is not supported; UNSTRUCTURED_GRID and POLYDATA are");
}

void check_complete(VtkReader& reader) {
  RawMesh& raw = reader.raw;
  reader.scanner.section.clear();
  if (raw.code.size() + 1 != raw.begin.size())
    reader.scanner.fail("there are " + std::to_string(raw.begin.size() - 1) + " cells, but CELL_TYPES for " +
                        std::to_string(raw.code.size()));
}

/// CELL_DATA or POINT_DATA, behind the keyword: the number of tuples must be that of cells or points.
std::int64_t read_tuple_count(VtkReader& reader, bool of_points) {
  const auto count = reader.scanner.integer("the number of tuples");
  const auto wanted = of_points ? reader.raw.X.size() : reader.raw.begin.size() - 1;
  if (count < 0 || static_cast<std::uint64_t>(count) != wanted)
    reader.scanner.fail("the data are for " + std::to_string(count) + (of_points ? " points" : " cells") +
                        ", but the file has " + std::to_string(wanted));
  return count;
}

}  // namespace

RawMesh parse_vtk(std::string_view text, const std::string& file) {
  VtkReader reader{Scanner(text, file)};
  Scanner& scanner = reader.scanner;
  read_header(reader);
  read_dataset(reader);
  std::map<std::string, NamedArray> of_file;
  auto* arrays = &of_file;
  std::int64_t tuples = -1;
  while (!scanner.at_end()) {
    const auto keyword = scanner.token("a keyword");
    scanner.section = std::string(keyword.substr(0, 40));
    const bool of_points = same_word(keyword, "POINT_DATA");
    if (of_points || same_word(keyword, "CELL_DATA")) {
      tuples = read_tuple_count(reader, of_points);
      arrays = of_points ? &reader.raw.point_arrays : &reader.raw.cell_arrays;
    } else if (same_word(keyword, "METADATA")) {
      pass_over_metadata(scanner);
    } else if (!read_geometry(reader, keyword) && !read_vtk_attribute(reader, keyword, tuples, *arrays)) {
      scanner.fail("the keyword " + quoted(keyword) + " is not known here; a count before it may be wrong");
    }
  }
  check_complete(reader);
  return std::move(reader.raw);
}

}  // namespace glisson::detail
