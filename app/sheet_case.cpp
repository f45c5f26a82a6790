#include <glisson/app/sheet_case.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glisson::app {

Model sheet_model(const SheetCase& c, int triangles, double total_time) {
  constexpr double side = 0.1;
  const int n = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / 2.0))));
  const double cell = side / n;
  Model model;
  model.name = "sheet";
  model.units = "SI";
  FixedNodes border;
  PrescribedDisplacement middle;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool inner = i > 0 && j > 0 && i < n && j < n;
      const double shift = inner ? 0.15 * cell : 0, x = i * cell + shift * std::sin(12.9898 * i + 78.233 * j),
                   y = j * cell + shift * std::sin(39.346 * i + 11.135 * j);
      (inner ? middle.nodes : border.nodes).push_back(static_cast<int>(model.mesh.X.size()));
      model.mesh.X.push_back({x, y, 0.02 * std::sin(60 * x) * std::cos(50 * y)});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = i + (n + 1) * j;
      model.mesh.triangles.push_back({a, a + 1, a + n + 2});
      model.mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  ShellSection section;
  section.formulation = c.formulation;
  section.law = c.law;
  section.parameters = c.parameters;
  section.bending_E = 6000, section.bending_nu = 0.45;
  section.density = 1000;
  section.thickness = std::min(0.001, 0.5 * cell);
  section.elements.resize(model.mesh.triangles.size());
  std::iota(section.elements.begin(), section.elements.end(), 0);
  model.shells.push_back(section);
  middle.nodes = {middle.nodes[middle.nodes.size() / 2]};
  middle.axes = 4;
  middle.values = {0.01};
  middle.curve = {LoadShape::poly345, 0, total_time, false, {}};
  model.fixed.push_back(border);
  model.displacements.push_back(middle);
  model.time.total = total_time;
  model.time.damping = 5;
  return model;
}

}  // namespace glisson::app
