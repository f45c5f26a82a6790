// Sheets of triangles that bench runs: membranes and shells, held at the border and pushed in the middle.
#pragma once

#include <string>
#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::app {

struct SheetCase {
  ShellFormulation formulation = ShellFormulation::membrane;
  std::string law = "NeoHookean";
  std::vector<double> parameters{2000};
};

/// About `triangles` triangles of an irregular, wavy sheet of 10 cm by 10 cm; `total_time` is longer than any
/// bench.
Model sheet_model(const SheetCase& c, int triangles, double total_time);

}  // namespace glisson::app
