#include <glisson/run/ensemble_runner.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>

#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/models/output/write_state.hpp>

namespace glisson {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string text(double value) { return number_text(value, 9); }

/// As a CSV cell.
std::string quoted(std::string cell) {
  std::replace(cell.begin(), cell.end(), '"', '\'');
  std::replace(cell.begin(), cell.end(), '\n', ' ');
  return '"' + cell + '"';
}

double largest(const std::vector<Vec3<double>>& u) {
  double square = 0;
  for (const auto& a : u)
    if (!(dot(a, a) <= square)) square = dot(a, a);  // a NaN stays
  return std::sqrt(square);
}

EnsembleProgress progress_of(const AnyEnsemble& ensemble) {
  EnsembleProgress progress;
  for (int k = 0; k < ensemble.member_count(); ++k) {
    const MemberStatus status = ensemble.status(k);
    ++(status == MemberStatus::running    ? progress.running
       : status == MemberStatus::finished ? progress.finished
                                          : progress.failed);
  }
  return progress;
}

const char* status_text(MemberStatus status) {
  switch (status) {
    case MemberStatus::running:
      return "stopped";
    case MemberStatus::finished:
      return "done";
    case MemberStatus::failed:
      return "failed";
  }
  return "";
}

constexpr const char* result_columns =
    "status,steps,time [s],dt [s],largest displacement [m],kinetic [J],strain [J],hourglass [J],viscous [J],"
    "damping [J],external [J],prescribed [J],contact [J],imbalance [J],message";

void write_results(std::ostream& out, AnyEnsemble& ensemble, int k) {
  out << status_text(ensemble.status(k)) << ',';
  std::string message = ensemble.error(k);
  try {
    AnySimulation& member = ensemble.member(k);
    const Energies e = member.energies();
    out << member.step_count();
    for (const double value :
         {member.time(), member.report().dt, largest(member.displacement()), e.kinetic, e.strain, e.hourglass,
          e.viscous, e.damping, e.external, e.prescribed, e.contact, e.imbalance()})
      out << ',' << text(value);
    if (message.empty()) message = member.report().ending;
  } catch (const Error&) {  // it could not be set up
    out << "0,,,,,,,,,,,,";
  }
  out << ',' << quoted(message) << '\n';
}

void write_table(const std::filesystem::path& path, const ParameterTable& table, AnyEnsemble& ensemble) {
  write_atomically(path, [&](std::ostream& out) {
    out << "member,";
    for (const auto& name : table.paths) out << quoted(name) << ',';
    out << result_columns << '\n';
    for (int k = 0; k < ensemble.member_count(); ++k) {
      out << k << ',';
      for (const auto& value : table.rows[static_cast<std::size_t>(k)]) out << value << ',';
      write_results(out, ensemble, k);
    }
  });
}

void write_states(const std::filesystem::path& directory, const Mesh& mesh, AnyEnsemble& ensemble) {
  for (int k = 0; k < ensemble.member_count(); ++k) {
    if (ensemble.status(k) != MemberStatus::finished) continue;
    write_state(directory, "member-" + std::to_string(k), mesh, Snapshot::of(ensemble.member(k)));
  }
}

/// True when it was stopped.
bool advance(AnyEnsemble& ensemble, const EnsembleRunOptions& options) {
  std::int64_t chunk = 1;
  auto last = Clock::now();
  while (!ensemble.finished()) {
    if (options.stop && options.stop->load(std::memory_order_relaxed)) return true;
    const auto start = Clock::now();
    ensemble.step(chunk);
    const double taken = std::max(seconds_since(start), 1e-9);
    chunk = std::clamp<std::int64_t>(static_cast<std::int64_t>(0.2 * static_cast<double>(chunk) / taken), 1,
                                     10000);
    if (!options.progress || seconds_since(last) < 1) continue;
    last = Clock::now();
    options.progress(progress_of(ensemble));
  }
  return false;
}

}  // namespace

EnsembleResult run_ensemble(std::vector<Model> members, const ParameterTable& table,
                            const EnsembleRunOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(options.directory, error);
  if (!std::filesystem::is_directory(options.directory))
    throw Error(ErrorKind::run, "The output directory '" + options.directory.string() +
                                    "' cannot be made. Choose another with -o.");
  const Mesh mesh = members.empty() ? Mesh{} : members[0].mesh;
  EnsembleResult result;
  result.ensemble = make_ensemble(std::move(members), options.simulation);
  const auto start = Clock::now();
  result.stopped = advance(*result.ensemble, options);
  result.seconds = seconds_since(start);
  result.failed = progress_of(*result.ensemble).failed;
  result.table_file = (options.directory / "ensemble.csv").string();
  write_table(result.table_file, table, *result.ensemble);
  write_states(options.directory, mesh, *result.ensemble);
  return result;
}

}  // namespace glisson
