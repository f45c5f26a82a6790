// Nodes and elements of MSH version 2.
#include <glisson/models/mesh/gmsh.hpp>

namespace glisson::detail {
namespace {

/// The first tag is the physical one, the second the elementary one; a physical tag of 0 means none.
std::int64_t label_from_tags(GmshReader& reader, std::int64_t tag_count) {
  std::int64_t label = 0;
  for (std::int64_t i = 0; i < tag_count; ++i) {
    const auto tag = reader.integer("a tag");
    if (i == 0 || (i == 1 && label == 0)) label = tag;
  }
  return label;
}

std::int64_t read_tag_count(GmshReader& reader) {
  const auto count = reader.integer("the number of tags");
  return reader.scanner.checked_count(count, "number of tags", reader.scanner.binary ? 4 : 2);
}

}  // namespace

void read_nodes_2(GmshReader& reader) {
  const auto count = reader.scanner.count("number of nodes", 8);
  if (reader.scanner.binary) reader.scanner.line();
  for (std::int64_t n = 0; n < count; ++n) {
    reader.add_node_tag(reader.integer("the number of a node"), static_cast<int>(n));
    reader.read_position();
  }
}

void read_elements_2(GmshReader& reader) {
  Scanner& scanner = reader.scanner;
  const auto count = scanner.count("number of elements", 8);
  if (scanner.binary) scanner.line();
  std::int64_t done = 0;
  while (done < count) {
    if (!scanner.binary) {
      const auto tag = scanner.integer("the number of an element"),
                 type = scanner.integer("the type of an element");
      reader.add_element(tag, type, label_from_tags(reader, read_tag_count(reader)));
      ++done;
      continue;
    }
    const auto type = reader.integer("the type of elements");
    const auto block =
        scanner.checked_count(reader.integer("the number of elements"), "number of elements in a block", 4);
    if (block == 0 || block > count - done)
      scanner.fail("a block of " + std::to_string(block) + " elements, where " +
                   std::to_string(count - done) + " are still to come");
    const auto tag_count = read_tag_count(reader);
    for (std::int64_t i = 0; i < block; ++i) {
      const auto tag = reader.integer("the number of an element");
      reader.add_element(tag, type, label_from_tags(reader, tag_count));
    }
    done += block;
  }
}

}  // namespace glisson::detail
