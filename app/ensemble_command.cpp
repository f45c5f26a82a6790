// glisson run --ensemble TABLE FILE: one member per row of the table.
#include <fmt/core.h>

#include <filesystem>

#include <glisson/app/commands.hpp>
#include <glisson/app/read_input.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/run/ensemble_runner.hpp>

namespace glisson::app {
namespace {

void refuse(bool wrong, const char* what) {
  if (wrong) throw Error(ErrorKind::usage, std::string(what) + " does not go with --ensemble. Leave it out.");
}

bool not_converged(const AnySimulation& member) {
  return member.report().ending.rfind("not converged", 0) == 0;
}

/// Names what went wrong; returns the exit code.
int report_failures(AnyEnsemble& ensemble) {
  int wrong = 0;
  for (int k = 0; k < ensemble.member_count(); ++k) {
    const bool failed = ensemble.status(k) == MemberStatus::failed;
    if (!failed && !not_converged(ensemble.member(k))) continue;
    ++wrong;
    fmt::print(stderr, "error: member {}: {}\n", k,
               failed ? ensemble.error(k) : ensemble.member(k).report().ending);
  }
  return wrong > 0 ? static_cast<int>(ErrorKind::run) : exit_done;
}

}  // namespace

int run_table(const RunArguments& arguments, const std::atomic<bool>& stop) {
  refuse(arguments.resume, "--resume");
  refuse(arguments.text_prefix.has_value(), "--output-prefix");
  refuse(!arguments.export_mesh.empty(), "--export-mesh");
  refuse(!arguments.export_membrane.empty(), "--export-membrane");
  refuse(!arguments.print.empty(), "--print");
  const bool talk = !arguments.quiet && arguments.log_level >= LogLevel::info;
  const ParameterTable table = read_parameter_table(arguments.table);
  std::vector<std::string> warnings;
  ReadOptions reading;
  reading.lenient = arguments.lenient;
  reading.warnings = &warnings;
  std::vector<Model> members = read_members(arguments.file, table, reading);
  const std::string name = members[0].name;
  const auto elements = members[0].mesh.element_count();
  if (talk) fmt::print("{}: {} members of {} elements\n", name, members.size(), elements);
  if (!arguments.quiet && !warnings.empty())
    fmt::print(stderr, "warning: {} (and {} more for all members)\n", warnings[0], warnings.size() - 1);
  EnsembleRunOptions options;
  options.directory = arguments.directory.empty() ? "results/" + name : arguments.directory;
  options.simulation = arguments.simulation;
  options.stop = &stop;
  if (talk)
    options.progress = [](const EnsembleProgress& p) {
      fmt::print(stderr, "{} members running, {} done, {} failed\n", p.running, p.finished, p.failed);
    };
  const EnsembleResult result = run_ensemble(std::move(members), table, options);
  if (talk) {
    std::int64_t steps = 0;
    for (int k = 0; k < result.ensemble->member_count(); ++k)
      if (result.ensemble->status(k) != MemberStatus::failed)
        steps += result.ensemble->member(k).step_count();
    fmt::print(
        "device {}\n{} steps of all members in {}, {:.2f} ns per element, step and member\nwritten: {}\n",
        result.ensemble->device(), steps, duration_text(result.seconds),
        1e9 * result.seconds / static_cast<double>(std::max<std::int64_t>(1, steps)) / elements,
        result.table_file);
  }
  if (result.stopped) {
    fmt::print(stderr,
               "stopped; an ensemble has no checkpoint, the table holds what each member had reached\n");
    return exit_interrupted;
  }
  return report_failures(*result.ensemble);
}

}  // namespace glisson::app
