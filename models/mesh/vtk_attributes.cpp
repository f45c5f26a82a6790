// Point and cell data of legacy VTK files.
#include <charconv>

#include <glisson/models/mesh/vtk.hpp>

namespace glisson::detail {
namespace {

/// Names are coded like addresses: "shear%20modulus".
std::string decoded(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size() && text.size() < 200; ++i) {
    unsigned code = 0;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(name.data() + i + 1, name.data() + i + 3, code, 16).ptr == name.data() + i + 3) {
      text += static_cast<char>(code);
      i += 2;
    } else {
      text += name[i];
    }
  }
  return text;
}

/// Strings cannot become arrays of numbers. As text each has a line; as bytes each has its length before it,
/// whose two highest bits say how many bytes the length takes.
void pass_over_strings(Scanner& scanner, std::int64_t count) {
  scanner.line();
  for (std::int64_t i = 0; i < count; ++i) {
    if (!scanner.binary) {
      if (scanner.remaining() == 0) scanner.fail("the file ends within strings; it is truncated");
      scanner.line();
      continue;
    }
    const auto first = static_cast<unsigned char>(scanner.bytes(1, "a string")[0]);
    const int more = first >> 6 == 3 ? 0 : first >> 6 == 2 ? 1 : first >> 6 == 1 ? 3 : 7;
    std::uint64_t length = first & 63u;
    for (const char c : scanner.bytes(static_cast<std::uint64_t>(more), "a string"))
      length = length << 8 | static_cast<unsigned char>(c);
    scanner.bytes(length, "a string");
  }
}

NamedArray read_array(VtkReader& reader, std::int64_t tuples, std::int64_t components) {
  bool is_bit = false;
  const auto type = reader.number_type(is_bit);
  if (!type) reader.scanner.fail("strings cannot stand here");
  const auto count = reader.room_for(tuples, components, *type, is_bit, "number of tuples");
  return {static_cast<int>(components), reader.numbers(count, *type, is_bit, "a value")};
}

void read_field(VtkReader& reader, std::int64_t tuples, std::map<std::string, NamedArray>& arrays) {
  Scanner& scanner = reader.scanner;
  scanner.token("the name of the field");
  const auto count = scanner.count("number of arrays", 4);
  for (std::int64_t i = 0; i < count; ++i) {
    auto name = scanner.token("the name of an array");
    if (same_word(name, "METADATA")) {
      pass_over_metadata(scanner);
      name = scanner.token("the name of an array");
    }
    if (name == "NULL_ARRAY") continue;
    const auto components = scanner.integer("the number of components"),
               rows = scanner.integer("the number of tuples");
    if (tuples >= 0 && rows != tuples)
      scanner.fail("array " + quoted(name) + " has " + std::to_string(rows) + " tuples, but " +
                   std::to_string(tuples) + " are needed");
    bool is_bit = false;
    const auto type = reader.number_type(is_bit);
    if (components < 1 && rows != 0)
      scanner.fail(std::to_string(components) + " components are not possible");
    if (!type) {
      scanner.checked_count(rows, "number of tuples",
                            static_cast<std::size_t>(std::clamp<std::int64_t>(components, 1, 1'000'000)));
      pass_over_strings(scanner, rows * std::min<std::int64_t>(components, 1'000'000));
      continue;
    }
    const auto size = reader.room_for(rows, components, *type, is_bit, "number of tuples");
    NamedArray array{static_cast<int>(components), reader.numbers(size, *type, is_bit, "a value")};
    if (tuples >= 0 && components > 0) arrays[decoded(name)] = std::move(array);
  }
}

/// SCALARS name type [components], then LOOKUP_TABLE name, which old writers leave out.
void read_scalars(VtkReader& reader, std::int64_t tuples, std::map<std::string, NamedArray>& arrays) {
  Scanner& scanner = reader.scanner;
  const auto name = decoded(scanner.token("a name"));
  bool is_bit = false;
  const auto type = reader.number_type(is_bit);
  if (!type) scanner.fail("strings cannot stand here");
  std::int64_t components = 1;
  if (const auto token = scanner.token_in_line())
    components = scanner.integer_of(*token, "the number of components");
  if (components < 1) scanner.fail(std::to_string(components) + " components are not possible");
  const auto ahead = scanner.rest();
  const auto start = std::min(ahead.find_first_not_of(" \t\r\n"), ahead.size());
  if (same_word(ahead.substr(start, 12), "LOOKUP_TABLE")) {
    scanner.token("LOOKUP_TABLE");
    scanner.token("the name of a table");
  }
  const auto count = reader.room_for(tuples, components, *type, is_bit, "number of tuples");
  arrays[name] = {static_cast<int>(components), reader.numbers(count, *type, is_bit, "a value")};
}

/// Colours: bytes in binary files, numbers from 0 to 1 in text files.
NamedArray read_colours(VtkReader& reader, std::int64_t tuples, std::int64_t components) {
  const auto type = reader.scanner.binary ? NumberType::uint8 : NumberType::float32;
  const auto count = reader.room_for(tuples, components, type, false, "number of colours");
  return {static_cast<int>(components), reader.numbers(count, type, false, "a colour")};
}

}  // namespace

bool read_vtk_attribute(VtkReader& reader, std::string_view keyword, std::int64_t count,
                        std::map<std::string, NamedArray>& arrays) {
  Scanner& scanner = reader.scanner;
  const auto is = [keyword](const char* word) { return same_word(keyword, word); };
  if (is("FIELD")) {
    read_field(reader, count, arrays);
    return true;
  }
  if (count < 0) return false;
  if (is("SCALARS")) {
    read_scalars(reader, count, arrays);
    return true;
  }
  const bool coloured = is("COLOR_SCALARS"), table = is("LOOKUP_TABLE"), texture = is("TEXTURE_COORDINATES");
  const std::int64_t components = is("VECTORS") || is("NORMALS")           ? 3
                                  : is("TENSORS")                          ? 9
                                  : is("TENSORS6")                         ? 6
                                  : is("GLOBAL_IDS") || is("PEDIGREE_IDS") ? 1
                                                                           : 0;
  if (!coloured && !table && !texture && components == 0) return false;
  const auto name = decoded(scanner.token("a name"));
  if (table) {
    read_colours(reader, scanner.integer("the size of the table"), 4);
  } else if (coloured) {
    arrays[name] = read_colours(reader, count, scanner.count("number of components", 1));
  } else {
    arrays[name] = read_array(reader, count, texture ? scanner.count("number of components", 1) : components);
  }
  if (const auto array = arrays.find(name); array != arrays.end() && array->second.components < 1)
    scanner.fail("0 components are not possible");
  return true;
}

}  // namespace glisson::detail
