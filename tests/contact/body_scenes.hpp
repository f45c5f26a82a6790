// Bodies in contact that several tests look at.
#pragma once

#include <tests/contact/bodies.hpp>

namespace glisson::test {

/// A small block that flies at a larger one, obliquely, and slides on it with friction.
inline Model sliding_block() {
  Model model;
  const Material rubber{"NH", mu_kappa(1e4, 0.3), 1000};
  add_body(model, box_mesh({24, 24, 2}, {0.24, 0.24, 0.02}, Shape::tetrahedron, 0.1), Formulation::t4,
           rubber);
  Mesh upper = box_mesh({17, 16, 3}, {0.12, 0.12, 0.03}, Shape::hexahedron);
  move(upper, {0.05, 0.04, 0.0201});
  const Body block = add_body(model, upper, Formulation::h8, rubber);
  model.initial_velocities.push_back({block.nodes(), {0.1, 0.05, -0.05}});
  model.contact.between_bodies = true;
  model.contact.friction = 0.4;
  model.time.total = 0.03;
  return model;
}

/// Two soft blocks of tetrahedra on each other, 6 x 6 and 7 x 7 cells at the interface, free to spread,
/// pressed by a share of their height of 0.06 within `ramp` of the one second that the run takes. (Hexahedra
/// with one point buckle there without any contact.)
struct PressedBlocks {
  Model model;
  Body above;
};
inline PressedBlocks pressed_blocks(double share, double ramp, double damping) {
  PressedBlocks its;
  Model& model = its.model;
  const Material soft{"NH", mu_kappa(3000, 0.45), 1000};
  add_body(model, box_mesh({6, 6, 5}, {0.06, 0.06, 0.03}, Shape::tetrahedron), Formulation::t4, soft);
  Mesh upper = box_mesh({7, 7, 5}, {0.06, 0.06, 0.03}, Shape::tetrahedron);
  move(upper, {0, 0, 0.03});
  its.above = add_body(model, upper, Formulation::t4, soft);
  model.fixed.push_back({face(model.mesh, 2, 0), 4});
  model.fixed.push_back({face(model.mesh, 0, 0), 1});
  model.fixed.push_back({face(model.mesh, 1, 0), 2});
  model.displacements.push_back({face(model.mesh, 2, 0.06), 4, {-0.06 * share}, smooth_curve(ramp)});
  model.contact.between_bodies = true;
  model.time.total = 1;
  model.time.damping = damping;
  return its;
}

}  // namespace glisson::test
