// Polygon file format, PLY (Stanford): text and binary in both byte orders; vertices and faces are taken,
// other elements and properties passed over.
#include <glisson/models/mesh/formats.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson::detail {
namespace {

struct Property {
  std::string_view name;
  NumberType type = NumberType::float32;
  bool is_list = false;
  NumberType count_type = NumberType::uint8;
};

struct PlyElement {
  std::string_view name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool binary = false, big_endian = false;
  std::vector<PlyElement> elements;
};

NumberType number_type(Scanner& scanner) {
  constexpr std::pair<std::string_view, NumberType> names[] = {
      {"char", NumberType::int8},       {"int8", NumberType::int8},      {"uchar", NumberType::uint8},
      {"uint8", NumberType::uint8},     {"short", NumberType::int16},    {"int16", NumberType::int16},
      {"ushort", NumberType::uint16},   {"uint16", NumberType::uint16},  {"int", NumberType::int32},
      {"int32", NumberType::int32},     {"uint", NumberType::uint32},    {"uint32", NumberType::uint32},
      {"int64", NumberType::int64},     {"uint64", NumberType::uint64},  {"float", NumberType::float32},
      {"float32", NumberType::float32}, {"double", NumberType::float64}, {"float64", NumberType::float64}};
  const auto word = scanner.token("a number type");
  for (const auto& [name, type] : names)
    if (word == name) return type;
  scanner.fail(quoted(word) + " is no number type of PLY");
}

void read_format(Scanner& scanner, Header& header) {
  const auto word = scanner.token("the format");
  header.binary = word != "ascii";
  header.big_endian = word == "binary_big_endian";
  if (header.binary && !header.big_endian && word != "binary_little_endian")
    scanner.fail("the format " + quoted(word) + " is not ascii, binary_little_endian or binary_big_endian");
  if (const auto version = scanner.token("the version"); version != "1.0")
    scanner.fail("version " + quoted(version) + " of the format is not known; 1.0 is");
}

Property read_property(Scanner& scanner) {
  Property property;
  const auto ahead = scanner.rest();
  property.is_list = ahead.substr(std::min(ahead.find_first_not_of(" \t"), ahead.size())).starts_with("list");
  if (property.is_list) {
    scanner.token("list");
    property.count_type = number_type(scanner);
    if (!is_integer(property.count_type)) scanner.fail("the length of a list must be of a whole number type");
  }
  property.type = number_type(scanner);
  property.name = scanner.token("the name of a property");
  return property;
}

Header read_header(Scanner& scanner) {
  Header header;
  scanner.section = "header";
  if (scanner.line() != "ply") scanner.fail("the first line is not 'ply': this is no PLY file");
  bool has_format = false;
  while (true) {
    const auto word = scanner.token("end_header");
    if (word == "end_header") break;
    if (word == "format") {
      read_format(scanner, header);
      has_format = true;
    } else if (word == "element") {
      PlyElement element{scanner.token("the name of an element"), 0, {}};
      element.count = scanner.count("number of elements", 1);
      header.elements.push_back(element);
    } else if (word == "property") {
      if (header.elements.empty()) scanner.fail("a property stands before the first element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (word != "comment" && word != "obj_info") {
      scanner.fail("the keyword " + quoted(word) + " is not known");
    }
    scanner.line();
  }
  scanner.line();
  if (!has_format) scanner.fail("the header has no format line");
  return header;
}

double read_number(Scanner& scanner, NumberType type) {
  if (!scanner.binary) return scanner.number("a value");
  return load_number(scanner.bytes(size_of(type), "a value").data(), type, scanner.swap());
}

std::int64_t read_integer(Scanner& scanner, NumberType type) {
  if (!scanner.binary) return scanner.integer("a whole number");
  return load_integer(scanner.bytes(size_of(type), "a value").data(), type, scanner.swap());
}

std::int64_t list_length(Scanner& scanner, const Property& property) {
  return scanner.checked_count(read_integer(scanner, property.count_type), "length of a list",
                               scanner.binary ? size_of(property.type) : 2);
}

void pass_over(Scanner& scanner, const Property& property) {
  const auto count = property.is_list ? list_length(scanner, property) : 1;
  for (std::int64_t i = 0; i < count; ++i) read_number(scanner, property.type);
}

void read_vertex(Scanner& scanner, const PlyElement& element, RawMesh& raw) {
  Vec3<double> x;
  for (const auto& property : element.properties) {
    double* target = property.name == "x"   ? &x.x
                     : property.name == "y" ? &x.y
                     : property.name == "z" ? &x.z
                                            : nullptr;
    if (target == nullptr || property.is_list)
      pass_over(scanner, property);
    else
      *target = read_number(scanner, property.type);
  }
  raw.X.push_back(scanner.finite(x));
}

void read_face(Scanner& scanner, const PlyElement& element, RawMesh& raw) {
  for (const auto& property : element.properties) {
    if (property.name != "vertex_indices" && property.name != "vertex_index") {
      pass_over(scanner, property);
      continue;
    }
    if (!property.is_list || !is_integer(property.type))
      scanner.fail("the vertices of a face must be a list of whole numbers");
    std::vector<int> nodes(static_cast<std::size_t>(list_length(scanner, property)));
    for (int& n : nodes)
      n = scanner.checked_index(read_integer(scanner, property.type), std::ssize(raw.X), "vertex");
    raw.add_cell(nodes.size() < 3 ? 0 : cell_polygon, nodes);
  }
}

bool has_property(const PlyElement& element, std::string_view name) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [name](const Property& p) { return p.name == name && !p.is_list; });
}

/// Bytes that one element takes at least; an element without properties takes none and is not looped over.
std::size_t least_bytes(const PlyElement& element, bool binary) {
  std::size_t bytes = 0;
  for (const auto& p : element.properties) bytes += binary ? size_of(p.is_list ? p.count_type : p.type) : 2;
  return bytes;
}

}  // namespace

RawMesh parse_ply(std::string_view text, const std::string& file) {
  Scanner scanner(text, file);
  const auto header = read_header(scanner);
  scanner.binary = header.binary;
  scanner.big_endian = header.big_endian;
  RawMesh raw;
  for (const auto& element : header.elements) {
    const std::string name(element.name.substr(0, 40));
    scanner.section = "element " + name;
    scanner.checked_count(element.count, "number of elements",
                          std::max<std::size_t>(1, least_bytes(element, header.binary)));
    if (element.properties.empty()) continue;
    const bool vertex = element.name == "vertex", face = element.name == "face";
    if (element.name == "tristrips")
      scanner.fail("triangle strips are not supported. Save the file with faces");
    if (vertex && !(has_property(element, "x") && has_property(element, "y") && has_property(element, "z")))
      scanner.fail("the vertices have no properties x, y and z");
    for (std::int64_t i = 0; i < element.count; ++i) {
      scanner.section = name + " " + std::to_string(i);
      if (vertex)
        read_vertex(scanner, element, raw);
      else if (face)
        read_face(scanner, element, raw);
      else
        for (const auto& property : element.properties) pass_over(scanner, property);
    }
  }
  return raw;
}

}  // namespace glisson::detail
