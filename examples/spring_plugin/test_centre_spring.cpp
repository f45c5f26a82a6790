// A block with an initial velocity on a CentreSpring: the period is 2 pi sqrt(m / k), and nothing deforms.
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <numeric>

#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/run/make_simulation.hpp>

#include "centre_spring.hpp"

namespace {

constexpr double side = 0.1, density = 1000, stiffness = 40, speed = 0.1;  // [m], [kg/m^3], [N/m], [m/s]

glisson::Model moving_block() {
  glisson::Model model;
  model.name = "block";
  model.mesh = glisson::box_mesh({2, 2, 2}, {side, side, side}, glisson::Shape::hexahedron);
  glisson::Section section;
  section.name = "block";
  section.formulation = glisson::Formulation::h8;
  section.material = {.law = "NH", .parameters = {2000, 20000}, .density = density};
  section.elements.resize(static_cast<std::size_t>(model.mesh.element_count()));
  std::iota(section.elements.begin(), section.elements.end(), 0);
  model.sections.push_back(section);
  std::vector<int> nodes(model.mesh.X.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  model.initial_velocities.push_back({nodes, {speed, 0, 0}});
  model.time.total = 3;
  return model;
}

/// Time between the first two upward passages through the rest position [s]; 0: fewer than two.
double measured_period(glisson::AnySimulation& simulation) {
  double before = simulation.displacement()[0].x, first = -1;
  for (double t_before = simulation.time(); !simulation.finished(); t_before = simulation.time()) {
    simulation.step();
    const double now = simulation.displacement()[0].x;
    if (before < 0 && now >= 0) {
      const double t = t_before + (simulation.time() - t_before) * before / (before - now);
      if (first >= 0) return t - first;
      first = t;
    }
    before = now;
  }
  return 0;
}

}  // namespace

int main() {
  const auto model = moving_block();
  const auto simulation =
      glisson::make_simulation(model, {.device = "cpu", .precision = glisson::Precision::double_precision});
  simulation->add(std::make_unique<CentreSpring>(stiffness));
  const double period = measured_period(*simulation);

  const double exact = 2 * std::numbers::pi * std::sqrt(density * side * side * side / stiffness);
  // Central difference shortens the period by (omega dt)^2 / 24 to first order; a sine is straight where it
  // passes 0, so that the interpolation adds less. Twice the first term is allowed.
  const double omega_dt = 2 * std::numbers::pi / exact * simulation->report().dt;
  const double tolerance = omega_dt * omega_dt / 12 + 1e-9;
  std::cout.precision(10);
  std::cout << "period " << period << " s, exact " << exact << " s, tolerance " << tolerance * exact
            << " s\n";
  return std::abs(period / exact - 1) <= tolerance ? 0 : 1;
}
