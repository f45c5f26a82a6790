// Drives a simulation from its start or a checkpoint to its end and writes what the model asks for:
// snapshots, history, text files, summary and checkpoints. Talks only through callbacks.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glisson/run/make_simulation.hpp>
#include <glisson/run/summary.hpp>

namespace glisson {

enum class LogLevel { error, warning, info, debug };

struct Progress {
  std::int64_t step = 0, planned = 0;  ///< planned: 0 in a quasi-static run
  double time = 0;                     ///< [s] of the simulation
  double steps_per_second = 0;
  std::optional<double> seconds_left;
};

struct RunnerOptions {
  std::filesystem::path directory = "results";  ///< made if need be
  std::optional<std::string> text_prefix;       ///< of U.txt and its like; empty: in the directory
  SimulationOptions simulation;
  std::string model_file;                         ///< that the model was read from, for the summary
  bool resume = false;                            ///< go on from the checkpoint in the directory
  double checkpoint_seconds = 600;                ///< wall time between checkpoints; 0: only when stopped
  double read_seconds = 0;                        ///< that reading the model took, for the summary
  std::vector<std::string> warnings;              ///< from reading and checking the model, for the summary
  const std::atomic<bool>* stop = nullptr;        ///< set by anyone: the run ends with a checkpoint
  std::function<void(const Progress&)> progress;  ///< a few times per second
  std::function<void(LogLevel, const std::string&)> log;
};

class Runner {
 public:
  /// The model must outlive the runner.
  Runner(const Model& model, RunnerOptions options);
  ~Runner();

  /// True when the run reached its end, false when it was stopped. A failed run throws Error(run) after its
  /// summary was written; snapshots before the failure stay.
  bool run();

  const AnySimulation& simulation() const { return *simulation_; }
  const RunSummary& summary() const { return summary_; }

 private:
  struct Files;
  bool run_to_end();
  void prepare();
  void open_files();
  bool advance_to_end();
  std::int64_t steps_until_event() const;
  void append_history(const AccountReport& account);
  void snapshot(bool text);
  void checkpoint();
  void look_for_overlap();
  void finish(const std::string& status, const std::string& message);
  void update_summary();
  void note_progress();
  void log(LogLevel level, const std::string& text) const;
  bool stop_wanted() const { return options_.stop && options_.stop->load(std::memory_order_relaxed); }

  const Model& model_;
  RunnerOptions options_;
  std::unique_ptr<AnySimulation> simulation_;
  std::unique_ptr<Files> files_;
  RunSummary summary_;
  std::uint64_t hash_ = 0;                          ///< of the model
  std::int64_t chunk_ = 1;                          ///< steps in one call
  double stepping_before_ = 0;                      ///< wall time in steps before this process [s]
  std::int64_t first_step_ = 0;                     ///< of this process
  double last_progress_ = 0, last_checkpoint_ = 0;  ///< wall clock [s]
};

}  // namespace glisson
