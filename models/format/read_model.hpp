// Reads a simulation file (the NiftySim 2.5 XML format and Glisson's additions, doc/format.md) into a Model.
#pragma once

#include <glisson/core/model.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace glisson {

struct ReadOptions {
  bool lenient = false;     ///< unknown names and repeated elements give a warning instead of an error
  bool allow_files = true;  ///< false: a mesh or value file named in the XML is an error
  std::vector<std::string>* warnings = nullptr;  ///< gets one line per warning; nullptr: dropped
};

/// Throws Error(input) with file and line. The model is complete but not yet checked by validate().
Model read_model(const std::string& path, const ReadOptions& options = {});

/// The same from memory. `file_name` is used in messages, for relative paths and for the model's name.
Model parse_model(std::string_view xml, const std::string& file_name, const ReadOptions& options = {});

/// Every element and attribute name that a simulation file may contain, sorted, each once.
std::vector<std::string> known_names();

/// The XML schema for editors, generated from the table of names (models/format/glisson.xsd is its output).
std::string make_xsd();

}  // namespace glisson
