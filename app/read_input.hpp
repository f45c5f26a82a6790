// Reading and checking a simulation file as run, check and info do it.
#pragma once

#include <string>
#include <vector>

#include <glisson/core/base/error.hpp>
#include <glisson/core/model.hpp>

namespace glisson::app {

struct CheckedModel {
  Model model;
  std::vector<std::string> warnings;
  double seconds = 0;  ///< that it took
};

/// Throws Error(input) for what cannot be read or simulated.
CheckedModel read_and_validate(const std::string& file, bool lenient);

/// Runs body(); an Error(input) without a place gets the file's name.
template <class Body>
auto in_file(const std::string& file, Body&& body) {
  try {
    return body();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input || !error.place().file.empty()) throw;
    throw Error(error.kind(), error.what(), {file, 0, ""});  // the text names the element already
  }
}

/// "12.3 MB", "850 kB".
std::string bytes_text(double bytes);
/// "0.42 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace glisson::app
