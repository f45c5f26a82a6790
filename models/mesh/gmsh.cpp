// Gmsh MSH files: header, sections, and what versions 2 and 4.1 share. Sections that are not needed are
// passed over. Layout: Gmsh reference manual, "MSH file format" and "Legacy formats, MSH file format version
// 2".
#include <glisson/models/mesh/gmsh.hpp>

#include <limits>

#include <glisson/models/mesh/formats.hpp>

namespace glisson::detail {

bool Tags::add(std::int64_t tag, int index) {
  if (find(tag) >= 0) return false;
  ++size_;
  if (tag < 0 || static_cast<std::uint64_t>(tag) > 4 * size_ + 1024) {
    far_[tag] = index;
    return true;
  }
  const auto place = static_cast<std::size_t>(tag);
  if (near_.size() <= place) near_.resize(place + 1, -1);
  near_[place] = index;
  return true;
}

int Tags::find(std::int64_t tag) const {
  if (tag >= 0 && static_cast<std::uint64_t>(tag) < near_.size() && near_[static_cast<std::size_t>(tag)] >= 0)
    return near_[static_cast<std::size_t>(tag)];
  const auto found = far_.find(tag);
  return found == far_.end() ? -1 : found->second;
}

std::int64_t GmshReader::integer(const char* what) {
  return scanner.binary ? scanner.load<std::int32_t>(what) : scanner.integer(what);
}

std::int64_t GmshReader::size(const char* what) {
  if (!scanner.binary) return scanner.integer(what);
  return size_bytes == 4 ? scanner.load<std::uint32_t>(what) : scanner.load<std::int64_t>(what);
}

std::int64_t GmshReader::count(const char* what, std::size_t least_text, std::size_t least_bytes) {
  return scanner.checked_count(size(what), what, scanner.binary ? least_bytes : least_text);
}

double GmshReader::real(const char* what) {
  return scanner.binary ? scanner.load<double>(what) : scanner.number(what);
}

void GmshReader::read_position() {
  const double x = real("a coordinate"), y = real("a coordinate"), z = real("a coordinate");
  raw.X.push_back(scanner.finite({x, y, z}));
}

void GmshReader::add_node_tag(std::int64_t tag, int index) {
  if (!nodes.add(tag, index)) scanner.fail("node " + std::to_string(tag) + " is there twice");
}

int GmshReader::label_of(std::int64_t value) const {
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  if (value < -most || value > most)
    scanner.fail("the tag " + std::to_string(value) + " is beyond the range of int");
  return static_cast<int>(value);
}

void GmshReader::add_element(std::int64_t tag, std::int64_t type, std::int64_t label) {
  const auto [code, node_count] = gmsh_type(type);
  if (node_count == 0)
    scanner.fail("element " + std::to_string(tag) + " is of type " + std::to_string(type) +
                 ", which is not known. Convert the mesh to linear tetrahedra or hexahedra");
  std::array<int, 125> its_nodes;
  for (int a = 0; a < node_count; ++a) {
    const auto node_tag = is_version_4 ? size("a node") : integer("a node");
    const int n = nodes.find(node_tag);
    if (n < 0)
      scanner.fail("element " + std::to_string(tag) + " uses node " + std::to_string(node_tag) +
                   ", which is not among the " + std::to_string(nodes.size()) + " nodes of the file");
    its_nodes[static_cast<std::size_t>(a)] = n;
  }
  elements.add(tag, static_cast<int>(raw.cell_count()));
  raw.add_cell(code, {its_nodes.data(), static_cast<std::size_t>(node_count)});
  raw.label.push_back(label_of(label));
}

namespace {

/// "2.2 0 8", and in binary files the number 1, which tells the byte order.
void read_format(GmshReader& reader) {
  Scanner& scanner = reader.scanner;
  const auto version = scanner.token("the version");
  reader.is_version_4 = version == "4.1";
  if (!reader.is_version_4 && version != "2" && !version.starts_with("2."))
    scanner.fail("version " + quoted(version) +
                 " of the format is not supported. Save the mesh as version 4.1 or 2.2 (gmsh -format msh41)");
  const auto type = scanner.integer("the file type");
  if (type != 0 && type != 1)
    scanner.fail("the file type " + std::to_string(type) + " is neither 0 (text) nor 1 (binary)");
  const auto size = scanner.integer("the data size");
  if (size != 8 && !(size == 4 && reader.is_version_4))
    scanner.fail("numbers of " + std::to_string(size) + " bytes are not supported; 8 is usual");
  reader.size_bytes = static_cast<int>(size);
  scanner.line();
  if (type == 0) return;
  scanner.binary = true;
  const auto one = scanner.load<std::int32_t>("the byte order");
  if (one == 1) return;
  scanner.big_endian = !scanner.big_endian;
  if (load<std::int32_t>(reinterpret_cast<const char*>(&one), true) != 1)
    scanner.fail("the number that tells the byte order is not 1 in either order; the file is damaged");
}

void pass_over(Scanner& scanner, const std::string& name) {
  const auto end = scanner.rest().find("$End" + name);
  if (end == std::string_view::npos)
    scanner.fail("the section has no end ($End" + name + "); the file is truncated");
  scanner.skip(end);
}

void read_section(GmshReader& reader, const std::string& name) {
  Scanner& scanner = reader.scanner;
  // In binary files the bytes begin right behind the line with the name.
  if (scanner.binary) scanner.line();
  if (name == "Nodes" || name == "Elements") {
    const bool nodes = name == "Nodes";
    if (!nodes && reader.raw.X.empty()) scanner.fail("there are no nodes before the elements");
    if (nodes && !reader.raw.X.empty()) scanner.fail("a second section of nodes; one is allowed");
    if (reader.is_version_4)
      nodes ? read_nodes_4(reader) : read_elements_4(reader);
    else
      nodes ? read_nodes_2(reader) : read_elements_2(reader);
  } else if (name == "Entities" && reader.is_version_4) {
    read_entities_4(reader);
  } else if (name == "ParametricNodes") {
    scanner.fail("parametric nodes are not supported. Save the mesh without them (Mesh.SaveParametric = 0)");
  } else if (name == "NodeData" || name == "ElementData") {
    read_data(reader, name == "NodeData");
  } else {
    pass_over(scanner, name);
  }
}

}  // namespace

RawMesh parse_gmsh(std::string_view text, const std::string& file) {
  GmshReader reader{Scanner(text, file)};
  Scanner& scanner = reader.scanner;
  scanner.big_endian = std::endian::native == std::endian::big;
  bool has_format = false;
  while (!scanner.at_end()) {
    scanner.section.clear();
    const auto word = scanner.token("a section");
    if (!word.starts_with('$') || word.size() < 2)
      scanner.fail(quoted(word) + " stands where a section such as $MeshFormat should begin" +
                   (has_format ? "; a count before it may be too small" : ": this is no Gmsh mesh file"));
    if (word == "$NOD") scanner.fail("Gmsh format 1 is not supported. Save the mesh as version 4.1 or 2.2");
    scanner.section = std::string(word.substr(1, 40));
    if (word == "$MeshFormat") {
      if (has_format) scanner.fail("the section is there twice");
      read_format(reader);
      has_format = true;
    } else if (has_format) {
      read_section(reader, std::string(word.substr(1)));
    } else if (word == "$Comments") {
      pass_over(scanner, "Comments");
    } else {
      scanner.fail("the file does not begin with $MeshFormat");
    }
    scanner.expect("$End" + std::string(word.substr(1)));
  }
  scanner.section.clear();
  if (!has_format) scanner.fail("the file has no $MeshFormat: this is no Gmsh mesh file");
  add_data(reader);
  return std::move(reader.raw);
}

}  // namespace glisson::detail
