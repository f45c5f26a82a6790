// glisson check: everything that can be said about a simulation before it runs.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include <glisson/app/commands.hpp>
#include <glisson/app/mesh_quality.hpp>
#include <glisson/app/read_input.hpp>
#include <glisson/core/solids/stable_step.hpp>

namespace glisson::app {
namespace {

void print_quality(const Mesh& mesh) {
  std::vector<std::pair<double, int>> quality;
  quality.reserve(mesh.shape.size());
  for (int e = 0; e < mesh.element_count(); ++e) quality.emplace_back(element_quality(mesh, e), e);
  std::sort(quality.begin(), quality.end());
  const auto poor =
      std::count_if(quality.begin(), quality.end(), [](const auto& q) { return q.first < 0.1; });
  fmt::print("element quality (1 best, 0 flat): worst {:.3f} (element {}), median {:.3f}, {} below 0.1\n",
             quality.front().first, quality.front().second, quality[quality.size() / 2].first, poor);
}

void print_steps(const Model& model) {
  std::vector<std::pair<double, int>> steps;
  visit_element_steps(model, [&](int e, double dt, double, double, double) { steps.emplace_back(dt, e); });
  std::sort(steps.begin(), steps.end());
  if (steps.empty()) return;
  const double smallest = steps.front().first, median = steps[steps.size() / 2].first;
  fmt::print("step of the elements: smallest {:.3g} s (element {}), median {:.3g} s", smallest,
             steps.front().second, median);
  if (median > 5 * smallest) {
    const auto slow =
        std::count_if(steps.begin(), steps.end(), [&](const auto& s) { return s.first < median / 3; });
    fmt::print("; {} elements have less than a third of the median: SystemParams/MassScaling would pay",
               slow);
  }
  fmt::print("\n");
}

/// Seconds per step, from a few of them.
double seconds_per_step(AnySimulation& simulation) {
  using Clock = std::chrono::steady_clock;
  simulation.step(2);
  const auto start = Clock::now();
  std::int64_t steps = 0;
  double seconds = 0;
  while (seconds < 0.5 && steps < 1000 && !simulation.finished()) {
    simulation.step(5);
    steps += 5;
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  return steps > 0 ? seconds / static_cast<double>(steps) : 0;
}

void predict(AnySimulation& simulation, const StepReport& report) {
  const double step = seconds_per_step(simulation);
  fmt::print("time per step {:.3f} ms; ", 1e3 * step);
  if (report.planned_steps > 0)
    fmt::print("the run will take about {}\n",
               duration_text(step * static_cast<double>(report.planned_steps)));
  else
    fmt::print("a quasi-static run ends when it has converged, 1000 steps take {}\n",
               duration_text(1000 * step));
}

}  // namespace

int check(const CheckArguments& arguments) {
  const CheckedModel input = read_and_validate(arguments.file, arguments.lenient);
  const Model& model = input.model;
  fmt::print("{}: {} nodes, {} elements in {} sets, units {}\n", model.name, model.mesh.node_count(),
             model.mesh.element_count(), model.sections.size(),
             model.units.empty() ? "not declared" : model.units);
  print_quality(model.mesh);
  print_steps(model);
  SimulationOptions options = arguments.simulation;
  options.validated = true;
  const auto simulation = in_file(arguments.file, [&] { return make_simulation(model, options); });
  const StepReport report = simulation->report();
  fmt::print("device {}, memory {}\n", simulation->device(),
             bytes_text(static_cast<double>(simulation->memory_bytes())));
  fmt::print("time step {:.4g} s, stable up to {:.4g} s (limited by {})", report.dt, report.stable_step,
             report.limited_by);
  if (report.planned_steps > 0) fmt::print(", {} steps to {:.4g} s", report.planned_steps, model.time.total);
  fmt::print("\n");
  if (report.added_mass > 0) fmt::print("mass scaling adds {:.2f} % of the mass\n", 100 * report.added_mass);
  auto warnings = input.warnings;
  if (report.planned_steps > 0 && report.dt > report.stable_step)
    warnings.push_back(fmt::format("the TimeStep of {:.4g} s is above the stable step", report.dt));
  if (arguments.predict) predict(*simulation, report);
  for (const auto& warning : warnings) fmt::print("warning: {}\n", warning);
  fmt::print("{}: can be run, {} warning{}\n", arguments.file, warnings.size(),
             warnings.size() == 1 ? "" : "s");
  return exit_done;
}

}  // namespace glisson::app
