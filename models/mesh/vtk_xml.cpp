// VTK XML files: unstructured grids (.vtu) and polydata (.vtp), one or several pieces.
#include <tinyxml2.h>

#include <cmath>
#include <limits>

#include <glisson/core/base/error.hpp>
#include <glisson/models/mesh/formats.hpp>
#include <glisson/models/mesh/scanner.hpp>
#include <glisson/models/mesh/vtk_xml_data.hpp>

namespace glisson::detail {
namespace {

using tinyxml2::XMLElement;

const XMLElement& required_child(const XmlData& data, const XMLElement& parent, const char* name) {
  const auto* child = parent.FirstChildElement(name);
  if (child == nullptr) data.fail(parent, std::string("<") + name + "> is missing in it");
  return *child;
}

const XMLElement* named_array(const XMLElement& parent, std::string_view name) {
  for (auto* array = parent.FirstChildElement("DataArray"); array;
       array = array->NextSiblingElement("DataArray"))
    if (const char* its_name = array->Attribute("Name"); its_name != nullptr && name == its_name)
      return array;
  return nullptr;
}

const XMLElement& required_array(const XmlData& data, const XMLElement& parent, const char* name) {
  const auto* array = named_array(parent, name);
  if (array == nullptr) data.fail(parent, std::string("the array '") + name + "' is missing in it");
  return *array;
}

std::int64_t integer_attribute(const XmlData& data, const XMLElement& element, const char* name,
                               std::int64_t otherwise) {
  const char* text = element.Attribute(name);
  if (text == nullptr) return otherwise;
  Scanner scanner(text, {});
  std::int64_t value = -1;
  try {
    value = scanner.integer_of(text, name);
  } catch (const Error&) {
    value = -1;
  }
  if (value < 0 || value > std::numeric_limits<int>::max())
    data.fail(element,
              std::string(name) + "=" + quoted(text) + " is not a whole number from 0 to 2147483647");
  return value;
}

/// PointData or CellData of one piece, put behind what the pieces before had. `before`, `count`: tuples.
void append_arrays(XmlData& data, const XMLElement* parent, std::size_t before, std::size_t count,
                   std::map<std::string, NamedArray>& arrays) {
  if (parent == nullptr) return;
  for (auto* array = parent->FirstChildElement("DataArray"); array;
       array = array->NextSiblingElement("DataArray")) {
    const char* name = array->Attribute("Name");
    const char* type = array->Attribute("type");
    if (type != nullptr && std::string_view(type) == "String") continue;
    const auto components = integer_attribute(data, *array, "NumberOfComponents", 1);
    if (components < 1) data.fail(*array, "NumberOfComponents=\"0\" is not possible");
    auto& target = arrays[name == nullptr ? "unnamed" : std::string(name).substr(0, 200)];
    if (target.values.empty()) target.components = static_cast<int>(components);
    const auto size = static_cast<std::size_t>(components);
    if (target.components != components || target.values.size() != before * size)
      data.fail(*array, "the array does not have the same values in all pieces, or is there twice");
    const auto values = data.numbers(*array, count * size);
    target.values.insert(target.values.end(), values.begin(), values.end());
  }
}

void append_points(XmlData& data, const XMLElement& piece, std::size_t count, RawMesh& raw) {
  if (count == 0) return;
  const auto& points = required_child(data, piece, "Points");
  const auto& array = required_child(data, points, "DataArray");
  if (integer_attribute(data, array, "NumberOfComponents", 3) != 3)
    data.fail(array, "points need 3 components");
  const auto values = data.numbers(array, 3 * count);
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const Vec3<double> x{values[i], values[i + 1], values[i + 2]};
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z))
      data.fail(array, "point " + std::to_string(i / 3) + " has a coordinate that is not finite");
    raw.X.push_back(x);
  }
}

/// code: of every cell; nothing: there is an array with types.
void append_cells(XmlData& data, const XMLElement& cells, std::size_t count, int code,
                  std::size_t first_point, RawMesh& raw) {
  if (count == 0) return;
  const auto& offset_array = required_array(data, cells, "offsets");
  const auto offsets = data.integers(offset_array, count);
  std::vector<std::int64_t> types;
  if (code < 0) types = data.integers(required_array(data, cells, "types"), count);
  std::int64_t begin = 0;
  for (std::size_t c = 0; c < count; ++c) {
    if (offsets[c] < begin) data.fail(offset_array, "the offsets decrease at cell " + std::to_string(c));
    begin = offsets[c];
    if (code < 0 && (types[c] < 0 || types[c] > 255))
      data.fail(cells, "cell " + std::to_string(c) + " has the type " + std::to_string(types[c]) +
                           ", which is not known");
    raw.code.push_back(static_cast<std::uint8_t>(code < 0 ? types[c] : code));
  }
  const auto& node_array = required_array(data, cells, "connectivity");
  const auto nodes = data.integers(node_array, static_cast<std::size_t>(begin));
  const auto points = static_cast<std::int64_t>(raw.X.size() - first_point);
  for (const auto n : nodes) {
    if (n < 0 || n >= points)
      data.fail(node_array, "point " + std::to_string(n) + " does not exist; there are " +
                                std::to_string(points) + ", numbered from 0");
    raw.nodes.push_back(static_cast<int>(n + static_cast<std::int64_t>(first_point)));
  }
  const auto first_entry = raw.begin.back();
  for (const auto offset : offsets) raw.begin.push_back(first_entry + static_cast<std::size_t>(offset));
}

void append_piece(XmlData& data, const XMLElement& piece, bool polydata, RawMesh& raw) {
  if (piece.Attribute("NumberOfPoints") == nullptr) data.fail(piece, "NumberOfPoints is missing");
  const auto first_point = raw.X.size(), first_cell = raw.cell_count();
  const auto points = static_cast<std::size_t>(integer_attribute(data, piece, "NumberOfPoints", 0));
  append_points(data, piece, points, raw);
  if (raw.X.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    data.fail(piece, "all pieces together have more than 2147483647 points");
  append_arrays(data, piece.FirstChildElement("PointData"), first_point, points, raw.point_arrays);
  if (polydata) {
    // Vertices and lines are of no use. Arrays of cells are kept where polygons are the only cells.
    const auto number = [&](const char* name) {
      return static_cast<std::size_t>(integer_attribute(data, piece, name, 0));
    };
    const auto polys = number("NumberOfPolys"), strips = number("NumberOfStrips");
    if (polys > 0)
      append_cells(data, required_child(data, piece, "Polys"), polys, cell_polygon, first_point, raw);
    if (strips > 0)
      append_cells(data, required_child(data, piece, "Strips"), strips, cell_strip, first_point, raw);
    if (strips + number("NumberOfVerts") + number("NumberOfLines") == 0)
      append_arrays(data, piece.FirstChildElement("CellData"), first_cell, polys, raw.cell_arrays);
    else
      raw.polygons_only = false;
    return;
  }
  if (piece.Attribute("NumberOfCells") == nullptr) data.fail(piece, "NumberOfCells is missing");
  const auto cells = static_cast<std::size_t>(integer_attribute(data, piece, "NumberOfCells", 0));
  append_cells(data, required_child(data, piece, "Cells"), cells, -1, first_point, raw);
  append_arrays(data, piece.FirstChildElement("CellData"), first_cell, cells, raw.cell_arrays);
}

void check_arrays(const XmlData& data, const XMLElement& grid, std::size_t count,
                  const std::map<std::string, NamedArray>& arrays) {
  for (const auto& [name, array] : arrays)
    if (array.values.size() != count * static_cast<std::size_t>(array.components))
      data.fail(grid, "the array " + quoted(name) + " is not there in every piece");
}

void read_settings(XmlData& data, const XMLElement& root) {
  const auto value = [&root](const char* name, const char* otherwise) {
    const char* text = root.Attribute(name);
    return std::string(text == nullptr ? otherwise : text);
  };
  const auto order = value("byte_order", "LittleEndian"), header = value("header_type", "UInt32"),
             compressor = value("compressor", "");
  if (order != "LittleEndian" && order != "BigEndian")
    data.fail(root, "byte_order=" + quoted(order) + " is not known");
  data.swap = (order == "BigEndian") != (std::endian::native == std::endian::big);
  if (header != "UInt32" && header != "UInt64")
    data.fail(root, "header_type=" + quoted(header) + " is not UInt32 or UInt64");
  data.header_bytes = header == "UInt32" ? 4 : 8;
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    data.fail(root, "compressor=" + quoted(compressor) +
                        " is not supported. Save the file with ZLib or without compression");
  data.compressed = !compressor.empty();
}

/// Appended data may be raw bytes, which are no XML: they are cut off before the rest is parsed. Returns the
/// XML.
std::string cut_appended(std::string_view text, XmlData& data) {
  const auto start = text.find("<AppendedData");
  if (start == std::string_view::npos) return std::string(text);
  const auto tag_end = std::min(text.find('>', start), text.size());
  const auto tag = text.substr(start, tag_end - start);
  data.appended_base64 = tag.find("base64") != std::string_view::npos;
  const auto mark = text.find('_', tag_end);
  if (mark != std::string_view::npos) data.appended = text.substr(mark + 1);
  return std::string(text.substr(0, start)) + "</VTKFile>";
}

}  // namespace

RawMesh parse_vtk_xml(std::string_view text, const std::string& file) {
  XmlData data(file, text.size());
  const auto xml = cut_appended(text, data);
  tinyxml2::XMLDocument document;
  if (document.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS)
    throw Error(ErrorKind::input,
                std::string("this is not well-formed XML (") + document.ErrorName() +
                    "); the file is truncated or damaged",
                {file, document.ErrorLineNum(), {}});
  const auto* root = document.RootElement();
  if (root == nullptr || std::string_view(root->Name()) != "VTKFile")
    throw Error(ErrorKind::input, "the root element is not <VTKFile>: this is no VTK XML file",
                {file, 1, {}});
  read_settings(data, *root);
  const char* type = root->Attribute("type");
  const bool polydata = type != nullptr && std::string_view(type) == "PolyData";
  if (type == nullptr || (!polydata && std::string_view(type) != "UnstructuredGrid"))
    data.fail(*root, "type=" + quoted(type == nullptr ? "" : type) +
                         " is not supported; UnstructuredGrid and PolyData are");
  const auto& grid = required_child(data, *root, type);
  RawMesh raw;
  for (auto* piece = grid.FirstChildElement("Piece"); piece != nullptr;
       piece = piece->NextSiblingElement("Piece"))
    append_piece(data, *piece, polydata, raw);
  check_arrays(data, grid, raw.X.size(), raw.point_arrays);
  if (!raw.polygons_only) raw.cell_arrays.clear();
  check_arrays(data, grid, raw.cell_count(), raw.cell_arrays);
  return raw;
}

}  // namespace glisson::detail
