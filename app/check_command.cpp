// glisson check: everything that can be said about a simulation before it runs.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include <glisson/app/commands.hpp>
#include <glisson/app/mesh_quality.hpp>
#include <glisson/app/read_input.hpp>
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/core/solids/stable_step.hpp>
#include <glisson/run/summary.hpp>
#include <glisson/shells/inertia.hpp>

namespace glisson::app {
namespace {

void print_quality(const Mesh& mesh) {
  if (mesh.element_count() == 0) return;
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

/// Thickness, mass, shape and step of each set of membranes and shells.
void print_shells(const Model& model) {
  if (model.shells.empty()) return;
  const auto steps = shells::triangle_steps(model);  // by section
  std::size_t i = 0;
  for (const ShellSection& section : model.shells) {
    double area = 0, mass = 0, thinnest = section.thickness_of(0), thickest = thinnest;
    std::pair<double, int> worst{2, -1}, smallest{steps[i].dt, section.elements[0]};
    for (std::size_t k = 0; k < section.elements.size(); ++k, ++i) {
      const auto& triangle = model.mesh.triangles[static_cast<std::size_t>(section.elements[k])];
      const double its_area = triangle_area(triangle, model.mesh.X), h = section.thickness_of(k);
      area += its_area, mass += section.density_of(k) * h * its_area;
      thinnest = std::min(thinnest, h), thickest = std::max(thickest, h);
      worst = std::min(worst, {triangle_quality(triangle, model.mesh), section.elements[k]});
      smallest = std::min(smallest, {steps[i].dt, section.elements[k]});
    }
    fmt::print("{}: {} triangles ({}, {}), area {:.4g}, thickness {:.4g}", section.name,
               section.elements.size(), name_of(section.formulation), section.law, area, thinnest);
    if (thickest > thinnest) fmt::print(" to {:.4g}", thickest);
    fmt::print(
        ", mass {:.4g}; quality: worst {:.3f} (triangle {}); smallest step without other mass {:.3g} s "
        "(triangle {})\n",
        mass, worst.first, worst.second, smallest.first, smallest.second);
  }
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

/// check has read the file and built the simulation as a run does; a snapshot adds three vectors per node.
void print_memory(const AnySimulation& simulation, const Model& model) {
  const double snapshot = 3.0 * sizeof(Vec3<double>) * static_cast<double>(model.mesh.X.size());
  fmt::print("device {}, memory {} for the simulation, about {} at the peak of a run\n", simulation.device(),
             bytes_text(static_cast<double>(simulation.memory_bytes())),
             bytes_text(static_cast<double>(peak_memory()) + snapshot));
}

/// Bodies that lie in each other by more than the rounding of a file.
void warn_of_overlap(const AnySimulation& simulation, const Mesh& mesh, std::vector<std::string>& warnings) {
  Vec3<double> low = mesh.X.front(), high = low;
  for (const auto& X : mesh.X) {
    low = {std::min(low.x, X.x), std::min(low.y, X.y), std::min(low.z, X.z)};
    high = {std::max(high.x, X.x), std::max(high.y, X.y), std::max(high.z, X.z)};
  }
  const Vec3<double> size = high - low;
  for (const auto& [name, report] : simulation.contacts())
    if (report.start_depth > 1e-6 * std::sqrt(dot(size, size)))
      warnings.push_back(
          report.between_bodies
              ? fmt::format(
                    "{}: bodies start up to {:.3g} inside of each other; the first steps will part them",
                    name, report.start_depth)
              : fmt::format("{}: nodes start up to {:.3g} too deep; they come out within a tenth of the run",
                            name, report.start_depth));
}

}  // namespace

int check(const CheckArguments& arguments) {
  const CheckedModel input = read_and_validate(arguments.file, arguments.lenient);
  const Model& model = input.model;
  fmt::print("{}: {} nodes, {} elements in {} sets, {} shell triangles in {}, units {}\n", model.name,
             model.mesh.node_count(), model.mesh.element_count(), model.sections.size(),
             model.mesh.triangles.size(), model.shells.size(),
             model.units.empty() ? "not declared" : model.units);
  print_quality(model.mesh);
  print_steps(model);
  print_shells(model);
  SimulationOptions options = arguments.simulation;
  options.validated = true;
  const auto simulation = in_file(arguments.file, [&] { return make_simulation(model, options); });
  const StepReport report = simulation->report();
  print_memory(*simulation, model);
  fmt::print("time step {:.4g} s, stable up to {:.4g} s (limited by {})", report.dt, report.stable_step,
             report.limited_by);
  if (report.planned_steps > 0) fmt::print(", {} steps to {:.4g} s", report.planned_steps, model.time.total);
  fmt::print("\n");
  if (report.added_mass > 0) fmt::print("mass scaling adds {:.2f} % of the mass\n", 100 * report.added_mass);
  auto warnings = input.warnings;
  if (report.planned_steps > 0 && report.dt > report.stable_step)
    warnings.push_back(fmt::format("the TimeStep of {:.4g} s is above the stable step", report.dt));
  warn_of_overlap(*simulation, model.mesh, warnings);
  if (arguments.predict) predict(*simulation, report);
  for (const auto& warning : warnings) fmt::print("warning: {}\n", warning);
  fmt::print("{}: can be run, {} warning{}\n", arguments.file, warnings.size(),
             warnings.size() == 1 ? "" : "s");
  return exit_done;
}

}  // namespace glisson::app
