// What pictures show beside the results: rigid bodies and marks, which parts of a shell, and units.
#include <gtest/gtest.h>

#include <cmath>

#include <glisson/viz/colouring.hpp>
#include <glisson/viz/model_shapes.hpp>
#include <glisson/viz/series.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

void expect_near(const Vec3<double>& a, const Vec3<double>& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(Shapes, SurfaceMeshesAreWhereTheirMotionHasThem) {
  Model model;
  RigidSurface floor;
  floor.name = "floor";
  floor.surface.X = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
  floor.surface.facets = {{{0, 1, 2, 3}}, {{1, 4, 2, -1}}};
  floor.angles = {0, 0, std::acos(-1.0) / 2};
  floor.centre = {1, 0, 0};
  floor.displacement = {0, 0, 4};
  floor.motion = ramp_curve(2);
  model.surfaces.push_back(floor);
  for (const double share : {0.0, 0.5, 1.0}) {
    const auto bodies = viz::bodies_at(model, 2 * share);
    ASSERT_EQ(bodies.size(), 1U);
    EXPECT_EQ(bodies[0].name, "floor");
    const double turn = share * std::acos(-1.0) / 2;
    expect_near(bodies[0].X[0], {1 - std::cos(turn), -std::sin(turn), 4 * share});
    expect_near(bodies[0].X[1], {1, 0, 4 * share});
    ASSERT_EQ(bodies[0].triangles.size(), 3U);
    EXPECT_EQ(bodies[0].triangles[1], (std::array<int, 3>{0, 2, 3}));
    EXPECT_EQ(bodies[0].triangles[2], (std::array<int, 3>{1, 4, 2}));
  }
}

TEST(Shapes, AnalyticBodiesAreAsLongAndWideAsTheyAre) {
  Model model;
  RigidBody body;
  body.origin = {0.1, 0.2, 0.3}, body.axis = {0, 0, 1}, body.radius = 0.01, body.length = 0.05;
  body.displacement = {0.02, 0, 0}, body.radius_change = 0.01, body.motion = ramp_curve(1);
  for (const auto shape : {RigidShape::cylinder, RigidShape::probe}) {
    body.shape = shape;
    model.bodies = {body};
    const auto drawn = viz::bodies_at(model, 1);
    double low = 1e300, high = -1e300, wide = 0;
    for (const auto& x : drawn.at(0).X) {
      low = std::min(low, x.z), high = std::max(high, x.z);
      wide = std::max(wide, std::hypot(x.x - 0.12, x.y - 0.2));
    }
    EXPECT_NEAR(low, 0.3, 1e-12);
    EXPECT_NEAR(high, shape == RigidShape::probe ? 0.37 : 0.35, 1e-12);
    EXPECT_NEAR(wide, 0.02, 1e-12);
    for (const auto& t : drawn[0].triangles)
      for (const int n : t) ASSERT_LT(n, static_cast<int>(drawn[0].X.size()));
  }
}

TEST(Shapes, EveryKindOfConditionHasItsMark) {
  Model model = box_model({1, 1, 1}, {1, 1, 1}, Formulation::h8, {"NH", {1000, 2000}});
  model.fixed.push_back({{0}, all_axes});
  model.displacements.push_back({{1}, 2, {-0.1}, {}});
  model.forces.push_back({{2}, 4, {3}, {}});
  model.pressures.push_back({{{{4, 5, 7, 6}}}, 20, {}});
  model.tractions.push_back({{{{0, 1, 5, 4}}}, {{0, 0, -2}}, {}});
  model.springs.push_back({{3, 6}, {{0, 0, 0}, {0.5, 0, 0}}, {1}, {}, {}, {}});
  model.planes.push_back({{7}, {1, 0, 0}});
  const auto marks = viz::marks_of(model, model.mesh.X, 1e-3);
  const auto one = [&](viz::MarkKind kind, const Vec3<double>& at, const Vec3<double>& direction) {
    for (const auto& m : marks)
      if (m.kind == kind && dot(m.at - at, m.at - at) < 1e-20) return expect_near(m.direction, direction);
    ADD_FAILURE() << "no mark " << viz::name_of(kind);
  };
  one(viz::MarkKind::fixed, {0, 0, 0}, {});
  one(viz::MarkKind::prescribed, {1, 0, 0}, {0, -1, 0});
  one(viz::MarkKind::force, {0, 1, 0}, {0, 0, 1});
  one(viz::MarkKind::pressure, {0.5, 0.5, 1}, {0, 0, -1});
  one(viz::MarkKind::force, {0.5, 0, 0.5}, {0, 0, -1});
  one(viz::MarkKind::force, {0, 1, 1}, {1, 0, 0});
  one(viz::MarkKind::sliding, {1, 1, 1}, {1, 0, 0});
  EXPECT_EQ(marks.size(), 7U);  // a spring that only holds its place has none
}

TEST(Shapes, AMidSurfaceKnowsItsFaces) {
  const viz::Step step{0, {"a/b.vtu", "a/b_faces.vtp", "a/b.vtp", "a/c.vtp", "other/b.vtp"}};
  EXPECT_EQ(viz::faces_of_parts(step), (std::vector<int>{-1, -1, 1, -1, -1}));
}

TEST(Shapes, FieldsOfShellsHaveTheirUnits) {
  detail::RawMesh part;
  part.X = {{0, 0, 0}};
  for (const char* name : {"membrane_force", "moment", "curvature", "energy", "thickness"})
    part.point_arrays[name] = {1, {20}};
  const std::vector<detail::RawMesh> parts{part};
  const auto title = [&](const char* field, const char* units) {
    return viz::colour_by(parts, field, units).title;
  };
  EXPECT_EQ(title("membrane_force", "SI"), "membrane force [N/m]");
  EXPECT_EQ(title("membrane_force", "mm-kg-s"), "membrane force [N/m]");  // kg / s^2
  EXPECT_EQ(title("moment", "SI"), "moment [N]");
  EXPECT_EQ(title("moment", "mm-kg-s"), "moment [mN]");
  EXPECT_EQ(title("curvature", "SI"), "curvature [1/m]");
  EXPECT_EQ(title("curvature", "mm-kg-s"), "curvature [1/mm]");
  EXPECT_EQ(title("energy", "SI"), "energy [J]");
  EXPECT_EQ(title("energy", "mm-kg-s"), "energy [\u00b5J]");
  EXPECT_EQ(title("thickness", "mm-kg-s"), "thickness [mm]");
  EXPECT_EQ(title("moment", ""), "moment");
}

}  // namespace
}  // namespace glisson::test
