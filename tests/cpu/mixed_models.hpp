// Models of one formulation and law with several sections, for tests that compare forms of the solids.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/core/model.hpp>

namespace glisson {

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

inline std::vector<double> parameters_of(const std::string& law) {
  if (law == "LE") return {3000, 0.45};
  if (law == "NH") return {1000, 10000};
  if (law == "AB") return {1000, 1.3, 10000};
  if (law == "PY") return {300, 200, 50, 40, 30, 10000};
  if (law == "TI") return {1000, 10000, 2000, 0.6, 0.8, 0};
  return {400, 2, 150, 4, 100, -2, 10000};
}

inline Section section_of(Formulation formulation, const std::string& law, bool viscous) {
  Section section;
  section.formulation = formulation;
  section.material.law = law;
  section.material.parameters = parameters_of(law);
  section.material.density = 1000;
  if (viscous) {
    section.material.isochoric = {{0.3, 0.1}, {0.2, 0.01}};
    section.material.volumetric = {{0.1, 0.05}};
  }
  return section;
}

/// Shuffled elements, alternating between two sections of one law and every seventh in a third one with
/// per-element values.
inline Model mixed_model(Formulation formulation, const std::string& law, bool viscous,
                         std::array<int, 3> cells = {6, 5, 4}) {
  Model model;
  model.mesh = box_mesh(cells, {0.1, 0.09, 0.08}, shape_of(formulation), 0.15, true);
  for (int s = 0; s < 3; ++s) model.sections.push_back(section_of(formulation, law, viscous && s < 2));
  model.sections[1].material.parameters[0] *= law == "LE" ? 2 : 1.5;
  std::vector<double> values;
  for (int e = 0; e < model.mesh.element_count(); ++e) {
    const std::size_t s = e % 7 == 0 ? 2 : e < model.mesh.element_count() / 2 ? 0 : 1;
    model.sections[s].elements.push_back(e);
    if (s == 2) values.push_back(parameters_of(law)[0] * (1 + 0.01 * (e % 50)));
  }
  model.sections[2].material.element_parameters = {{0, values}};
  return model;
}

inline Vec3<double> displacement(const Vec3<double>& X, double scale) {
  const double x = 20 * X.x, y = 20 * X.y, z = 20 * X.z, s = 0.05 * scale;
  return {s * (0.15 * std::sin(2 * y) + 0.1 * x * z - 0.05 * x), s * (-0.12 * y + 0.08 * std::sin(3 * x)),
          s * (0.1 * z * y + 0.06 * std::cos(2 * x + y))};
}

}  // namespace glisson
