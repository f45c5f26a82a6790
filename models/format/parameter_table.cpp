#include <glisson/models/format/parameter_table.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>

#include <glisson/core/base/error.hpp>

namespace glisson {
namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto first = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(first);
  text = text.substr(0, text.find_last_not_of(blanks) + 1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return std::string(text);
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  while (true) {
    const auto comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

[[noreturn]] void fail(const ParameterTable& table, int line, const std::string& message) {
  throw Error(ErrorKind::input, message, {table.file, line, ""});
}

void set_header(ParameterTable& table, std::vector<std::string> cells, int line) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].empty())
      fail(table, line, "column " + std::to_string(c + 1) + " has no name; write the path of a value there");
    const auto before = std::find(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(c), cells[c]);
    if (before != cells.begin() + static_cast<std::ptrdiff_t>(c))
      fail(table, line, "the column '" + cells[c] + "' is there twice; keep one");
  }
  table.paths = std::move(cells);
}

void add_row(ParameterTable& table, std::vector<std::string> cells, int line) {
  if (cells.size() != table.paths.size())
    fail(table, line,
         "the row has " + std::to_string(cells.size()) + " values, the header " +
             std::to_string(table.paths.size()) + " columns; give one value for each");
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (cells[c].empty()) fail(table, line, "the value of column '" + table.paths[c] + "' is empty");
  table.rows.push_back(std::move(cells));
  table.lines.push_back(line);
}

}  // namespace

ParameterTable parse_parameter_table(std::string_view text, const std::string& file) {
  ParameterTable table;
  table.file = file;
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);  // as spreadsheets write it
  for (int line = 1; !text.empty(); ++line) {
    const auto end = std::min(text.find('\n'), text.size());
    const auto content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (content.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (table.paths.empty())
      set_header(table, cells_of(content), line);
    else
      add_row(table, cells_of(content), line);
  }
  if (table.rows.empty())
    fail(table, 0, "the table has no rows; write a header of paths and one row of values for each member");
  return table;
}

ParameterTable read_parameter_table(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || !text)
    throw Error(ErrorKind::input, "the table '" + file + "' cannot be read; check its name and permissions");
  return parse_parameter_table(text.view(), file);
}

}  // namespace glisson
