// What a rigid surface says of a node's way in a step, so that a report need not look there again.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glisson/contact/surface/surface_data.hpp>

#include "tests/contact/surfaces.hpp"

namespace glisson::contact {
namespace {

SurfaceData data_of(const TriangleSurface& s) {
  SurfaceMesh mesh;
  mesh.X = s.x;
  for (const Triangle& t : s.triangles) mesh.facets.push_back({{t[0], t[1], t[2], -1}});
  return surface_data(mesh, {});
}

TEST(SurfaceShape, WhatIsFarFromAWayTouchesNoPointOfIt) {
  const SurfaceData data = data_of(sphere({}, 1, 10, 14));
  const SurfaceShape<double> shape = data.shape();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-2.5, 2.5), step(-0.5, 0.5), share(0, 1);
  int far_ways = 0, touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3<double> from{at(random), at(random), at(random)};
    const Vec3<double> to = from + Vec3<double>{step(random), step(random), step(random)};
    const double offset = i % 2 ? 0 : 0.1 * share(random);
    Surroundings<double> around;
    const double depth = shape.penetration(from, to, offset, around).depth;
    touching += depth > 0;
    if (!around.far) continue;
    ++far_ways;
    EXPECT_EQ(depth, 0);
    for (const double t : {0.0, share(random), 1.0}) {
      const Vec3<double> p = from + t * (to - from);
      EXPECT_EQ(shape(p, p, offset).depth, 0) << "way " << i << " at " << t;
    }
  }
  EXPECT_GT(far_ways, 2000);
  EXPECT_GT(touching, 500);
}

/// Ways within what is clear around a point: as many as there are.
int clear_ways(const SurfaceData& data, unsigned seed) {
  const SurfaceShape<double> shape = data.shape();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-2.5, 2.5), share(0, 1), any(-1, 1);
  int ways = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3<double> p{at(random), at(random), at(random)};
    const double offset = i % 2 ? 0 : 0.1 * share(random);
    Surroundings<double> around;
    shape.penetration(p, p, offset, around);
    const double room = around.clear - offset;
    if (!(room > 0)) continue;
    const auto near = [&] {
      const Vec3<double> way{any(random), any(random), any(random)};
      return p + 0.999 * room * share(random) / std::sqrt(dot(way, way)) * way;
    };
    const Vec3<double> from = near(), to = near();
    EXPECT_EQ(shape(from, to, offset).depth, 0) << "point " << i;
    ++ways;
  }
  return ways;
}

TEST(SurfaceShape, NothingTouchesWithinWhatIsClearAroundAPoint) {
  EXPECT_GT(clear_ways(data_of(sphere({}, 1, 10, 14)), 3), 15000);
  TriangleSurface floor = sphere({}, 1, 10, 14);
  std::erase_if(floor.triangles, [&](const Triangle& t) { return floor.x[std::size_t(t[0])].z < 0.1; });
  EXPECT_GT(clear_ways(data_of(floor), 5), 10000);
}

TEST(SurfaceShape, AFacetThatIsKnownSparesOthersAndChangesNothing) {
  const SurfaceData data = data_of(sphere({}, 1, 10, 14));
  const SurfaceShape<double> shape = data.shape();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-1.2, 1.2), step(-0.2, 0.2);
  int touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3<double> from{at(random), at(random), at(random)};
    const Vec3<double> to = from + Vec3<double>{step(random), step(random), step(random)};
    Surroundings<double> around, again;
    const auto expected = shape.penetration(from, to, 0.01, around);
    if (around.closest == 0) continue;
    const auto found = shape.penetration(from, to, 0.01, again, around.closest + 1e-9);
    EXPECT_EQ(found.depth, expected.depth) << "way " << i;
    EXPECT_EQ(dot(found.out - expected.out, found.out - expected.out), 0) << "way " << i;
    EXPECT_EQ(again.closest, around.closest);
    touching += found.depth > 0;
  }
  EXPECT_GT(touching, 2000);
}

}  // namespace
}  // namespace glisson::contact
