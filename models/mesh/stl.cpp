// STL, ASCII and binary. Normals are not read: the order of the vertices says which side is out.
#include <cstring>
#include <unordered_map>

#include <glisson/models/mesh/formats.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson::detail {
namespace {

/// Gives equal positions one number, in the order in which they come.
class Vertices {
 public:
  explicit Vertices(RawMesh& raw) : raw_(raw) {}

  int number(Vec3<double> x) {
    x = x + Vec3<double>{0, 0, 0};  // -0 becomes 0, so that equal means equal bytes
    const auto [found, is_new] = numbers_.try_emplace(x, static_cast<int>(raw_.X.size()));
    if (is_new) raw_.X.push_back(x);
    return found->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const Vec3<double>& x) const {
      std::uint64_t h = 0;
      for (const double v : {x.x, x.y, x.z}) {
        h = (h ^ std::bit_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
      }
      return h;
    }
  };
  struct Equal {
    bool operator()(const Vec3<double>& a, const Vec3<double>& b) const {
      return a.x == b.x && a.y == b.y && a.z == b.z;
    }
  };

  RawMesh& raw_;
  std::unordered_map<Vec3<double>, int, Hash, Equal> numbers_;
};

constexpr std::size_t header_bytes = 80, facet_bytes = 50;

bool is_binary(std::string_view text) {
  if (text.size() < header_bytes + 4) return false;
  Scanner scanner(text, {});
  scanner.skip(header_bytes);
  const auto count = scanner.load<std::uint32_t>("");
  const std::uint64_t size = header_bytes + 4 + std::uint64_t{facet_bytes} * count;
  return size == text.size() || !text.starts_with("solid");
}

RawMesh parse_binary(Scanner& scanner) {
  scanner.binary = true;
  scanner.section = "header";
  scanner.bytes(header_bytes, "the header");
  const auto count = scanner.checked_count(scanner.load<std::uint32_t>("the number of facets"),
                                           "number of facets", facet_bytes);
  if (scanner.remaining() != static_cast<std::size_t>(count) * facet_bytes)
    scanner.fail("there are " + std::to_string(count) + " facets according to the header, which take " +
                 std::to_string(count * 50) + " bytes, but " + std::to_string(scanner.remaining()) +
                 " follow; the file is damaged");
  RawMesh raw;
  Vertices vertices(raw);
  for (std::int64_t f = 0; f < count; ++f) {
    scanner.section = "facet " + std::to_string(f);
    scanner.bytes(12, "a normal");
    std::array<int, 3> nodes;
    for (int& n : nodes) {
      const auto* data = scanner.bytes(12, "a vertex").data();
      const auto at = [&](int i) { return static_cast<double>(load<float>(data + 4 * i, scanner.swap())); };
      n = vertices.number(scanner.finite({at(0), at(1), at(2)}));
    }
    scanner.bytes(2, "the attribute");
    raw.add_cell(cell_triangle, nodes);
  }
  return raw;
}

/// Behind "facet" until "endfacet".
void parse_facet(Scanner& scanner, Vertices& vertices, RawMesh& raw) {
  scanner.expect("normal");
  for (int i = 0; i < 3; ++i) scanner.number("a component of the normal");
  scanner.expect("outer");
  scanner.expect("loop");
  std::array<int, 3> nodes;
  for (int& n : nodes) {
    scanner.expect("vertex");
    const double x = scanner.coordinate(), y = scanner.coordinate(), z = scanner.coordinate();
    n = vertices.number({x, y, z});
  }
  scanner.expect("endloop");
  scanner.expect("endfacet");
  raw.add_cell(cell_triangle, nodes);
}

}  // namespace

RawMesh parse_stl(std::string_view text, const std::string& file) {
  Scanner scanner(text, file);
  if (is_binary(text)) return parse_binary(scanner);
  RawMesh raw;
  Vertices vertices(raw);
  scanner.section = "solid";
  while (!scanner.at_end()) {
    const auto first = scanner.token("solid");
    if (!same_word(first, "solid"))
      scanner.fail(quoted(first) +
                   " stands where 'solid' should: this is no STL file, or a binary one that is cut off");
    scanner.line();  // the name
    while (true) {
      const auto word = scanner.token("facet or endsolid");
      if (same_word(word, "endsolid")) break;
      if (!same_word(word, "facet"))
        scanner.fail(quoted(word) + " stands where 'facet' or 'endsolid' should");
      parse_facet(scanner, vertices, raw);
    }
    scanner.line();
  }
  return raw;
}

}  // namespace glisson::detail
