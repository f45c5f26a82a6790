// A model that has nearly everything in it.
#pragma once

#include <glisson/core/mesh/surface.hpp>

#include <tests/shells/sheets.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {

/// Solids of two laws with viscosity, under a skin of shells where they are tetrahedra, every kind of load
/// and constraint, rigid bodies and a rigid surface.
inline Model everything(Formulation formulation) {
  Model model = box_model({6, 6, 6}, {0.06, 0.06, 0.06}, formulation, {"NH", {1000, 20000}}, 0.1);
  Section tail = model.sections[0];
  tail.elements.assign(model.sections[0].elements.begin() + 100, model.sections[0].elements.end());
  model.sections[0].elements.resize(100);
  tail.material.isochoric = {{0.3, 0.02}};
  model.sections.push_back(tail);
  const auto top = face(model.mesh, 2, 0.06), side = face(model.mesh, 1, 0.06);
  model.fixed = {{face(model.mesh, 0, 0)}};
  model.displacements = {{top, 1, {0.001}, smooth_curve(1)}};
  model.forces = {{side, 2, {1e-4}, ramp_curve(1)}};
  model.gravity = {{{}, {0, 0, -9.81}, ramp_curve(1)}};
  model.pressures = {{outer_surface(model.mesh), 10, ramp_curve(1)}};
  model.tractions = {{outer_surface(model.mesh), {{1, 2, 3}}, ramp_curve(1)}};
  model.springs = {{side, {{0, 0.001, 0}}, {0.5}, ramp_curve(1), step_curve(1), 1e-5}};
  model.planes = {{face(model.mesh, 1, 0), {0, 1, 0}}};
  RigidBody plate;
  plate.corners = {Vec3<double>{-1, -1, -0.001}, Vec3<double>{1, -1, -0.001}, Vec3<double>{-1, 1, -0.001}};
  model.bodies = {plate};
  RigidSurface floor;
  floor.surface.X = {{-1, -1, -0.002}, {1, -1, -0.002}, {0, 1, -0.002}};
  floor.surface.facets = {{{0, 1, 2, -1}}};
  floor.friction = 0.2;
  model.surfaces = {floor};
  for (const Facet& f : outer_surface(model.mesh))
    if (f.node_count() == 3) model.mesh.triangles.push_back({f.nodes[0], f.nodes[1], f.nodes[2]});
  if (!model.mesh.triangles.empty()) {
    ShellSection skin = shell_section(1000, 0.3, 0.001);
    skin.prony = {{0.3, 0.2}};
    skin.elements.resize(model.mesh.triangles.size());
    std::iota(skin.elements.begin(), skin.elements.end(), 0);
    model.shells = {skin};
  }
  model.time.total = 1;
  model.time.damping = 5;
  model.time.monitor_every = 1000;
  return model;
}

}  // namespace glisson::test
