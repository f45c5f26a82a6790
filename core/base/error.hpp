// The one exception type of the library. Its text follows one grammar: place, what is wrong, why, what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace glisson {

/// Whose mistake it is; the command line turns it into its exit code.
enum class ErrorKind {
  run = 1,     ///< the simulation failed: diverged, energy balance lost, disk full
  usage = 2,   ///< the caller asked for something that does not exist
  input = 3,   ///< a file or a parameter is wrong
  device = 4,  ///< the device asked for is not there or not usable
};

/// Where in the user's input the problem lies; empty members are unknown.
struct Place {
  std::string file;     ///< path as the user gave it
  int line = 0;         ///< 1-based; 0: unknown
  std::string element;  ///< XML element, mesh section, "element 17", "byte 1024", ...
};

/// "file:line: element: message" with the unknown parts left out.
inline std::string located(const Place& place, const std::string& message) {
  std::string text = place.file;
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (!text.empty()) text += ": ";
  if (!place.element.empty()) text += place.element + ": ";
  return text + message;
}

/// Every failure that a caller can meet. what() is complete and needs no other context.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message, Place place = {})
      : std::runtime_error(located(place, message)), kind_(kind), place_(std::move(place)) {}

  ErrorKind kind() const { return kind_; }
  const Place& place() const { return place_; }

 private:
  ErrorKind kind_;
  Place place_;
};

}  // namespace glisson
