#include <glisson/app/box_case.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glisson/core/mesh/box_mesh.hpp>

namespace glisson::app {

Model box_model(const BoxCase& c, int elements, double total_time) {
  constexpr double side = 0.1;
  const Shape shape = shape_of(c.formulation);
  const double bricks = shape == Shape::tetrahedron ? elements / 6.0 : elements;
  const int n = std::max(1, static_cast<int>(std::lround(std::cbrt(bricks))));
  Model model;
  model.name = "box";
  model.units = "SI";
  model.mesh = box_mesh({n, n, n}, {side, side, side}, shape, c.jitter);
  Section section;
  section.name = c.name;
  section.formulation = c.formulation;
  section.material.law = c.law;
  section.material.parameters = c.parameters;
  section.material.density = 1000;
  if (c.viscous) section.material.isochoric = {{0.3, 0.1}, {0.2, 1}};
  section.elements.resize(static_cast<std::size_t>(model.mesh.element_count()));
  std::iota(section.elements.begin(), section.elements.end(), 0);
  model.sections.push_back(section);

  PrescribedDisplacement top;
  top.axes = 4;
  top.values = {-0.1 * side};
  top.curve = {LoadShape::poly345, 0, total_time, false, {}};
  FixedNodes bottom;
  for (int i = 0; i < model.mesh.node_count(); ++i) {
    const double z = model.mesh.X[static_cast<std::size_t>(i)].z;
    if (z < 1e-9) bottom.nodes.push_back(i);
    if (z > side - 1e-9) top.nodes.push_back(i);
  }
  model.fixed.push_back(bottom);
  model.displacements.push_back(top);
  model.time.total = total_time;
  model.time.damping = 5;
  return model;
}

}  // namespace glisson::app
