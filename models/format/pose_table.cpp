#include <glisson/models/format/pose_table.hpp>

#include <glisson/core/base/number_text.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

namespace glisson::detail {
namespace {

enum class TurnColumns { none, vector, quaternion };

struct Row {
  int line;
  std::vector<double> values;
};

std::size_t columns(TurnColumns turn) {
  return turn == TurnColumns::none ? 4 : turn == TurnColumns::vector ? 7 : 8;
}
std::string columns_text(TurnColumns turn) {
  const std::string first = std::to_string(columns(turn)) + ": time x y z";
  if (turn == TurnColumns::none) return first;
  return first + (turn == TurnColumns::vector ? " and a rotation vector (rx ry rz)"
                                              : " and a unit quaternion (qw qx qy qz)");
}

/// What a table is read from, for messages.
class TablePlace {
 public:
  explicit TablePlace(Place place) : place_(std::move(place)) {}
  [[noreturn]] void fail(int line, const std::string& message) const {
    Place at = place_;
    at.line = line;
    throw Error(ErrorKind::input, message, std::move(at));
  }

 private:
  Place place_;
};

std::vector<Row> inline_rows(const XmlElement& table, TurnColumns turn) {
  std::vector<Row> rows;
  for (const XmlText& chunk : table.texts)
    for_each_token(chunk, [&](std::string_view token, int line) {
      const auto value = to_number(token);
      if (!value) table.fail(line, "'" + std::string(token.substr(0, 40)) + "' is not a finite number");
      if (rows.empty() || rows.back().values.size() == columns(turn)) rows.push_back({line, {}});
      rows.back().values.push_back(*value);
    });
  if (!rows.empty() && rows.back().values.size() != columns(turn))
    table.fail(rows.back().line, "its last row holds " + std::to_string(rows.back().values.size()) +
                                     " numbers, but a row of this table has " + columns_text(turn));
  return rows;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\"\f\v";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// At semicolons, else at commas, else at blanks.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  const bool semicolons = line.find(';') != std::string::npos;
  if (!semicolons && line.find(',') == std::string::npos) {
    for_each_token(XmlText{line, 1}, [&](std::string_view token, int) { fields.emplace_back(token); });
    return fields;
  }
  for (std::size_t begin = 0;;) {
    const auto end = line.find(semicolons ? ';' : ',', begin);
    fields.emplace_back(trimmed(std::string_view(line).substr(begin, end - begin)));
    if (end == std::string::npos) return fields;
    begin = end + 1;
  }
}

/// Names of columns: the first of them begins with a letter and is no number that is not finite.
bool is_header(const std::vector<std::string>& fields) {
  const std::string first = lower(fields[0]);
  return !first.empty() && first[0] >= 'a' && first[0] <= 'z' && first.substr(0, 3) != "nan" &&
         first.substr(0, 3) != "inf";
}

/// Many tools write the real part of a quaternion last.
void check_header(const std::vector<std::string>& names, TurnColumns turn, const TablePlace& place,
                  int line) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (turn == TurnColumns::quaternion && (lower(names[i]) == "qw" || lower(names[i]) == "w") && i != 4)
      place.fail(line, "column " + std::to_string(i + 1) + " is called '" + names[i] +
                           "', but a row of this table has " + columns_text(turn) +
                           ": the real part comes first");
}

Row row_of(const std::vector<std::string>& fields, TurnColumns turn, const TablePlace& place, int line) {
  if (fields.size() != columns(turn))
    place.fail(line, "it has " + std::to_string(fields.size()) + " columns, but a row of this table has " +
                         columns_text(turn));
  Row row{line, {}};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto value = to_number(fields[i]);
    if (!value)
      place.fail(line, "column " + std::to_string(i + 1) + " holds '" + fields[i].substr(0, 40) +
                           "', which is not a finite number");
    row.values.push_back(*value);
  }
  return row;
}

/// One row a line; blank lines and what follows a # are left out, names of columns may stand first.
std::vector<Row> rows_of_text(const std::string& text, TurnColumns turn, const TablePlace& place) {
  std::vector<Row> rows;
  std::istringstream stream(text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0));
  bool first = true;
  std::string content;
  for (int line = 1; std::getline(stream, content); ++line) {
    content.erase(std::min(content.find('#'), content.size()));
    if (trimmed(content).empty()) continue;
    const auto fields = fields_of(content);
    if (std::exchange(first, false) && is_header(fields))
      check_header(fields, turn, place, line);
    else
      rows.push_back(row_of(fields, turn, place, line));
  }
  return rows;
}

RigidPose pose_of(const Row& row, TurnColumns turn, const TablePlace& place) {
  const auto& v = row.values;
  RigidPose pose{v[0], {v[1], v[2], v[3]}, {1, 0, 0, 0}};
  if (turn == TurnColumns::vector) pose.turn = quaternion_of({v[4], v[5], v[6]});
  if (turn == TurnColumns::quaternion) {
    pose.turn = {v[4], v[5], v[6], v[7]};
    const double length = length_of(pose.turn);
    if (!(std::abs(length - 1) < 1e-3))  // rounded to four digits by who wrote it
      place.fail(row.line, "its quaternion has the length " + number_text(length) +
                               ", but a rotation has 1; the order is w x y z");
    for (double& part : pose.turn) part /= length;
  }
  return pose;
}

/// Rotation vectors may say more than half a turn, but poses do not.
double turned(const Row& before, const Row& row, const RigidPose& a, const RigidPose& b, TurnColumns turn) {
  const double least = angle_between(a.turn, b.turn);
  if (turn != TurnColumns::vector) return least;
  const auto length = [](const Row& its) { return std::hypot(its.values[4], its.values[5], its.values[6]); };
  return std::max(least, std::abs(length(row) - length(before)));
}

void check_step(const Row& before, const Row& row, const RigidPose& a, const RigidPose& b, TurnColumns turn,
                const TablePlace& place) {
  if (!(b.time > a.time))
    place.fail(row.line, "the times must increase, but " + number_text(b.time) + " does not come after " +
                             number_text(a.time));
  if (turned(before, row, a, b, turn) > std::numbers::pi - 1e-6)
    place.fail(row.line, "from time " + number_text(a.time) + " to " + number_text(b.time) +
                             " it turns by half a turn or more, so it is not clear which way; add a row "
                             "in between");
}

std::vector<RigidPose> poses_of(const std::vector<Row>& rows, TurnColumns turn, const TablePlace& place,
                                int line) {
  if (rows.size() < 2)
    place.fail(line, "it holds " + std::to_string(rows.size()) + (rows.size() == 1 ? " row" : " rows") +
                         ", but a motion needs two or more; a row has " + columns_text(turn));
  std::vector<RigidPose> poses;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    poses.push_back(pose_of(rows[i], turn, place));
    if (i > 0) check_step(rows[i - 1], rows[i], poses[i - 1], poses[i], turn, place);
  }
  return poses;
}

TurnColumns turn_columns(const XmlElement& motion) {
  const auto attribute = motion.attribute("Rotation");
  if (attribute == nullptr || attribute->value == "Vector") return TurnColumns::vector;
  return attribute->value == "None" ? TurnColumns::none : TurnColumns::quaternion;
}

void refuse_others(const XmlElement& motion) {
  for (const auto name : {"LoadShape", "StartTime", "EndTime"})
    if (const auto attribute = motion.attribute(name))
      motion.fail(attribute->line, std::string(name) +
                                       " has no meaning beside Type=\"Poses\", whose rows "
                                       "have their own times; remove it");
  if (motion.has_text())
    motion.fail("numbers stand in it; rows of poses belong into <Table> or a file named by <TableFile>");
  if (const auto table = motion.child("Table"); table != nullptr && motion.child("TableFile") != nullptr)
    table->fail("a second table: <TableFile> is there too; keep one of them");
}

}  // namespace

std::vector<RigidPose> read_poses(const Reader& reader, const XmlElement& motion) {
  refuse_others(motion);
  const TurnColumns turn = turn_columns(motion);
  if (const auto named = motion.child("TableFile")) {
    const FileText file = reader.text_in_file(*named, named->required_text());
    const TablePlace place({file.path, 0, ""});
    return poses_of(rows_of_text(file.text, turn, place), turn, place, 0);
  }
  const XmlElement& table = motion.required_child("Table");
  return poses_of(inline_rows(table, turn), turn, TablePlace(table.place()), table.line);
}

}  // namespace glisson::detail
