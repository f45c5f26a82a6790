#include <glisson/core/solids/mass.hpp>

#include <algorithm>

#include <glisson/core/elements/hexahedron.hpp>
#include <glisson/core/mesh/triangles.hpp>

namespace glisson {
namespace {

double volume_of(const Mesh& mesh, int e) {
  const auto nodes = mesh.element(e);
  auto X = [&](std::size_t a) { return mesh.X[static_cast<std::size_t>(nodes[a])]; };
  if (nodes.size() == 4) return dot(cross(X(1) - X(0), X(2) - X(0)), X(3) - X(0)) / 6;
  Vec3<double> corners[8];
  for (std::size_t a = 0; a < 8; ++a) corners[a] = X(a);
  return mean_gradient(corners).volume;
}

void share_mass(const Mesh& mesh, int e, double mass, std::vector<double>& nodal) {
  const auto nodes = mesh.element(e);
  for (const int n : nodes) nodal[static_cast<std::size_t>(n)] += mass / double(nodes.size());
}

/// The step that every element is brought to; 0: none.
double wanted_step(const Model& model) {
  if (!model.time.quasi_static) return model.time.mass_scaling_step.value_or(0);
  double largest = 0;
  visit_element_steps(model,
                      [&](int, double dt, double, double, double) { largest = std::max(largest, dt); });
  return largest;
}

}  // namespace

std::vector<double> lumped_mass(const Model& model) {
  std::vector<double> nodal(model.mesh.X.size());
  for (const Section& section : model.sections)
    for (const int e : section.elements)
      share_mass(model.mesh, e, section.material.density * volume_of(model.mesh, e), nodal);
  for (const ShellSection& section : model.shells)
    for (std::size_t k = 0; k < section.elements.size(); ++k) {
      const auto& t = model.mesh.triangles[static_cast<std::size_t>(section.elements[k])];
      const double area = triangle_area(t, model.mesh.X);
      for (const int n : t)
        nodal[static_cast<std::size_t>(n)] += section.density_of(k) * section.thickness_of(k) * area / 3;
    }
  return nodal;
}

InertialMass inertial_mass(const Model& model) {
  InertialMass result;
  result.mass.assign(model.mesh.X.size(), 0.0);
  const double wanted = wanted_step(model);
  double total = 0, added = 0;
  visit_element_steps(model, [&](int e, double dt, double volume, double size, double rho) {
    const double mass = rho * volume, factor = dt < wanted ? (wanted / dt) * (wanted / dt) : 1;
    total += mass;
    added += mass * (factor - 1);
    share_mass(model.mesh, e, mass * factor, result.mass);
    const double step = std::max(dt, wanted);
    if (step < result.step.dt) result.step.dt = step, result.step.element = e;
    result.step.smallest_size = std::min(result.step.smallest_size, size);
  });
  result.added_share = total > 0 ? added / total : 0;
  return result;
}

}  // namespace glisson
