#include <glisson/app/print_results.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <glisson/app/read_input.hpp>

namespace glisson::app {
namespace {

/// Of files in mm-kg-s; any other set is printed as SI.
struct UnitNames {
  const char *length, *energy;
};
UnitNames names_of(const std::string& units) {
  if (units == "mm-kg-s") return {"mm", "uJ"};
  if (units == "SI") return {"m", "J"};
  return {"(length of the file)", "(energy of the file)"};
}

void print_vectors(const std::vector<int>& nodes, const std::vector<Vec3<double>>& values) {
  for (const int n : nodes) {
    const auto& v = values[static_cast<std::size_t>(n)];
    fmt::print("{} {:.9g} {:.9g} {:.9g}\n", n, v.x, v.y, v.z);
  }
}

std::vector<int> all_nodes(const Model& model) {
  std::vector<int> nodes(static_cast<std::size_t>(model.mesh.node_count()));
  for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = static_cast<int>(n);
  return nodes;
}

std::vector<int> moved_nodes(const Model& model) {
  std::vector<int> nodes;
  for (const auto& constraint : model.displacements)
    nodes.insert(nodes.end(), constraint.nodes.begin(), constraint.nodes.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace

void print_summary(const RunSummary& s) {
  const auto unit = names_of(s.units);
  const auto& e = s.energies;
  const double steps = std::max<double>(1, static_cast<double>(s.steps));
  fmt::print("largest displacement {:.4g} {} at node {}\n", s.largest_displacement, unit.length,
             s.largest_node);
  fmt::print(
      "energies [{}]: strain {:.4g}, kinetic {:.4g}, external work {:.4g}, prescribed {:.4g}, damping "
      "{:.4g}, "
      "contact {:.4g}, hourglass {:.4g}, imbalance {:.2g}\n",
      unit.energy, e.strain, e.kinetic, e.external, e.prescribed, e.damping, e.contact, e.hourglass,
      e.imbalance());
  if (!s.report.ending.empty())
    fmt::print("{} after {} steps (residual force {:.2g}, displacement change {:.2g})\n", s.report.ending,
               s.steps, s.residuals[0], s.residuals[1]);
  fmt::print("{} steps in {}, {:.3f} ms per step ({:.1f} ns per element and step); set-up {}, output {}\n",
             s.steps, duration_text(s.timings.stepping), 1e3 * s.timings.stepping / steps,
             1e9 * s.timings.stepping / steps / std::max(1, s.element_count + s.triangle_count),
             duration_text(s.timings.set_up), duration_text(s.timings.output));
  fmt::print("memory {} at most ({} for the simulation)\n", bytes_text(static_cast<double>(s.peak_bytes)),
             bytes_text(static_cast<double>(s.simulation_bytes)));
  fmt::print("written:");
  for (const auto& file : s.files) fmt::print(" {}", file);
  fmt::print("\n");
}

void print_result(const std::string& what, const Model& model, const AnySimulation& simulation,
                  const RunSummary& summary) {
  if (what == "ES") fmt::print("strain energy {:.9g}\n", summary.energies.strain);
  if (what == "EK") fmt::print("kinetic energy {:.9g}\n", summary.energies.kinetic);
  if (what == "ND") print_vectors(all_nodes(model), simulation.displacement());
  if (what == "NF") print_vectors(all_nodes(model), simulation.internal_force());
  if (what == "LNF") print_vectors(moved_nodes(model), simulation.internal_force());
  if (what == "LNFS") {
    const auto forces = simulation.internal_force();
    Vec3<double> sum;
    for (const int n : moved_nodes(model)) sum = sum + forces[static_cast<std::size_t>(n)];
    fmt::print("{:.9g} {:.9g} {:.9g}\n", sum.x, sum.y, sum.z);
  }
}

}  // namespace glisson::app
