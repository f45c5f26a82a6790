// Cells of legacy VTK files in both layouts: counts among the nodes, and offsets with connectivity.
#include <glisson/models/mesh/vtk.hpp>

namespace glisson::detail {
namespace {

void add_cell(VtkReader& reader, std::optional<int> code, std::span<const std::int64_t> its_nodes) {
  RawMesh& raw = reader.raw;
  for (const auto n : its_nodes)
    raw.nodes.push_back(reader.scanner.checked_index(n, std::ssize(raw.X), "point"));
  raw.begin.push_back(raw.nodes.size());
  if (code) raw.code.push_back(static_cast<std::uint8_t>(*code));
}

void read_with_counts(VtkReader& reader, std::optional<int> code) {
  Scanner& scanner = reader.scanner;
  const auto count = scanner.integer("the number of cells"), size = scanner.integer("the size of the list");
  const auto entries = reader.integers(reader.room_for(size, 1, NumberType::int32, false, "size of the list"),
                                       NumberType::int32, "a node of a cell");
  if (count < 0 || count > size)
    scanner.fail(std::to_string(count) + " cells cannot stand in a list of " + std::to_string(size) +
                 " numbers");
  std::size_t i = 0;
  for (std::int64_t c = 0; c < count; ++c) {
    const auto left = entries.size() - i;
    if (left == 0 || entries[i] < 0 || static_cast<std::uint64_t>(entries[i]) > left - 1)
      scanner.fail("the list ends within cell " + std::to_string(c) + " of " + std::to_string(count) +
                   "; its size is " + std::to_string(size));
    const auto nodes = static_cast<std::size_t>(entries[i]);
    add_cell(reader, code, std::span(entries).subspan(i + 1, nodes));
    i += 1 + nodes;
  }
  if (i != entries.size())
    scanner.fail("the " + std::to_string(count) + " cells take " + std::to_string(i) +
                 " numbers of the list, but its size is " + std::to_string(size));
}

std::vector<std::int64_t> read_list(VtkReader& reader, const char* keyword, std::int64_t count) {
  Scanner& scanner = reader.scanner;
  auto word = scanner.token(keyword);
  if (same_word(word, "METADATA")) {
    pass_over_metadata(scanner);
    word = scanner.token(keyword);
  }
  if (!same_word(word, keyword)) scanner.fail(quoted(word) + " stands where " + keyword + " should");
  bool is_bit = false;
  const auto type = reader.number_type(is_bit);
  if (!type || is_bit) scanner.fail(std::string(keyword) + " must be whole numbers");
  return reader.integers(reader.room_for(count, 1, *type, false, "size of the list"), *type, keyword);
}

void read_with_offsets(VtkReader& reader, std::optional<int> code) {
  Scanner& scanner = reader.scanner;
  const auto offset_count = scanner.integer("the number of offsets"),
             size = scanner.integer("the size of the connectivity");
  if (offset_count == 0 && size == 0) return;
  const auto offsets = read_list(reader, "OFFSETS", offset_count);
  const auto nodes = read_list(reader, "CONNECTIVITY", size);
  if (offsets.empty() || offsets.front() != 0 || offsets.back() != static_cast<std::int64_t>(nodes.size()))
    scanner.fail("the offsets do not run from 0 to the size of the connectivity, " +
                 std::to_string(nodes.size()));
  for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
    if (offsets[c] < 0 || offsets[c + 1] < offsets[c] ||
        static_cast<std::size_t>(offsets[c + 1]) > nodes.size())
      scanner.fail("the offsets decrease behind cell " + std::to_string(c));
    add_cell(reader, code,
             std::span(nodes).subspan(static_cast<std::size_t>(offsets[c]),
                                      static_cast<std::size_t>(offsets[c + 1] - offsets[c])));
  }
}

}  // namespace

void read_vtk_cells(VtkReader& reader, std::optional<int> code) {
  if (!code && reader.raw.begin.size() > 1) reader.scanner.fail("the cells are there twice");
  if (reader.major >= 5)
    read_with_offsets(reader, code);
  else
    read_with_counts(reader, code);
}

void read_vtk_cell_types(VtkReader& reader) {
  Scanner& scanner = reader.scanner;
  if (!reader.raw.code.empty()) scanner.fail("the types of the cells are there twice");
  const auto count = scanner.integer("the number of cells");
  const auto cells = static_cast<std::int64_t>(reader.raw.begin.size()) - 1;
  if (count != cells)
    scanner.fail("there are " + std::to_string(cells) + " cells, but types for " + std::to_string(count));
  const auto types = reader.integers(reader.room_for(count, 1, NumberType::int32, false, "number of cells"),
                                     NumberType::int32, "the type of a cell");
  for (const auto type : types)
    reader.raw.code.push_back(static_cast<std::uint8_t>(scanner.checked_index(type, 256, "cell type")));
}

}  // namespace glisson::detail
