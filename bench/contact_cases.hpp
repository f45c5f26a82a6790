// The experiments of Johnsen 2016, tables 5.1 and 5.2, as models: what the text tells is taken from it, the
// rest is chosen. Material, time and steps of "C" and "Zipper" are those of figure 5.10. Of the others the
// text gives the numbers of facets only; its totals of time differ by what 2,300 (ball and slab), 5,000 (two
// spheres) and 4,100 (rigid bar) refits would take.
#pragma once

#include <functional>
#include <numeric>
#include <string>

#include <bench/contact_shapes.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/model.hpp>

namespace glisson::bench {

struct ContactCase {
  std::string name;
  Model model;
};

/// Returns its nodes.
inline std::vector<int> add_solid(Model& model, Mesh mesh, double density, double scale = 1,
                                  const Vec3<double>& shift = {}) {
  const int first_node = model.mesh.node_count(), first = model.mesh.element_count();
  for (const auto& X : mesh.X) model.mesh.X.push_back(scale * X + shift);
  for (int e = 0; e < mesh.element_count(); ++e) {
    std::array<int, 4> nodes{};
    for (std::size_t a = 0; a < 4; ++a) nodes[a] = mesh.element(e)[a] + first_node;
    model.mesh.add_element(Shape::tetrahedron, nodes);
  }
  Section section;
  section.material.law = "NH";
  section.material.parameters = {10, 40};
  section.material.density = density;
  section.elements.resize(static_cast<std::size_t>(mesh.element_count()));
  std::iota(section.elements.begin(), section.elements.end(), first);
  model.sections.push_back(section);
  std::vector<int> nodes(mesh.X.size());
  std::iota(nodes.begin(), nodes.end(), first_node);
  return nodes;
}

inline std::vector<int> nodes_with(const Mesh& mesh, const std::function<bool(const Vec3<double>&)>& keep) {
  std::vector<int> nodes;
  for (int n = 0; n < mesh.node_count(); ++n)
    if (keep(mesh.X[static_cast<std::size_t>(n)])) nodes.push_back(n);
  return nodes;
}

/// steps 0: as many as the mesh needs.
inline void run_for(Model& model, double total, int steps) {
  model.time.total = total;
  if (steps > 0) model.time.step = total / steps;
}

/// The lower ends are held, the upper ones go down by 3.5, more than the gap is wide.
inline ContactCase closing_c(std::array<int, 3> cells = {28, 4, 4}, int steps = 2000) {
  ContactCase its{"C", {}};
  add_solid(its.model, c_shape(cells), 1);
  const Mesh& mesh = its.model.mesh;
  const auto upper = nodes_with(mesh, [](const auto& X) { return X.z > 6; });
  its.model.fixed.push_back({nodes_with(mesh, [](const auto& X) { return X.z < -6; }), all_axes});
  its.model.fixed.push_back({upper, 3});
  its.model.displacements.push_back({upper, 4, {-3.5}, {LoadShape::ramp, 0, 2}});
  its.model.contact.self = true;
  run_for(its.model, 2, steps);
  return its;
}

/// Forces on the two ends (sums of 30, 5 and 10) that grow over the run: they push the ends together, aside
/// in opposite directions, and down. With as much on each node the ends would pass each other.
inline ContactCase closing_zipper(std::array<int, 3> cells = {24, 5, 2}, int steps = 1333) {
  ContactCase its{"Zipper", {}};
  Model& model = its.model;
  add_solid(model, zipper_shape(cells), 100);
  for (const double side : {1.0, -1.0}) {
    const auto end = nodes_with(model.mesh, [&](const auto& X) { return side * (X.x - 17.5) < -17.4; });
    const double per_node = 1 / double(end.size());
    model.forces.push_back({end, 1, {side * 30 * per_node}, {LoadShape::ramp, 0, 100}});
    model.forces.push_back({end, 2, {side * 5 * per_node}, {LoadShape::ramp, 0, 100}});
    model.forces.push_back({end, 4, {-10 * per_node}, {LoadShape::ramp, 0, 100}});
  }
  model.contact.self = true;
  run_for(model, 100, steps);
  return its;
}

/// A ball of 768 facets flies at 2 % of the wave speed onto a slab of 732 that is held below, and rebounds.
inline ContactCase ball_and_slab(int n = 8, std::array<int, 3> slab = {9, 13, 3}, int steps = 2300) {
  ContactCase its{"Ball-slab", {}};
  Model& model = its.model;
  add_solid(model, box_mesh(slab, {4.5, 6.5, 1.5}, Shape::tetrahedron), 1);
  model.fixed.push_back({nodes_with(model.mesh, [](const auto& X) { return X.z < 1e-9; }), all_axes});
  const auto ball = add_solid(model, ball_shape({n, n, n}), 1, 2, {2.25, 3.25, 3.7});
  model.initial_velocities.push_back({ball, {0, 0, -0.15}});
  model.contact.between_bodies = true;
  run_for(model, 7, steps);
  return its;
}

/// Two balls of 900 facets hit each other, each at 0.7 % of the wave speed, and part.
inline ContactCase two_spheres(std::array<int, 3> cells = {9, 9, 8}, int steps = 5000) {
  ContactCase its{"Two spheres", {}};
  Model& model = its.model;
  for (const double side : {-1.0, 1.0}) {
    const auto ball = add_solid(model, ball_shape(cells), 1, 1, {side * 1.05, 0, 0});
    model.initial_velocities.push_back({ball, {-side * 0.05, 0, 0}});
  }
  model.contact.between_bodies = true;
  run_for(model, 5, steps);
  return its;
}

/// A rigid bar is pressed by 0.4 across a slab of 600 facets that is held below. Only the slab has update
/// nodes: the bar's own boxes never change.
inline ContactCase rigid_bar(std::array<int, 3> slab = {9, 12, 2}, int steps = 4100) {
  ContactCase its{"Rigid bar", {}};
  Model& model = its.model;
  add_solid(model, box_mesh(slab, {4.5, 6, 1}, Shape::tetrahedron), 1);
  model.fixed.push_back({nodes_with(model.mesh, [](const auto& X) { return X.z < 1e-9; }), all_axes});
  const Mesh bar = box_mesh({10, 2, 2}, {8, 1, 1}, Shape::tetrahedron);
  RigidSurface surface;
  surface.name = "bar";
  surface.surface = {bar.X, outer_surface(bar)};
  for (auto& X : surface.surface.X) X = X + Vec3<double>{-1.75, 2.5, 1.05};
  surface.displacement = {0, 0, -0.45};
  surface.motion = {LoadShape::poly345, 0, 8};
  model.surfaces.push_back(surface);
  run_for(model, 8, steps);
  return its;
}

}  // namespace glisson::bench
