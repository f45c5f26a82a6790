// Object file format, OFF (Geomview), with the prefixes of coloured and normal variants; text only.
#include <glisson/models/mesh/formats.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson::detail {
namespace {

/// The first token of the next line that holds more than a comment.
std::string_view first_token(Scanner& scanner, const char* what) {
  while (true) {
    const auto token = scanner.token(what);
    if (!token.starts_with('#')) return token;
    scanner.line();
  }
}

void check_magic(Scanner& scanner) {
  const auto magic = first_token(scanner, "OFF");
  if (magic != "OFF" && magic != "COFF" && magic != "NOFF" && magic != "CNOFF" && magic != "STOFF")
    scanner.fail(quoted(magic) +
                 " stands where OFF, COFF, NOFF or STOFF should: this is no OFF file of that kind");
}

}  // namespace

RawMesh parse_off(std::string_view text, const std::string& file) {
  Scanner scanner(text, file);
  scanner.section = "header";
  check_magic(scanner);
  const auto first = first_token(scanner, "the number of vertices");
  if (first == "BINARY") scanner.fail("binary OFF is not supported. Save it as text");
  RawMesh raw;
  const auto vertices =
      scanner.checked_count(scanner.integer_of(first, "the number of vertices"), "number of vertices", 6);
  const auto facets = scanner.count("number of facets", 2);
  scanner.line();  // the number of edges may stand here; nobody needs it
  for (std::int64_t n = 0; n < vertices; ++n) {
    scanner.section = "vertex " + std::to_string(n);
    const double x = scanner.number_of(first_token(scanner, "a coordinate"), "a coordinate");
    const double y = scanner.coordinate(), z = scanner.coordinate();
    raw.X.push_back(scanner.finite({x, y, z}));
    scanner.line();  // normal and colour
  }
  std::vector<int> nodes;
  for (std::int64_t f = 0; f < facets; ++f) {
    scanner.section = "facet " + std::to_string(f);
    const auto count = scanner.checked_count(
        scanner.integer_of(first_token(scanner, "the number of vertices"), "the number of vertices"),
        "number of vertices", 2);
    if (count == 0) scanner.fail("a facet without vertices; a count in the header may be wrong");
    nodes.clear();
    for (std::int64_t i = 0; i < count; ++i)
      nodes.push_back(scanner.checked_index(scanner.integer("a vertex"), vertices, "vertex"));
    scanner.line();  // colour
    raw.add_cell(count < 3 ? 0 : cell_polygon, nodes);
  }
  if (!scanner.at_end() && !scanner.rest().starts_with('#'))
    scanner.fail("there is more in the file than the " + std::to_string(vertices) + " vertices and " +
                 std::to_string(facets) + " facets of its header");
  return raw;
}

}  // namespace glisson::detail
