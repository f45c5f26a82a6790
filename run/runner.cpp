#include <glisson/run/runner.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <sstream>

#include <glisson/contact/end_overlap.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/models/output/contact_pressure.hpp>
#include <glisson/models/output/history_csv.hpp>
#include <glisson/models/output/pvd_series.hpp>
#include <glisson/models/output/text_writer.hpp>
#include <glisson/run/checkpoint.hpp>
#include <glisson/run/model_hash.hpp>

namespace glisson {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Adds the wall time of its life.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum), start_(now()) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { sum_ += now() - start_; }

 private:
  double& sum_;
  double start_;
};

const std::vector<std::string> history_columns{"time [s]",    "dt [s]",        "kinetic [J]",
                                               "strain [J]",  "hourglass [J]", "viscous [J]",
                                               "damping [J]", "external [J]",  "prescribed [J]",
                                               "contact [J]", "imbalance [J]", "largest displacement [m]"};

/// With the part of the strain energy in membranes and shells where there are some.
std::vector<std::string> columns_of(const Model& model) {
  auto columns = history_columns;
  if (!model.shells.empty()) columns.emplace_back("shell strain [J]");
  return columns;
}

std::string text(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(4);
  out << value;
  return out.str();
}

std::pair<double, int> largest(const std::vector<Vec3<double>>& u) {
  double square = 0;
  int node = u.empty() ? -1 : 0;
  for (std::size_t n = 0; n < u.size(); ++n)
    if (dot(u[n], u[n]) > square) square = dot(u[n], u[n]), node = static_cast<int>(n);
  return {std::sqrt(square), node};
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error || !std::filesystem::is_directory(directory))
    throw Error(ErrorKind::run, "The output directory '" + directory.string() + "' cannot be made (" +
                                    (error ? error.message() : "there is a file of that name") +
                                    "). Choose another with -o.");
}

}  // namespace

struct Runner::Files {
  std::optional<PvdSeries> series;
  std::optional<HistoryCsv> history;
  std::optional<TextWriter> texts;
};

Runner::Runner(const Model& model, RunnerOptions options)
    : model_(model), options_(std::move(options)), files_(std::make_unique<Files>()) {
  if (!options_.text_prefix) options_.text_prefix = (options_.directory / "").string();
}

Runner::~Runner() = default;

void Runner::log(LogLevel level, const std::string& line) const {
  if (options_.log) options_.log(level, line);
}

bool Runner::run() {
  summary_.model = model_.name;
  summary_.model_file = options_.model_file;
  summary_.units = model_.units;
  summary_.node_count = model_.mesh.node_count();
  summary_.element_count = model_.mesh.element_count();
  summary_.triangle_count = static_cast<int>(model_.mesh.triangles.size());
  summary_.total_time = model_.time.total;
  summary_.warnings = options_.warnings;
  summary_.timings.read = options_.read_seconds;
  make_directory(options_.directory);
  try {
    const bool done = run_to_end();
    if (done) look_for_overlap();
    finish(done ? "done" : "stopped", "");
    return done;
  } catch (const Error& error) {
    try {
      finish("failed", error.what());
    } catch (const Error& second) {
      log(LogLevel::warning, std::string("The summary could not be written either: ") + second.what());
    }
    throw;
  }
}

bool Runner::run_to_end() {
  try {
    prepare();
    return advance_to_end();
  } catch (const std::bad_alloc&) {
    throw Error(
        ErrorKind::run,
        "The memory of this machine is not enough for the run. Use a coarser mesh or single precision.");
  }
}

void Runner::look_for_overlap() {
  const Stopwatch watch(summary_.timings.output);
  for (const auto& warning :
       contact::overlap_warnings(model_, simulation_->displacement(), simulation_->time())) {
    summary_.warnings.push_back(warning);
    log(LogLevel::warning, warning);
  }
}

void Runner::prepare() {
  write_summary(options_.directory / "summary.json", summary_);
  {
    const Stopwatch watch(summary_.timings.set_up);
    simulation_ = make_simulation(model_, options_.simulation);
    hash_ = model_hash(model_);
  }
  simulation_->watch_largest_displacement();
  summary_.device = simulation_->device();
  if (options_.simulation.device == "auto") summary_.device_choice = automatic_device_text();
  if (options_.resume) {
    const auto extras = read_checkpoint(options_.directory / "checkpoint.glisson", *simulation_, hash_);
    summary_.timings.stepping = stepping_before_ = extras.stepping_seconds;
    summary_.timings.output = extras.output_seconds;
    log(LogLevel::info, "resumed at step " + std::to_string(simulation_->step_count()) +
                            ", t = " + text(simulation_->time()) + " s");
  }
  first_step_ = simulation_->step_count();
  const StepReport report = simulation_->report();
  log(LogLevel::info, "device " + summary_.device +
                          (summary_.device_choice.empty() ? "" : " (" + summary_.device_choice + ")"));
  log(LogLevel::info,
      "time step " + text(report.dt) + " s (stable " + text(report.stable_step) + " s, limited by " +
          report.limited_by + ")" +
          (report.planned_steps > 0 ? ", " + std::to_string(report.planned_steps) + " steps" : ""));
  if (report.added_mass > 0)
    log(LogLevel::info, "mass scaling adds " + text(100 * report.added_mass) + " % mass");
  if (report.planned_steps > 0 && report.dt > report.stable_step) {
    summary_.warnings.push_back("The TimeStep of " + text(report.dt) + " s is above the stable step of " +
                                text(report.stable_step) + " s; the run will probably diverge.");
    log(LogLevel::warning, summary_.warnings.back());
  }
  open_files();
}

void Runner::open_files() {
  const Stopwatch watch(summary_.timings.output);
  const auto& directory = options_.directory;
  const std::string stem = model_.name.empty() ? "result" : model_.name;
  const double t = simulation_->time();
  const auto& variables = model_.output.variables;
  if (!options_.resume) {
    files_->series.emplace(directory, stem);
    files_->history.emplace(directory / "history.csv", columns_of(model_));
    if (!variables.empty()) files_->texts.emplace(*options_.text_prefix, variables);
  } else {
    files_->series.emplace(PvdSeries::resume(directory, stem, t));
    files_->history.emplace(
        HistoryCsv::resume(directory / "history.csv", columns_of(model_), simulation_->step_count()));
    if (!variables.empty()) files_->texts.emplace(TextWriter::resume(*options_.text_prefix, variables, t));
  }
  summary_.files = {files_->series->collection().string(), (directory / "history.csv").string(),
                    (directory / "summary.json").string()};
  for (const auto& variable : variables) summary_.files.push_back(*options_.text_prefix + variable + ".txt");
}

std::int64_t Runner::steps_until_event() const {
  const std::int64_t step = simulation_->step_count();
  const StepReport report = simulation_->report();
  std::int64_t count = std::max<std::int64_t>(1, chunk_);
  const auto until_multiple_of = [&](std::int64_t every) {
    if (every > 0) count = std::min(count, every - step % every);
  };
  until_multiple_of(model_.output.every);
  // the first step after a multiple has its energies accounted, and so has the last one
  const std::int64_t beyond = step % report.energies_every;
  count = std::min(count, beyond == 0 ? 1 : report.energies_every - beyond + 1);
  if (report.planned_steps > 0)
    count = std::min(count, std::max<std::int64_t>(1, report.planned_steps - step));
  return count;
}

/// The history line of the last energy account.
void Runner::append_history(const AccountReport& account) {
  const Energies e = simulation_->energies();
  std::vector<double> values{account.time,  simulation_->report().dt,
                             e.kinetic,     e.strain,
                             e.hourglass,   e.viscous,
                             e.damping,     e.external,
                             e.prescribed,  e.contact,
                             e.imbalance(), account.largest_displacement};
  if (!model_.shells.empty()) values.push_back(e.shell);
  files_->history->append(account.step, values);
}

bool Runner::advance_to_end() {
  const auto every = model_.output.every;
  double& stepping = summary_.timings.stepping;
  last_checkpoint_ = now();
  if (simulation_->step_count() == 0) snapshot(false);
  while (!simulation_->finished()) {
    if (stop_wanted()) {
      checkpoint();
      return false;
    }
    const std::int64_t step = simulation_->step_count();
    const double before = now();
    {
      const Stopwatch watch(stepping);
      simulation_->step(steps_until_event());
      const AccountReport account = simulation_->last_account();
      if (account.step >= step) append_history(account);
    }
    const double taken = now() - before;
    const auto steps = static_cast<double>(simulation_->step_count() - step);
    chunk_ =
        std::clamp<std::int64_t>(static_cast<std::int64_t>(0.05 * steps / std::max(taken, 1e-9)), 1, 10000);
    const bool finished = simulation_->finished();
    if (finished || (every > 0 && simulation_->step_count() % every == 0)) snapshot(true);
    note_progress();
    if (options_.checkpoint_seconds > 0 && now() - last_checkpoint_ > options_.checkpoint_seconds)
      checkpoint();
  }
  return true;
}

/// The text files hold the states at multiples of Output/Freq only, as NiftySim writes them; without a Freq,
/// the last one.
void Runner::snapshot(bool with_text) {
  const Stopwatch watch(summary_.timings.output);
  auto state = Snapshot::of(*simulation_);
  const bool finite = std::all_of(state.displacement.begin(), state.displacement.end(),
                                  [](const auto& u) { return std::isfinite(u.x + u.y + u.z); });
  if (!simulation_->finished() && !finite) {
    const auto every = simulation_->report().energies_every;
    simulation_->step(every - simulation_->step_count() % every + 1);  // its account says where and why
  }
  if (!state.contact_force.empty())
    state.contact_pressure = nodal_pressure(model_.mesh, state.displacement, state.contact_force);
  files_->series->write(model_.mesh, state);
  summary_.snapshots = static_cast<int>(files_->series->entries().size());
  const auto every = model_.output.every;
  const bool wanted = every == 0 || simulation_->step_count() % every == 0;
  if (!files_->texts || !with_text || !wanted) return;
  const Energies e = simulation_->energies();
  files_->texts->write(state, e.kinetic, e.strain);
}

void Runner::checkpoint() {
  const Stopwatch watch(summary_.timings.output);
  const auto path = options_.directory / "checkpoint.glisson";
  write_checkpoint(path, *simulation_, hash_, {summary_.timings.stepping, summary_.timings.output});
  last_checkpoint_ = now();
  log(LogLevel::debug,
      "checkpoint at step " + std::to_string(simulation_->step_count()) + ": " + path.string());
}

void Runner::update_summary() {
  summary_.peak_bytes = peak_memory();
  if (!simulation_) return;
  summary_.steps = simulation_->step_count();
  summary_.time = simulation_->time();
  summary_.report = simulation_->report();
  summary_.energies = simulation_->energies();
  summary_.residuals = simulation_->residuals();
  summary_.contacts = simulation_->contacts();
  std::tie(summary_.largest_displacement, summary_.largest_node) = largest(simulation_->displacement());
  summary_.simulation_bytes = simulation_->memory_bytes();
}

void Runner::finish(const std::string& status, const std::string& message) {
  {
    const Stopwatch watch(summary_.timings.output);
    summary_.status = status;
    summary_.message = message;
    if (files_->texts) files_->texts->finish(status == "stopped");
    update_summary();
  }
  write_summary(options_.directory / "summary.json", summary_);
  if (status != "done") return;
  std::error_code ignored;  // a checkpoint of a finished run is of no use
  std::filesystem::remove(options_.directory / "checkpoint.glisson", ignored);
}

void Runner::note_progress() {
  const double t = now();
  if (!options_.progress || t - last_progress_ < 0.2) return;
  last_progress_ = t;
  Progress progress;
  progress.step = simulation_->step_count();
  progress.planned = simulation_->report().planned_steps;
  progress.time = simulation_->time();
  const double seconds = summary_.timings.stepping - stepping_before_;
  if (seconds > 0) progress.steps_per_second = static_cast<double>(progress.step - first_step_) / seconds;
  if (progress.planned > 0 && progress.steps_per_second > 0)
    progress.seconds_left = static_cast<double>(progress.planned - progress.step) / progress.steps_per_second;
  options_.progress(progress);
}

}  // namespace glisson
