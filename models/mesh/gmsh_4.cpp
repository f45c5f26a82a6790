// Entities, nodes and elements of MSH version 4.1.
#include <cstdlib>

#include <glisson/models/mesh/gmsh.hpp>

namespace glisson::detail {
namespace {

/// A node or element section begins with: number of blocks, number of all items, smallest and largest tag.
struct Totals {
  std::int64_t blocks, items;
};

Totals read_totals(GmshReader& reader, const char* what) {
  Totals totals;
  totals.blocks = reader.count("number of blocks", 8, 12);
  totals.items = reader.count(what, 4, 8);
  reader.size("the smallest tag");
  reader.size("the largest tag");
  return totals;
}

void check_total(const GmshReader& reader, const char* what, std::int64_t found, std::int64_t announced) {
  if (found != announced)
    reader.scanner.fail("the blocks hold " + std::to_string(found) + " " + what + ", but " +
                        std::to_string(announced) + " are announced");
}

void read_node_block(GmshReader& reader) {
  const auto dimension = reader.integer("a dimension");
  reader.integer("the tag of an entity");
  const auto parametric = reader.integer("0 or 1");
  const auto count = reader.count("number of nodes in a block", 8, 24);
  if (dimension < 0 || dimension > 3 || parametric < 0 || parametric > 1)
    reader.scanner.fail("a block of nodes of dimension " + std::to_string(dimension) +
                        " with the parametric flag " + std::to_string(parametric) + " is not possible");
  const auto first = static_cast<int>(reader.raw.X.size());
  for (std::int64_t i = 0; i < count; ++i)
    reader.add_node_tag(reader.size("the tag of a node"), first + static_cast<int>(i));
  for (std::int64_t i = 0; i < count; ++i) {
    reader.read_position();
    for (std::int64_t p = 0; p < parametric * dimension; ++p) reader.real("a parametric coordinate");
  }
}

}  // namespace

/// Of each entity only its physical tag is kept. A negative one means the other orientation of the same
/// group.
void read_entities_4(GmshReader& reader) {
  std::array<std::int64_t, 4> counts;
  for (auto& count : counts) count = reader.count("number of entities", 10, 36);
  for (std::int64_t dimension = 0; dimension < 4; ++dimension)
    for (std::int64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
      const auto tag = reader.integer("the tag of an entity");
      const int numbers = dimension == 0 ? 3 : 6;
      for (int k = 0; k < numbers; ++k) reader.real("a coordinate");
      const auto groups = reader.count("number of physical tags", 2, 4);
      for (std::int64_t g = 0; g < groups; ++g) {
        const auto label = reader.label_of(reader.integer("a physical tag"));
        if (g == 0 && label != 0) reader.physical[{dimension, tag}] = std::abs(label);
      }
      if (dimension == 0) continue;
      const auto bounds = reader.count("number of bounding entities", 2, 4);
      for (std::int64_t b = 0; b < bounds; ++b) reader.integer("the tag of an entity");
    }
}

void read_nodes_4(GmshReader& reader) {
  const auto totals = read_totals(reader, "number of nodes");
  for (std::int64_t b = 0; b < totals.blocks; ++b) read_node_block(reader);
  check_total(reader, "nodes", std::ssize(reader.raw.X), totals.items);
}

void read_elements_4(GmshReader& reader) {
  const auto before = static_cast<std::int64_t>(reader.raw.cell_count());
  const auto totals = read_totals(reader, "number of elements");
  for (std::int64_t b = 0; b < totals.blocks; ++b) {
    const auto dimension = reader.integer("a dimension");
    const auto entity = reader.integer("the tag of an entity");
    const auto type = reader.integer("the type of elements");
    const auto count =
        reader.count("number of elements in a block", 4, 2 * static_cast<std::size_t>(reader.size_bytes));
    const auto group = reader.physical.find({dimension, entity});
    const auto label = group == reader.physical.end() ? entity : group->second;
    for (std::int64_t i = 0; i < count; ++i)
      reader.add_element(reader.size("the tag of an element"), type, label);
  }
  check_total(reader, "elements", static_cast<std::int64_t>(reader.raw.cell_count()) - before, totals.items);
}

}  // namespace glisson::detail
