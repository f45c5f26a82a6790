// A table of parameters over a simulation file: each row is a member of an ensemble, each column a value of
// the file (doc/ensembles.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glisson/models/format/read_model.hpp>

namespace glisson {

/// A comma-separated file: a header of paths, then one row of values per member.
struct ParameterTable {
  std::string file;
  std::vector<std::string> paths;
  std::vector<std::vector<std::string>> rows;  ///< [member][column]
  std::vector<int> lines;                      ///< of each row in the file, from 1  [member]
};

/// Throws Error(input) with file, line and column: no rows, a row of another length, an empty or repeated
/// path, an empty value.
ParameterTable parse_parameter_table(std::string_view text, const std::string& file);
ParameterTable read_parameter_table(const std::string& file);

/// The model of every row: the simulation file with the values of the table in place. Throws Error(input)
/// when a path names nothing (with what is there), or more than one thing, or what another column has; when a
/// value is not a finite number; and for whatever is wrong with a member's model, naming its row.
std::vector<Model> read_members(const std::string& simulation_file, const ParameterTable& table,
                                const ReadOptions& options = {});

}  // namespace glisson
