// Small models that scenario tests share, built by hand.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/core/model.hpp>

namespace glisson::test {

inline std::vector<int> nodes_where(const Mesh& mesh, const std::function<bool(const Vec3<double>&)>& keep) {
  std::vector<int> nodes;
  for (int n = 0; n < mesh.node_count(); ++n)
    if (keep(mesh.X[static_cast<std::size_t>(n)])) nodes.push_back(n);
  return nodes;
}

/// Nodes of a box mesh where axis (0 x, 1 y, 2 z) has the given coordinate.
inline std::vector<int> face(const Mesh& mesh, int axis, double at) {
  return nodes_where(mesh, [=](const Vec3<double>& X) {
    const double c = axis == 0 ? X.x : axis == 1 ? X.y : X.z;
    return std::abs(c - at) < 1e-9;
  });
}

struct Material {
  std::string law;
  std::vector<double> parameters;
  double density = 1000;
};

inline Section section_of_all(const Mesh& mesh, Formulation formulation, const Material& material) {
  Section section;
  section.name = "all";
  section.formulation = formulation;
  section.material.law = material.law;
  section.material.parameters = material.parameters;
  section.material.density = material.density;
  section.elements.resize(static_cast<std::size_t>(mesh.element_count()));
  std::iota(section.elements.begin(), section.elements.end(), 0);
  return section;
}

inline Model box_model(std::array<int, 3> cells, Vec3<double> size, Formulation formulation,
                       const Material& material, double jitter = 0) {
  Model model;
  model.name = "box";
  model.mesh = box_mesh(cells, size, shape_of(formulation), jitter);
  model.sections = {section_of_all(model.mesh, formulation, material)};
  return model;
}

/// Shear and bulk modulus from Young's modulus and Poisson's ratio.
inline std::vector<double> mu_kappa(double E, double nu) {
  return {E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu))};
}

inline LoadCurve step_curve(double total) { return {LoadShape::step, 0, total}; }
inline LoadCurve ramp_curve(double total) { return {LoadShape::ramp, 0, total}; }
inline LoadCurve smooth_curve(double total) { return {LoadShape::poly345, 0, total}; }

/// Time settings of a quasi-static run.
inline TimeSettings relaxed(double force_tolerance = 1e-6, double displacement_tolerance = 1e-7) {
  TimeSettings time;
  time.total = 1;
  time.quasi_static = QuasiStatic{force_tolerance, displacement_tolerance, 200000};
  return time;
}

}  // namespace glisson::test
