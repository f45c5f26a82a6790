// glisson bench: time of whole steps on box meshes, variants interleaved, medians, next to the bandwidth
// measured in the same run.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <thread>

#include <glisson/app/box_case.hpp>
#include <glisson/app/commands.hpp>
#include <glisson/app/contact_case.hpp>
#include <glisson/app/ensemble_bench.hpp>
#include <glisson/app/sheet_case.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/cpu/bandwidth.hpp>
#include <glisson/models/format/suggest.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/run/gpus.hpp>
#include <glisson/version.hpp>

namespace glisson::app {
namespace {

using Clock = std::chrono::steady_clock;

/// A box of solids, a sheet of triangles, or two blocks that touch, or do not.
struct Variant {
  std::string name;
  std::function<Model(int elements)> model;
  int warm_up_steps = 30;
};

constexpr double endless = 100;  ///< no bench reaches the end of the run [s]

std::vector<Variant> variants() {
  std::vector<Variant> list;
  const BoxCase boxes[] = {
      {.name = "T4", .formulation = Formulation::t4},
      {.name = "T4ANP", .formulation = Formulation::t4anp},
      {.name = "H8", .formulation = Formulation::h8},
      {.name = "H8-voxels", .formulation = Formulation::h8, .jitter = 0},
      {.name = "T4-viscous", .formulation = Formulation::t4, .viscous = true},
      {.name = "T4-Ogden",
       .formulation = Formulation::t4,
       .law = "OG",
       .parameters = {1000, 2, 400, 4, 200, -2, 20000}},
  };
  for (const BoxCase& box : boxes)
    list.push_back({box.name, [box](int elements) { return box_model(box, elements, endless); }});
  const std::pair<const char*, SheetCase> sheets[] = {
      {"membrane", {}},
      {"membrane-Fung", {ShellFormulation::membrane, "Fung", {2000, 2}}},
      {"shell", {ShellFormulation::rotation_free, "NeoHookean", {2000}}},
      {"shell-linear", {ShellFormulation::rotation_free, "Linear", {6000, 0.45}}},
  };
  for (const auto& [name, sheet] : sheets)
    list.push_back({name, [sheet](int elements) { return sheet_model(sheet, elements, endless); }});
  // until the blocks, which are pressed on each other, have come to rest
  for (const auto& [name, touch] : {std::pair{"T4-blocks", false}, std::pair{"T4-contact", true}})
    list.push_back(
        {name, [touch = touch](int elements) { return contact_model(elements, endless, touch); }, 1000});
  return list;
}

std::vector<Variant> chosen(const std::vector<std::string>& names) {
  const std::vector<Variant> all = variants();
  if (names.empty()) return all;
  std::vector<Variant> result;
  std::vector<std::string> known;
  for (const auto& v : all) known.push_back(v.name);
  for (const auto& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      throw Error(ErrorKind::usage,
                  "There is no bench case '" + name + "'" + detail::suggestion(name, known));
    result.push_back(all[static_cast<std::size_t>(found - known.begin())]);
  }
  return result;
}

/// A turn must be long enough that the first step after another variant's turn does not decide.
constexpr int fewest_steps = 10;

/// One variant at one size, kept alive so that variants take turns.
struct Entry {
  std::string name;
  std::unique_ptr<Model> model;
  std::unique_ptr<AnySimulation> simulation;
  std::int64_t steps_per_turn = 1;
  std::vector<double> seconds_per_step;
  double set_up = 0;  ///< [s]
  std::vector<NamedContact> contacts;  ///< before the turns

  double run(std::int64_t steps) {
    const auto start = Clock::now();
    simulation->step(steps);
    return std::chrono::duration<double>(Clock::now() - start).count();
  }
  double mean() const {
    return std::accumulate(seconds_per_step.begin(), seconds_per_step.end(), 0.0) /
           static_cast<double>(seconds_per_step.size());
  }
  double median() {
    std::sort(seconds_per_step.begin(), seconds_per_step.end());
    return seconds_per_step[seconds_per_step.size() / 2];
  }
};

/// Of the memory that the steps work in [bytes/s]: a copy on a GPU, else the triad, over arrays far larger
/// than the caches; the arrays are gone when it returns.
double bandwidth_of(const BenchArguments& arguments) {
  const bool gpu = arguments.device == "auto" ? !find_gpus().empty() : arguments.device.rfind("cuda", 0) == 0;
  if (gpu) return gpu_copy_bandwidth(arguments.device == "auto" ? "cuda:0" : arguments.device);
  Threads threads(arguments.threads);
  return measure_bandwidth(threads, std::size_t{40} << 20).triad;
}

Entry prepare(const Variant& variant, int elements, const BenchArguments& arguments) {
  Entry entry;
  entry.name = variant.name;
  entry.model = std::make_unique<Model>(variant.model(elements));
  SimulationOptions options;
  options.device = arguments.device;
  options.threads = arguments.threads;
  const auto start = Clock::now();
  entry.simulation = make_simulation(*entry.model, options);
  entry.set_up = std::chrono::duration<double>(Clock::now() - start).count();
  entry.run(variant.warm_up_steps);
  const double once = entry.run(fewest_steps) / fewest_steps;
  entry.steps_per_turn = std::clamp<std::int64_t>(static_cast<std::int64_t>(0.05 * arguments.seconds / once),
                                                  fewest_steps, 100000);
  entry.run(entry.steps_per_turn);
  entry.contacts = entry.simulation->contacts();
  return entry;
}

nlohmann::ordered_json result_of(Entry& entry, double bandwidth) {
  const double step = entry.median();
  const Mesh& mesh = entry.model->mesh;
  const int elements = mesh.element_count() + static_cast<int>(mesh.triangles.size());
  const double best = entry.seconds_per_step.front();
  const auto bytes = static_cast<double>(entry.simulation->memory_bytes());
  fmt::print("{:<14} {:>9} {:>10.4f} {:>8.2f} {:>8.2f} {:>9} {:>8.0f} % {:>8.2f}\n", entry.name,
             elements, 1e3 * step, 1e9 * step / elements, 1e9 * best / elements,
             static_cast<long>(bytes / elements), 100 * bytes / step / bandwidth, entry.set_up);
  nlohmann::ordered_json result{{"case", entry.name},
                                {"elements", elements},
                                {"nodes", mesh.node_count()},
                                {"device", entry.simulation->device()},
                                {"ms_per_step", 1e3 * step},
                                {"ns_per_element_and_step", 1e9 * step / elements},
                                {"ns_per_element_and_step_best", 1e9 * best / elements},
                                {"array_bytes", bytes},
                                {"share_of_bandwidth", bytes / step / bandwidth},
                                {"set_up_s", entry.set_up},
                                {"turns", entry.seconds_per_step.size()}};
  const auto turns = static_cast<std::int64_t>(entry.seconds_per_step.size());
  if (!entry.contacts.empty())
    result["contact"] =
        contact_per_step(entry.contacts.front().report, entry.simulation->contacts().front().report,
                         turns * entry.steps_per_turn, entry.mean());
  return result;
}

/// All variants take turns at each size.
nlohmann::ordered_json bench_steps(const BenchArguments& arguments, double bandwidth) {
  const auto list = chosen(arguments.cases);
  fmt::print(
      "memory bandwidth {:.1f} GB/s; share: bytes of all arrays, each once per step, over time and "
      "bandwidth\n",
      bandwidth / 1e9);
  fmt::print("{:<14} {:>9} {:>10} {:>8} {:>8} {:>9} {:>10} {:>8}\n", "case", "elements", "ms/step", "ns/el",
             "best", "bytes/el", "share", "set-up s");
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const int size : arguments.sizes) {
    std::vector<Entry> entries;
    entries.reserve(list.size());
    for (const auto& variant : list) entries.push_back(prepare(variant, size, arguments));
    for (int turn = 0; turn < 20; ++turn)
      for (auto& e : entries)
        e.seconds_per_step.push_back(e.run(e.steps_per_turn) / static_cast<double>(e.steps_per_turn));
    for (auto& entry : entries) results.push_back(result_of(entry, bandwidth));
  }
  return results;
}

void write(const std::string& file, const nlohmann::ordered_json& all) {
  const auto folder = std::filesystem::path(file).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  write_atomically(file, [&](std::ostream& out) { out << all.dump(2) << '\n'; });
  fmt::print("written: {}\n", file);
}

}  // namespace

int bench(const BenchArguments& arguments) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  nlohmann::ordered_json all{{"version", version},
                             {"threads", arguments.threads > 0 ? arguments.threads : cores}};
  if (!arguments.members.empty()) {
    all["ensembles"] = bench_ensembles(arguments);
  } else {
    const double bandwidth = bandwidth_of(arguments);
    all["bandwidth_bytes_per_s"] = bandwidth;
    all["results"] = bench_steps(arguments, bandwidth);
  }
  if (!arguments.json.empty()) write(arguments.json, all);
  return exit_done;
}

}  // namespace glisson::app
