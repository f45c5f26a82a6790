#include <glisson/core/mesh/box_mesh.hpp>

#include <gtest/gtest.h>

#include <glisson/core/base/error.hpp>

namespace glisson {
namespace {

double six_volumes(const Mesh& mesh, int a, int b, int c, int d) {
  auto X = [&](int n) { return mesh.X[static_cast<std::size_t>(n)]; };
  return dot(cross(X(b) - X(a), X(c) - X(a)), X(d) - X(a));
}

TEST(BoxMesh, TetrahedraFillTheBoxAndAreNotInverted) {
  for (const bool shuffled : {false, true}) {
    const Mesh mesh = box_mesh({3, 4, 5}, {0.3, 0.2, 1}, Shape::tetrahedron, 0.2, shuffled);
    EXPECT_EQ(mesh.element_count(), 6 * 60);
    EXPECT_EQ(mesh.node_count(), 4 * 5 * 6);
    double volume = 0;
    for (int e = 0; e < mesh.element_count(); ++e) {
      const auto n = mesh.element(e);
      const double v = six_volumes(mesh, n[0], n[1], n[2], n[3]) / 6;
      EXPECT_GT(v, 0);
      volume += v;
    }
    EXPECT_NEAR(volume, 0.06, 1e-15);
  }
}

TEST(BoxMesh, HexahedraHaveTheirTopAboveTheirBottom) {
  const Mesh mesh = box_mesh({2, 1, 3}, {2, 1, 3}, Shape::hexahedron);
  EXPECT_EQ(mesh.element_count(), 6);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto n = mesh.element(e);
    EXPECT_DOUBLE_EQ(six_volumes(mesh, n[0], n[1], n[3], n[4]), 1);
    EXPECT_DOUBLE_EQ(six_volumes(mesh, n[6], n[5], n[7], n[2]), 1);
  }
}

TEST(BoxMesh, RefusesWhatHasNoElements) {
  EXPECT_THROW(box_mesh({0, 1, 1}, {1, 1, 1}, Shape::tetrahedron), Error);
  EXPECT_THROW(box_mesh({1, 1, 1}, {1, 0, 1}, Shape::tetrahedron), Error);
  EXPECT_THROW(box_mesh({2000, 2000, 2000}, {1, 1, 1}, Shape::tetrahedron), Error);
}

}  // namespace
}  // namespace glisson
