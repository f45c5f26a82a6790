// What starts a little behind something rigid comes out evenly, whatever that is.
#include <functional>

#include "tests/contact/surface_scene.hpp"
#include "tests/support/cases.hpp"
#include "tests/support/models.hpp"
#include "tests/support/same_bits.hpp"

namespace glisson::contact {
namespace {

constexpr double depth = 0.002;  ///< of edges of 0.025 [m]

/// A block that floats, its lowest nodes behind z = 0 and above (1.05, 1.05).
Model block() {
  Model model;
  model.mesh = box_mesh({4, 4, 4}, {0.1, 0.1, 0.1}, Shape::hexahedron);
  for (auto& X : model.mesh.X) X = X + Vec3<double>{1, 1, -depth};
  model.sections = {test::section_of_all(model.mesh, Formulation::h8, {"NH", {1e4, 2e4}, 1000})};
  model.time.total = 1;
  return model;
}
RigidBody plate() {
  RigidBody plate;
  plate.corners = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  return plate;
}
/// Its highest line, or its tip, at z = 0.
RigidBody round_body(RigidShape shape) {
  RigidBody body;
  body.shape = shape;
  body.radius = 2;
  body.length = 2;
  body.axis = shape == RigidShape::probe ? Vec3<double>{0, 0, 1} : Vec3<double>{0, 1, 0};
  body.origin = shape == RigidShape::probe ? Vec3<double>{1.05, 1.05, -4} : Vec3<double>{1.05, 0, -2};
  return body;
}

struct Scene {
  const char* name;
  std::function<void(Model&)> add;
};
const Scene scenes[] = {
    {"surface", [](Model& m) { m.surfaces = {floor_of(1)}; }},
    {"plate", [](Model& m) { m.bodies = {plate()}; }},
    {"cylinder", [](Model& m) { m.bodies = {round_body(RigidShape::cylinder)}; }},
    {"probe", [](Model& m) { m.bodies = {round_body(RigidShape::probe)}; }},
};
Model model_of(const Scene& scene) {
  Model model = block();
  scene.add(model);
  return model;
}

/// Lifted at the speed at which the depth is taken back, not thrown: in one step that were 0.2 m/s and more.
TEST(StartingBehind, ComesOutEvenly) {
  for (const Scene& scene : scenes)
    for (const test::Case& c : {test::serial_double, test::threads_float, test::emulated_float}) {
      SCOPED_TRACE(std::string(scene.name) + " " + c.name);
      const Model model = model_of(scene);
      auto simulation = test::simulate(model, c);
      EXPECT_NEAR(simulation->contacts().at(0).report.start_depth, depth, 1e-6);
      double fastest = 0;
      while (!simulation->finished()) {
        simulation->step(5);
        for (const auto& v : simulation->velocity()) fastest = std::max(fastest, std::sqrt(dot(v, v)));
        if (simulation->time() > 0.11) {
          EXPECT_GT(simulation->displacement()[12].z, depth - 1e-5) << simulation->time();
        }
      }
      EXPECT_LT(fastest, 4 * depth / 0.1);
      EXPECT_LT(simulation->contacts().at(0).report.depth, 1e-6);
    }
}

/// Interrupted while nodes come out.
TEST(StartingBehind, ARestartGivesTheSameBits) {
  for (const Scene& scene : scenes)
    for (const test::Case& c : {test::serial_double, test::threads_float}) {
      SCOPED_TRACE(std::string(scene.name) + " " + c.name);
      const Model model = model_of(scene);
      const int steps = static_cast<int>(test::simulate(model, c)->report().planned_steps);
      test::expect_same_bits_resumed(model, c, steps / 20, steps - steps / 20);
    }
}

/// A quasi-static run without a total time has a ramp of pseudo time.
TEST(StartingBehind, ComesOutOverTheRampOfQuasiStaticRuns) {
  Model model = model_of(scenes[1]);
  model.time.total = 0;
  model.time.quasi_static = QuasiStatic{};
  auto simulation = test::simulate(model, test::serial_double);
  simulation->step(2);
  EXPECT_LT(simulation->time(), 0.1 * pseudo_time);
  EXPECT_LT(simulation->displacement()[12].z, 0.5 * depth);
}

}  // namespace
}  // namespace glisson::contact
