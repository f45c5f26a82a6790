// $NodeData and $ElementData: values by tag, which become arrays.
#include <limits>

#include <glisson/models/mesh/gmsh.hpp>

namespace glisson::detail {
namespace {

/// The name stands in quotes on a line of its own, as text in binary files too.
std::string read_name(Scanner& scanner) {
  const auto count = scanner.count("number of names", 1);
  scanner.line();
  std::string name;
  for (std::int64_t i = 0; i < count; ++i) {
    auto line = scanner.line();
    if (i > 0) continue;
    while (!line.empty() && (line.front() == '"' || line.front() == ' ')) line.remove_prefix(1);
    while (!line.empty() && (line.back() == '"' || line.back() == ' ')) line.remove_suffix(1);
    name = line.substr(0, 200);
  }
  return name.empty() ? "data" : name;
}

NamedArray dense(const GmshReader& reader, const GmshData& data, std::size_t count) {
  const auto& tags = data.of_nodes ? reader.nodes : reader.elements;
  const auto components = static_cast<std::size_t>(data.rows.components);
  NamedArray array{data.rows.components,
                   std::vector<double>(count * components, std::numeric_limits<double>::quiet_NaN())};
  for (std::size_t r = 0; r < data.tags.size(); ++r) {
    const int index = tags.find(data.tags[r]);
    if (index < 0)
      reader.scanner.fail("array " + quoted(data.name) + " has a value for the " +
                          (data.of_nodes ? "node " : "element ") + std::to_string(data.tags[r]) +
                          ", which is not in the file");
    for (std::size_t c = 0; c < components; ++c)
      array.values[static_cast<std::size_t>(index) * components + c] = data.rows.values[r * components + c];
  }
  return array;
}

}  // namespace

void read_data(GmshReader& reader, bool of_nodes) {
  Scanner& scanner = reader.scanner;
  GmshData data;
  data.of_nodes = of_nodes;
  data.name = read_name(scanner);
  const auto reals = scanner.count("number of real tags", 2);
  for (std::int64_t i = 0; i < reals; ++i) scanner.number("a real tag");
  const auto integers = scanner.count("number of integer tags", 2);
  if (integers < 3)
    scanner.fail("there are " + std::to_string(integers) +
                 " integer tags; time step, components and rows are needed");
  scanner.integer("the time step");
  const auto components = scanner.integer("the number of components");
  if (components < 1 || components > 9)
    scanner.fail(std::to_string(components) + " components are not supported; 1, 3 and 9 are usual");
  const auto bytes = static_cast<std::size_t>(components);
  const auto rows = scanner.count("number of rows", scanner.binary ? 4 + 8 * bytes : 2 + 2 * bytes);
  for (std::int64_t i = 3; i < integers; ++i) scanner.integer("an integer tag");
  if (scanner.binary) scanner.line();
  data.rows.components = static_cast<int>(components);
  for (std::int64_t r = 0; r < rows; ++r) {
    data.tags.push_back(reader.integer("a tag"));
    for (std::int64_t c = 0; c < components; ++c) data.rows.values.push_back(reader.real("a value"));
  }
  reader.data.push_back(std::move(data));
}

void add_data(GmshReader& reader) {
  for (auto& data : reader.data) {
    const auto count = data.of_nodes ? reader.raw.X.size() : reader.raw.cell_count();
    // An array with values for few of the cells cannot cover the solids; it is not spread out, since many
    // such arrays in a small file could take any amount of memory.
    if (16 * data.tags.size() < count)
      reader.raw.warnings.push_back("array " + quoted(data.name) + " has values for " +
                                    std::to_string(data.tags.size()) + " of " + std::to_string(count) +
                                    (data.of_nodes ? " nodes" : " elements") + " only and was left out");
    else
      (data.of_nodes ? reader.raw.point_arrays : reader.raw.cell_arrays)[data.name] =
          dense(reader, data, count);
    data = {};
  }
}

}  // namespace glisson::detail
