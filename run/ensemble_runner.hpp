// Drives an ensemble to its end and writes one row per member and the last state of each.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glisson/models/format/parameter_table.hpp>
#include <glisson/run/make_ensemble.hpp>

namespace glisson {

struct EnsembleProgress {
  int running = 0, finished = 0, failed = 0;
};

struct EnsembleRunOptions {
  std::filesystem::path directory = "results";  ///< made if need be
  SimulationOptions simulation;
  const std::atomic<bool>* stop = nullptr;                ///< set by anyone: the run ends with what it has
  std::function<void(const EnsembleProgress&)> progress;  ///< about once per second
};

/// What came of a run: the ensemble and where it stood at the end.
struct EnsembleResult {
  std::unique_ptr<AnyEnsemble> ensemble;
  bool stopped = false;
  int failed = 0;
  double seconds = 0;  ///< in steps
  std::string table_file;
};

/// Writes DIRECTORY/ensemble.csv (parameters, status, steps, largest displacement, energies, message of each
/// member) and DIRECTORY/member-K.vtu for each member that ran to its end. Throws Error(run) when a file
/// cannot be written.
EnsembleResult run_ensemble(std::vector<Model> members, const ParameterTable& table,
                            const EnsembleRunOptions& options);

}  // namespace glisson
