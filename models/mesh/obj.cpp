// Wavefront OBJ: vertices and faces. Textures, normals, groups and materials are passed over.
#include <algorithm>
#include <iterator>

#include <glisson/models/mesh/formats.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson::detail {
namespace {

bool passed_over(std::string_view word) {
  constexpr std::string_view words[] = {
      "vn", "vt",     "vp",     "o",   "g",     "s",        "mg",       "usemtl",     "mtllib",   "l",
      "p",  "usemap", "maplib", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// "7", "7/1", "7//3": the vertex, counted from 1, or backwards from the last one when negative.
int vertex_of(Scanner& scanner, std::string_view token, std::size_t count) {
  const auto value = scanner.integer_of(token.substr(0, token.find('/')), "a vertex");
  const auto vertices = static_cast<std::int64_t>(count);
  if (value == 0 || value > vertices || value < -vertices)
    scanner.fail("vertex " + std::to_string(value) + " does not exist; " + std::to_string(vertices) +
                 " stand before this line, numbered from 1");
  return static_cast<int>(value > 0 ? value - 1 : vertices + value);
}

}  // namespace

RawMesh parse_obj(std::string_view text, const std::string& file) {
  Scanner scanner(text, file);
  RawMesh raw;
  std::vector<int> nodes;
  while (!scanner.at_end()) {
    const auto word = scanner.token("a keyword");
    if (word == "v") {
      const double x = scanner.coordinate(), y = scanner.coordinate(), z = scanner.coordinate();
      raw.X.push_back({x, y, z});
    } else if (word == "f") {
      nodes.clear();
      while (const auto token = scanner.token_in_line()) {
        if (token->starts_with('#')) break;
        nodes.push_back(vertex_of(scanner, *token, raw.X.size()));
      }
      if (nodes.size() < 3)
        scanner.fail("a face needs at least 3 vertices, but has " + std::to_string(nodes.size()));
      raw.add_cell(cell_polygon, nodes);
    } else if (!word.starts_with('#') && !passed_over(word)) {
      scanner.fail("the keyword " + quoted(word) + " is not known: this is no OBJ file of polygons");
    }
    scanner.line();
  }
  return raw;
}

}  // namespace glisson::detail
