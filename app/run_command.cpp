// glisson run: reads a file, drives the run, prints what came of it.
#include <fmt/core.h>

#include <atomic>
#include <cmath>
#include <csignal>

#include <glisson/app/commands.hpp>
#include <glisson/app/export_end.hpp>
#include <glisson/app/print_results.hpp>
#include <glisson/app/progress_line.hpp>
#include <glisson/app/read_input.hpp>
#include <glisson/core/base/error.hpp>

namespace glisson::app {
namespace {

std::atomic<bool> stop_wanted{false};

/// The first signal asks for a checkpoint and an end; the second one ends the process as usual.
void ask_to_stop(int signal) {
  stop_wanted.store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);
}

class Console {
 public:
  Console(LogLevel level, bool quiet)
      : level_(quiet ? LogLevel::error : level), line_(!quiet && level >= LogLevel::info) {}

  void log(LogLevel level, const std::string& text) {
    if (level > level_) return;
    line_.clear();
    if (level <= LogLevel::warning)
      fmt::print(stderr, "{}: {}\n", level == LogLevel::error ? "error" : "warning", text);
    else
      fmt::print("{}\n", text);
  }
  void progress(const Progress& progress) { line_.show(progress); }
  void clear() { line_.clear(); }

 private:
  LogLevel level_;
  ProgressLine line_;
};

void print_header(Console& console, const CheckedModel& input) {
  const Mesh& mesh = input.model.mesh;
  console.log(
      LogLevel::info,
      fmt::format("{}: {} nodes, {} elements{}, read in {}", input.model.name, mesh.node_count(),
                  mesh.element_count(),
                  mesh.triangles.empty() ? "" : fmt::format(", {} shell triangles", mesh.triangles.size()),
                  duration_text(input.seconds)));
  for (const auto& warning : input.warnings) console.log(LogLevel::warning, warning);
}

RunnerOptions runner_options(const RunArguments& arguments, const CheckedModel& input, Console& console) {
  RunnerOptions options;
  options.directory = arguments.directory.empty() ? "results/" + input.model.name : arguments.directory;
  options.text_prefix = arguments.text_prefix;
  options.simulation = arguments.simulation;
  options.model_file = std::filesystem::absolute(arguments.file).string();
  options.simulation.validated = true;
  options.resume = arguments.resume;
  options.checkpoint_seconds = 60 * arguments.checkpoint_minutes;
  options.read_seconds = input.seconds;
  options.warnings = input.warnings;
  options.stop = &stop_wanted;
  options.progress = [&console](const Progress& progress) { console.progress(progress); };
  options.log = [&console](LogLevel level, const std::string& text) { console.log(level, text); };
  return options;
}

void print_stopped(const RunSummary& summary, const RunnerOptions& options) {
  fmt::print(
      stderr,
      "stopped at step {} (t = {:.6g} s). Go on with the same command and --resume; the checkpoint is {}\n",
      summary.steps, summary.time, (options.directory / "checkpoint.glisson").string());
}

}  // namespace

int run(const RunArguments& arguments) {
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  if (!arguments.table.empty())
    return in_file(arguments.file, [&] { return run_table(arguments, stop_wanted); });
  Console console(arguments.log_level, arguments.quiet);
  const CheckedModel input = read_and_validate(arguments.file, arguments.lenient);
  print_header(console, input);
  check_exports(arguments, input.model);
  const RunnerOptions options = runner_options(arguments, input, console);
  Runner runner(input.model, options);
  const bool done = in_file(arguments.file, [&] { return runner.run(); });
  console.clear();
  const RunSummary& summary = runner.summary();
  if (!done) {
    print_stopped(summary, options);
    return exit_interrupted;
  }
  if (!arguments.quiet && arguments.log_level >= LogLevel::info) print_summary(summary);
  if (arguments.execution_time) fmt::print("Execution time: {:.0f} ms\n", 1e3 * summary.timings.stepping);
  for (const auto& what : arguments.print) print_result(what, input.model, runner.simulation(), summary);
  export_end(arguments, input.model, runner.simulation());
  if (arguments.plot) show_end(summary.files.front());
  const bool converged =
      summary.report.ending.empty() || summary.report.ending.rfind("not converged", 0) != 0;
  if (converged) return exit_done;
  fmt::print(stderr, "error: {}\n", summary.report.ending);
  return static_cast<int>(ErrorKind::run);
}

}  // namespace glisson::app
