// What came of a run, for scripts: summary.json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glisson/core/any_simulation.hpp>

namespace glisson {

/// Wall time by phase [s].
struct RunTimings {
  double read = 0, set_up = 0, stepping = 0, output = 0;
  double total() const { return read + set_up + stepping + output; }
};

struct RunSummary {
  std::string status = "running";  ///< running, done, stopped, failed
  std::string message;             ///< of the error; empty without one
  std::string model, units, device;
  std::string device_choice;  ///< what auto chose and why; empty when a device was asked for
  std::string model_file;     ///< empty: the model came from no file
  int node_count = 0, element_count = 0, triangle_count = 0;
  std::int64_t steps = 0;
  double time = 0, total_time = 0;  ///< reached and planned [s]
  StepReport report;
  Energies energies;                  ///< of the last account [J]
  double largest_displacement = 0;    ///< [m]
  int largest_node = -1;              ///< where
  std::array<double, 2> residuals{};  ///< of a quasi-static run [-]
  std::vector<NamedContact> contacts;
  int snapshots = 0;
  std::size_t simulation_bytes = 0, peak_bytes = 0;
  RunTimings timings;
  std::vector<std::string> warnings, files;
};

/// Written atomically.
void write_summary(const std::filesystem::path& path, const RunSummary& summary);

/// Most memory that this process has had [bytes]; 0: not known here.
std::size_t peak_memory();

}  // namespace glisson
