// What a rigid surface says of a node's way in a step, so that a report need not look there again.
#include <gtest/gtest.h>

#include <random>

#include <glisson/contact/surface/surface_data.hpp>

#include "tests/contact/surfaces.hpp"

namespace glisson::contact {
namespace {

TEST(SurfaceShape, WhatIsFarFromAWayTouchesNoPointOfIt) {
  const TriangleSurface s = sphere({}, 1, 10, 14);
  SurfaceMesh mesh;
  mesh.X = s.x;
  for (const Triangle& t : s.triangles) mesh.facets.push_back({{t[0], t[1], t[2], -1}});
  const SurfaceData data = surface_data(mesh, {});
  const SurfaceShape<double> shape = data.shape();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-2.5, 2.5), step(-0.5, 0.5), share(0, 1);
  int far_ways = 0, touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3<double> from{at(random), at(random), at(random)};
    const Vec3<double> to = from + Vec3<double>{step(random), step(random), step(random)};
    const double offset = i % 2 ? 0 : 0.1 * share(random);
    bool far = false;
    const double depth = shape.penetration(from, to, offset, far).depth;
    touching += depth > 0;
    if (!far) continue;
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

}  // namespace
}  // namespace glisson::contact
