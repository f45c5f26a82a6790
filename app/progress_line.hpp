// One line on a terminal that says how far a run is; nothing anywhere else.
#pragma once

#include <glisson/run/runner.hpp>

namespace glisson::app {

class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine() { clear(); }
  void show(const Progress& progress);
  /// Removes the line, so that other text can be printed.
  void clear();

 private:
  bool on_;
  bool shown_ = false;
};

}  // namespace glisson::app
