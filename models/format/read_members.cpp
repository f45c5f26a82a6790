// The members of an ensemble: one XML tree, in which the values of each row take their places in turn.
#include <glisson/models/format/parameter_table.hpp>

#include <glisson/models/format/reader.hpp>
#include <glisson/models/format/value_path.hpp>

namespace glisson {
namespace {

Place cell(const ParameterTable& table, std::size_t row, std::size_t column) {
  return {table.file, table.lines[row], "column '" + table.paths[column] + "'"};
}

std::vector<detail::ValueTarget> targets_of(detail::XmlElement& root, const ParameterTable& table) {
  std::vector<detail::ValueTarget> targets;
  for (std::size_t c = 0; c < table.paths.size(); ++c) {
    const detail::ValueTarget target(root, table.paths[c], {table.file, 1, ""});
    for (std::size_t before = 0; before < c; ++before)
      if (targets[before] == target)
        throw Error(ErrorKind::input,
                    "the columns '" + table.paths[before] + "' and '" + table.paths[c] +
                        "' are the same value of the simulation file; keep one",
                    {table.file, 1, ""});
    targets.push_back(target);
  }
  return targets;
}

}  // namespace

std::vector<Model> read_members(const std::string& simulation_file, const ParameterTable& table,
                                const ReadOptions& options) {
  detail::XmlDocument document;
  detail::read_document(simulation_file, document);
  auto targets = targets_of(document.root, table);
  std::vector<Model> members;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (std::size_t c = 0; c < targets.size(); ++c) targets[c].set(table.rows[row][c], cell(table, row, c));
    try {
      members.push_back(detail::model_of(document, simulation_file, options));
      for (auto& warning : validate(members.back()))
        if (options.warnings != nullptr) options.warnings->push_back(std::move(warning));
    } catch (const Error& error) {
      throw Error(error.kind(), "member " + std::to_string(row) + ": " + error.what(),
                  {table.file, table.lines[row], ""});
    }
  }
  return members;
}

}  // namespace glisson
