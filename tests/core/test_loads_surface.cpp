// Pressure and traction: resultants against closed forms.
#include <glisson/core/base/error.hpp>

#include "tests/core/loaded_nodes.hpp"

namespace glisson {
namespace {

const LoadCurve always{LoadShape::step};

/// Unit cube at `corner`: node i has the bits of i as coordinates; 6 quadrilaterals outward, and the same as
/// 12 triangles.
struct Cube {
  explicit Cube(Vec3<double> corner = {}) {
    for (int i = 0; i < 8; ++i)
      mesh.X.push_back(corner + Vec3<double>{double(i & 1), double(i >> 1 & 1), double(i >> 2)});
    const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& n : faces) {
      quads.push_back({{n[0], n[1], n[2], n[3]}});
      triangles.push_back({{n[0], n[1], n[2], -1}});
      triangles.push_back({{n[0], n[2], n[3], -1}});
    }
  }
  Mesh mesh;
  std::vector<Facet> quads, triangles;
};

Vec3<double> moment(const std::vector<Vec3<double>>& X, const std::vector<Vec3<double>>& u,
                    const std::vector<Vec3<double>>& f) {
  Vec3<double> sum;
  for (std::size_t n = 0; n < X.size(); ++n) sum = sum + cross(X[n] + u[n], f[n]);
  return sum;
}
/// An affine displacement: parallelograms stay parallelograms.
Vec3<double> affine(const Vec3<double>& X) {
  return {0.3 * X.x + 0.2 * X.y - 0.1 * X.z, -0.1 * X.x + 0.15 * X.y + 0.4 * X.z, 0.25 * X.y - 0.2 * X.z};
}
/// Rotation by 90 degrees about z, then a shift: as displacement.
Vec3<double> quarter_turn(const Vec3<double>& X) { return Vec3<double>{-X.y + 2, X.x, X.z} - X; }

using SurfaceLoads = BenchTest;
GLISSON_BENCH_CASES(SurfaceLoads);

TEST_P(SurfaceLoads, PressureOnAClosedSurfaceHasNoResultant) {
  const Cube cube;
  for (const auto& facets : {cube.quads, cube.triangles}) {
    const auto bench = loaded_nodes(GetParam(), 8);
    const auto load = bench->load(Pressure{facets, 3, always}, cube.mesh);
    for (std::size_t n = 0; n < 8; ++n) bench->u[n] = affine(cube.mesh.X[n]);
    const auto& f = bench->forces(*load);
    expect_near(sum_of(f), {}, 5 * bench->tolerance());
    expect_near(moment(cube.mesh.X, bench->u, f), {}, 5 * bench->tolerance());
    EXPECT_GT(dot(f[0], f[0]), 0.1);
  }
}

TEST_P(SurfaceLoads, PressurePushesAgainstTheOutwardNormalAndFollowsIt) {
  const Cube cube;
  for (const auto& facets :
       {std::vector{cube.quads[5]}, std::vector{cube.triangles[10], cube.triangles[11]}}) {  // x = 1
    const auto bench = loaded_nodes(GetParam(), 8);
    const auto load = bench->load(Pressure{facets, 5, always}, cube.mesh);
    expect_near(sum_of(bench->forces(*load)), {-5, 0, 0}, 5 * bench->tolerance());
    for (std::size_t n = 0; n < 8; ++n) bench->u[n] = quarter_turn(cube.mesh.X[n]);
    expect_near(sum_of(bench->forces(*load)), {0, -5, 0}, 5 * bench->tolerance());
    for (std::size_t n = 0; n < 8; ++n) bench->u[n] = 2.0 * cube.mesh.X[n];  // nine times the area
    expect_near(sum_of(bench->forces(*load)), {-45, 0, 0}, 45 * bench->tolerance());
  }
}

TEST_P(SurfaceLoads, QuadrilateralsShareEquallyAmongTheirCorners) {
  const Cube cube;
  const auto bench = loaded_nodes(GetParam(), 8);
  const auto load = bench->load(Pressure{{cube.quads[5]}, 8, always}, cube.mesh);
  const auto& f = bench->forces(*load);
  for (const std::size_t n : {1, 3, 5, 7}) expect_near(f[n], {-2, 0, 0}, 0);
  for (const std::size_t n : {0, 2, 4, 6}) expect_near(f[n], {}, 0);
}

TEST_P(SurfaceLoads, TractionActsAsWrittenOnTheCurrentArea) {
  const Cube cube;
  const Vec3<double> traction{1, -2, 3};
  for (const auto& facets :
       {std::vector{cube.quads[5]}, std::vector{cube.triangles[10], cube.triangles[11]}}) {
    const auto bench = loaded_nodes(GetParam(), 8);
    const auto load = bench->load(Traction{facets, {traction}, always}, cube.mesh);
    expect_near(sum_of(bench->forces(*load)), traction, 3 * bench->tolerance());
    for (std::size_t n = 0; n < 8; ++n) bench->u[n] = quarter_turn(cube.mesh.X[n]);
    expect_near(sum_of(bench->forces(*load)), traction, 3 * bench->tolerance());  // the direction stays
    for (std::size_t n = 0; n < 8; ++n) bench->u[n] = cube.mesh.X[n];
    expect_near(sum_of(bench->forces(*load)), 4.0 * traction, 12 * bench->tolerance());
  }
}

TEST_P(SurfaceLoads, EachFacetMayHaveItsTraction) {
  const Cube cube;
  const auto bench = loaded_nodes(GetParam(), 8);
  const auto load =
      bench->load(Traction{{cube.quads[4], cube.quads[5]}, {{0, 0, 4}, {8, 0, 0}}, always}, cube.mesh);
  const auto& f = bench->forces(*load);
  expect_near(f[0], {0, 0, 1}, 0);
  expect_near(f[1], {2, 0, 0}, 0);
}

/// A facet of 1 mm far from the origin: X itself has only 4 digits of it in float.
TEST_P(SurfaceLoads, SmallFacetsFarAwayKeepTheirDigits) {
  Mesh mesh;
  mesh.X = {{100.0, 200.0, 300.0}, {100.001, 200.0, 300.0}, {100.0, 200.001, 300.0}};
  const auto bench = loaded_nodes(GetParam(), 3);
  const auto load = bench->load(Pressure{{{{0, 1, 2, -1}}}, 2e6, always}, mesh);
  EXPECT_NEAR(sum_of(bench->forces(*load)).z, -1, std::max(bench->tolerance(), 1e-9));
}

/// Uniform pressure on the moving face of a column: W = -p times the volume swept, exact for a linear motion.
TEST_P(SurfaceLoads, WorkOfPressureIsPressureTimesVolume) {
  const Cube cube;
  const auto bench = loaded_nodes(GetParam(), 8);
  const auto load = bench->load(Pressure{{cube.quads[5]}, 4, always}, cube.mesh);
  const double dt = 0.25;
  bench->step_count = 1;  // a run that is under way
  for (int n = 0; n <= 8; ++n) {
    for (const std::size_t k : {1, 3, 5, 7}) bench->u[k] = {-0.5 * n * dt, 0, 0}, bench->v[k] = {-0.5, 0, 0};
    bench->forces(*load, bench->view(n * dt, dt));
  }
  EXPECT_NEAR(load->work(), 4 * 1.0, 4 * bench->tolerance());
}

TEST_P(SurfaceLoads, RestartGivesTheSameBits) {
  const Cube cube;
  const auto bench = loaded_nodes(GetParam(), 8);
  const Pressure pressure{cube.triangles, 4, {LoadShape::ramp, 0, 1}};
  const auto load = bench->load(pressure, cube.mesh);
  const auto resumed = bench->load(pressure, cube.mesh);
  for (std::size_t n = 0; n < 8; ++n) bench->v[n] = affine(cube.mesh.X[n]);
  for (int n = 0; n < 4; ++n) bench->forces(*load, bench->view(0.1 * n, 0.1));
  resumed->load(load->save());
  bench->forces(*load, bench->view(0.4, 0.1));
  const auto f = bench->f;
  bench->forces(*resumed, bench->view(0.4, 0.1));
  for (std::size_t n = 0; n < 8; ++n) expect_near(bench->f[n], f[n], 0);
  EXPECT_EQ(load->work(), resumed->work());
  EXPECT_NE(load->work(), 0);
  EXPECT_EQ(load->save(), resumed->save());
}

TEST(SurfaceLoadsInput, RejectsBadLists) {
  const Cube cube;
  const auto bench = loaded_nodes(BenchCase::serial_double, 8);
  const auto load = [&](const Traction& traction) { bench->load(traction, cube.mesh); };
  EXPECT_THROW(load({{{{0, 1, 9, -1}}}, {{1, 0, 0}}, always}), Error);
  EXPECT_THROW(load({cube.quads, {{1, 0, 0}, {1, 0, 0}}, always}), Error);
}

}  // namespace
}  // namespace glisson
