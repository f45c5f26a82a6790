#include <glisson/core/simulation/failure.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace glisson {
namespace {

bool finite(const Vec3<double>& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

int first_bad_node(std::span<const Vec3<double>> u) {
  for (std::size_t n = 0; n < u.size(); ++n)
    if (!finite(u[n])) return static_cast<int>(n);
  return -1;
}

Vec3<double> moved(const Model& model, std::span<const Vec3<double>> u, int n) {
  const auto i = static_cast<std::size_t>(n);
  return u.empty() ? model.mesh.X[i] : model.mesh.X[i] + u[i];
}

/// Volume now over volume at rest of the tetrahedron at the first corner; enough to find the element that
/// turned inside out.
double volume_ratio(const Model& model, std::span<const Vec3<double>> u, int e) {
  const auto nodes = model.mesh.element(e);
  const bool tet = nodes.size() == 4;
  const int a = nodes[0], b = nodes[1], c = tet ? nodes[2] : nodes[3], d = tet ? nodes[3] : nodes[4];
  auto volume = [&](std::span<const Vec3<double>> w) {
    const auto x0 = moved(model, w, a);
    return dot(cross(moved(model, w, b) - x0, moved(model, w, c) - x0), moved(model, w, d) - x0);
  };
  return volume(u) / volume({});
}

struct Worst {
  int element = -1;
  double ratio = std::numeric_limits<double>::infinity();
};

Worst most_compressed(const Model& model, std::span<const Vec3<double>> u) {
  Worst worst;
  for (int e = 0; e < model.mesh.element_count(); ++e) {
    const double ratio = volume_ratio(model, u, e);
    if (!(ratio >= worst.ratio)) worst = {e, ratio};
    if (!std::isfinite(ratio)) break;
  }
  return worst;
}

std::string cause(const Model& model, const FailureContext& c) {
  std::ostringstream text;
  const bool too_large = c.stable_now > 0 && c.report.dt > c.stable_now;
  const Worst worst = most_compressed(model, c.healthy.empty() ? c.u : c.healthy);
  if (worst.element >= 0)
    text << "Before that, at step " << c.healthy_step << ", the most compressed one was "
         << element_text(model, worst.element) << ", with " << worst.ratio << " of its volume. ";
  if (too_large)
    text << "Likely cause: the step of " << c.report.dt << " s is above the stable step of " << c.stable_now
         << " s. Leave TimeStep out, or use at most " << 0.8 * c.stable_now << " s.";
  else if (worst.ratio < 0.2)
    text << "Likely cause: an element collapsed under its load. Apply the load more slowly, use a finer mesh "
            "there, or check "
            "the load's size and the units.";
  else
    text << "Likely cause: the load or the prescribed motion is too fast or too large for the step of "
         << c.report.dt << " s (stable at rest: " << c.report.stable_step << " s, limited by "
         << c.report.limited_by << ").";
  return text.str();
}

}  // namespace

std::string element_text(const Model& model, int element) {
  std::string text = "element " + std::to_string(element);
  for (const Section& s : model.sections)
    if (std::find(s.elements.begin(), s.elements.end(), element) != s.elements.end())
      return text + " (" + name_of(s.formulation) + ", " + s.material.law + ")";
  return text;
}

std::string triangle_text(const Model& model, int triangle) {
  std::string text = "shell triangle " + std::to_string(triangle);
  for (const ShellSection& s : model.shells)
    if (std::find(s.elements.begin(), s.elements.end(), triangle) != s.elements.end())
      return text + " (" + name_of(s.formulation) + ", " + s.law + ")";
  return text;
}

std::string not_finite_message(const Model& model, const FailureContext& c) {
  std::ostringstream text;
  const int node = first_bad_node(c.u);
  text << "The displacement is not finite";
  if (node >= 0) text << ": node " << node;
  text << ", found at step " << c.step << " (t = " << c.time << " s, dt = " << c.report.dt << " s). "
       << cause(model, c);
  return text.str();
}

std::string imbalance_message(const Model& model, const FailureContext& c, const Energies& e, double share,
                              double tolerance) {
  std::ostringstream text;
  text << "The energy balance is off by " << 100 * share << " % (EnergyTolerance: " << 100 * tolerance
       << " %) at step " << c.step << " (t = " << c.time << " s): kinetic " << e.kinetic << ", strain "
       << e.strain << ", damping " << e.damping << ", work of loads " << e.external
       << ", of prescribed nodes " << e.prescribed << ", of contact " << e.contact << " J. "
       << cause(model, c);
  return text.str();
}

}  // namespace glisson
