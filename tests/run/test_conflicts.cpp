// No loop body of a run touches what another index writes: on a GPU that would be a race, which the random
// orders of the emulated device show only where they change a result.
#include <gtest/gtest.h>

#include <tests/contact/sheets.hpp>
#include <tests/run/everything.hpp>

namespace glisson::test {
namespace {

constexpr Case checked{"Checked", "emulated:conflicts", Precision::single_precision};

void expect_no_conflicts(const Model& model, const std::string& name, int steps = 6) {
  SCOPED_TRACE(name);
  EXPECT_NO_THROW({
    auto simulation = simulate(model, checked);
    simulation->step(steps);
    simulation->velocity();
  });
}

TEST(Conflicts, AreNotInSolidsShellsLoadsAndRigidContact) {
  for (const auto formulation :
       {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_full}) {
    Model model = everything(formulation);
    model.time.monitor_every = 2;
    expect_no_conflicts(model, std::string(name_of(formulation)) + " with contact");
    model.bodies.clear(), model.surfaces.clear();  // the steps end with a sweep
    expect_no_conflicts(model, std::string(name_of(formulation)) + " without contact");
    model.time.damping = 0;
    expect_no_conflicts(model, std::string(name_of(formulation)) + " without damping");
  }
}

TEST(Conflicts, AreNotInRelaxation) {
  Model model = everything(Formulation::t4anp);
  model.time.quasi_static = QuasiStatic{1e-3, 1e-3, 100};
  expect_no_conflicts(model, "relaxation", 25);
}

/// Blocks of hexahedra and tetrahedra with a sheet between them, all pressed into each other.
Model pressed_pile() {
  Model model;
  const Material rubber{"NH", mu_kappa(3000, 0.3), 1000};
  add_body(model, box_mesh({3, 3, 2}, {0.1, 0.1, 0.05}, Shape::hexahedron), Formulation::h8, rubber);
  Mesh upper = box_mesh({4, 4, 2}, {0.1, 0.1, 0.05}, Shape::tetrahedron);
  move(upper, {0, 0, 0.052});
  const Body block = add_body(model, upper, Formulation::t4, rubber);
  const ShellSection section = membrane_section("NeoHookean", {2000}, 0.001);
  add_sheet(
      model, 4, 4,
      [](double s, double t) {
        return Vec3<double>{0.1 * s, 0.1 * t, 0.051};
      },
      section);
  model.initial_velocities.push_back({block.nodes(), {0.1, 0, -1}});
  model.contact.between_bodies = model.contact.self = true;
  model.contact.friction = 0.3;
  model.time.total = 0.02;
  return model;
}

TEST(Conflicts, AreNotInContactOfDeformableBodies) {
  const Model model = pressed_pile();
  auto simulation = simulate(model, checked);
  EXPECT_NO_THROW(simulation->step(20));
  EXPECT_GT(simulation->contacts().at(0).report.node_count, 0) << "nothing touches";
}

TEST(Conflicts, AreNotInTiedSurfaces) {
  Model model = pressed_pile();
  model.contact = {};
  for (auto& X : model.mesh.X)
    if (X.z > 0.0515) X.z -= 0.002;
  model.ties.push_back({"tie", model.bodies_by_name[1].name, model.bodies_by_name[0].name, {}});
  expect_no_conflicts(model, "tie");
}

}  // namespace
}  // namespace glisson::test
