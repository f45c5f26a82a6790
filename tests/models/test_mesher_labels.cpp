// Meshes from label images: volumes, labels, conforming faces, pieces, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glisson/models/mesher/mesh_labels.hpp>
#include <map>
#include <set>

#include "tests/models/output_samples.hpp"

namespace glisson {
namespace {

LabelImage image_of(std::array<int, 3> size, std::array<double, 3> spacing, int fill = 0) {
  LabelImage image;
  image.size = size;
  for (std::size_t a = 0; a < 3; ++a) image.to_world[a][a] = spacing[a];
  image.labels.assign(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                          static_cast<std::size_t>(size[2]),
                      fill);
  return image;
}

std::int32_t& at(LabelImage& image, int i, int j, int k) {
  return image.labels[static_cast<std::size_t>(i + image.size[0] * (j + image.size[1] * k))];
}

/// An ellipsoid of label 1 with a smaller one of label 5 inside.
LabelImage organ() {
  LabelImage image = image_of({60, 50, 24}, {0.7, 0.9, 2});
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 60; ++i) {
        const double x = (i - 29.5) / 26, y = (j - 24.5) / 20, z = (k - 11.5) / 9.5,
                     r = x * x + y * y + z * z;
        at(image, i, j, k) = r > 1 ? 0 : r > 0.3 ? 1 : 5;
      }
  return image;
}

double volume(const Mesh& mesh, int e) {
  const auto n = mesh.element(e);
  const auto edge = [&](std::size_t a) {
    return mesh.X[static_cast<std::size_t>(n[a])] - mesh.X[static_cast<std::size_t>(n[0])];
  };
  return n.size() == 4 ? dot(cross(edge(1), edge(2)), edge(3)) / 6 : dot(cross(edge(1), edge(3)), edge(4));
}

double total_volume(const Mesh& mesh) {
  double sum = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    EXPECT_GT(volume(mesh, e), 0) << e;
    sum += volume(mesh, e);
  }
  return sum;
}

/// How many elements share each face; a conforming mesh has 1 or 2.
std::map<int, int> face_uses(const Mesh& mesh) {
  constexpr int tetrahedron[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  constexpr int hexahedron[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<std::vector<int>, int> faces;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto n = mesh.element(e);
    const auto add = [&](const auto& corners) {
      std::vector<int> face;
      for (const int c : corners) face.push_back(n[static_cast<std::size_t>(c)]);
      std::sort(face.begin(), face.end());
      ++faces[face];
    };
    if (n.size() == 4)
      for (const auto& face : tetrahedron) add(face);
    else
      for (const auto& face : hexahedron) add(face);
  }
  std::map<int, int> uses;
  for (const auto& [face, count] : faces) ++uses[count];
  return uses;
}

bool warns(const LabelMesh& mesh, const std::string& text) {
  return std::any_of(mesh.warnings.begin(), mesh.warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

TEST(MesherLabels, VolumesFollowTheImageAndLabelsAreKept) {
  const LabelImage image = organ();
  for (const Shape shape : {Shape::hexahedron, Shape::tetrahedron}) {
    const LabelMesh result = mesh_labels(image, {.voxel_mm = 1.5, .element = shape});
    ASSERT_EQ(result.regions.size(), 2u);
    EXPECT_EQ(result.regions[0].label, 1);
    EXPECT_EQ(result.regions[1].label, 5);
    double sum = 0;
    for (const MeshedRegion& region : result.regions) {
      // The staircase errs at random on the surface: 1.5 mm cubes on an organ of 36 mm.
      EXPECT_NEAR(region.mesh_mm3 / region.image_mm3, 1, 0.02) << region.label;
      EXPECT_EQ(region.element_count,
                std::count(result.mesh.label.begin(), result.mesh.label.end(), region.label));
      sum += region.mesh_mm3;
    }
    EXPECT_NEAR(total_volume(result.mesh), sum, 1e-9 * sum);
  }
}

TEST(MesherLabels, ElementsMeetFaceToFace) {
  for (const Shape shape : {Shape::hexahedron, Shape::tetrahedron}) {
    const LabelMesh result = mesh_labels(organ(), {.voxel_mm = 2, .element = shape});
    const auto uses = face_uses(result.mesh);
    EXPECT_EQ(uses.size(), 2u);
    EXPECT_GT(uses.at(2), uses.at(1));
    std::set<int> used(result.mesh.nodes.begin(), result.mesh.nodes.end());
    EXPECT_EQ(static_cast<int>(used.size()), result.mesh.node_count());
  }
}

TEST(MesherLabels, SixTetrahedraHaveTheSurfaceOfTheirCube) {
  const LabelMesh result =
      mesh_labels(image_of({2, 2, 2}, {1, 1, 1}, 3), {.voxel_mm = 2, .min_component = 1});
  EXPECT_EQ(result.mesh.element_count(), 6);
  EXPECT_EQ(result.mesh.node_count(), 8);
  EXPECT_EQ(face_uses(result.mesh), (std::map<int, int>{{1, 12}, {2, 6}}));
  EXPECT_DOUBLE_EQ(total_volume(result.mesh), 8);
}

TEST(MesherLabels, PositionsAreWorldCoordinatesOfVoxelCorners) {
  LabelImage image = image_of({3, 3, 3}, {1, 1, 1}, 1);
  image.to_world = {{{0, -2, 0, 10}, {2, 0, 0, 20}, {0, 0, -2, 30}}};  // turned and mirrored
  for (const Shape shape : {Shape::hexahedron, Shape::tetrahedron}) {
    const LabelMesh result = mesh_labels(image, {.voxel_mm = 2, .element = shape, .scale = 0.001});
    EXPECT_NEAR(total_volume(result.mesh), 27 * 8e-9, 1e-18);
    Vec3<double> low{1, 1, 1}, high{-1, -1, -1};
    for (const auto& X : result.mesh.X) {
      low = {std::min(low.x, X.x), std::min(low.y, X.y), std::min(low.z, X.z)};
      high = {std::max(high.x, X.x), std::max(high.y, X.y), std::max(high.z, X.z)};
    }
    EXPECT_NEAR(low.x, 0.005, 1e-15);  // index -0.5 ... 2.5 along each axis
    EXPECT_NEAR(high.x, 0.011, 1e-15);
    EXPECT_NEAR(low.y, 0.019, 1e-15);
    EXPECT_NEAR(low.z, 0.025, 1e-15);
    EXPECT_NEAR(high.z, 0.031, 1e-15);
  }
}

TEST(MesherLabels, HalfIsEnoughAndTiesGoToTheSmallerLabel) {
  LabelImage image = image_of({4, 2, 2}, {1, 1, 1});
  for (int j = 0; j < 2; ++j)
    for (int k = 0; k < 2; ++k) {
      at(image, 0, j, k) = 7;  // first coarse voxel: half background, half 7
      at(image, 2, j, k) = 9;  // second: half 9, half 4
      at(image, 3, j, k) = 4;
    }
  const MesherOptions options{.voxel_mm = 2, .element = Shape::hexahedron, .min_component = 1};
  EXPECT_EQ(mesh_labels(image, options).mesh.label, (std::vector{7, 4}));
  at(image, 0, 0, 0) = 0;  // 3 of 8
  const LabelMesh less = mesh_labels(image, options);
  EXPECT_EQ(less.mesh.label, (std::vector{4}));
  EXPECT_TRUE(warns(less, "label 7 (3 mm^3) fills no coarse voxel"));
}

TEST(MesherLabels, VoxelsNeedNotDivideTheCoarseOnes) {
  // A bar of 10 mm, voxels of 1 mm, cubes of 2.5 mm: 4 x 1 x 1 whole cubes (the other axes are 2.5 mm).
  const LabelImage image = image_of({10, 5, 5}, {1, 0.5, 0.5}, 1);
  const LabelMesh result =
      mesh_labels(image, {.voxel_mm = 2.5, .element = Shape::hexahedron, .min_component = 1});
  EXPECT_EQ(result.mesh.element_count(), 4);
  EXPECT_NEAR(total_volume(result.mesh), 62.5, 1e-12);
  // Finer than the image is possible too.
  EXPECT_EQ(mesh_labels(image, {.voxel_mm = 0.5, .element = Shape::hexahedron}).mesh.element_count(),
            20 * 5 * 5);
}

TEST(MesherLabels, SmallPiecesAreDroppedAndNamed) {
  LabelImage image = image_of({20, 4, 4}, {1, 1, 1});
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k)
        if (i < 8 || (i > 10 && i < 16) || (i == 18 && j == 0)) at(image, i, j, k) = 1;
  const MesherOptions options{.voxel_mm = 1, .element = Shape::hexahedron};
  LabelMesh result = mesh_labels(image, options);
  EXPECT_EQ(result.mesh.element_count(), (8 + 5) * 16);
  EXPECT_TRUE(warns(result, "dropped 1 separate piece(s) with 4 coarse voxel(s)"));
  EXPECT_TRUE(warns(result, "the mesh has 2 separate pieces"));
  MesherOptions largest = options;
  largest.largest_only = true;
  result = mesh_labels(image, largest);
  EXPECT_EQ(result.mesh.element_count(), 8 * 16);
  EXPECT_TRUE(warns(result, "dropped 2 separate piece(s) with 84"));
}

TEST(MesherLabels, PiecesThatTouchAtAnEdgeOrANodeAreCutApart) {
  LabelImage image = image_of({6, 6, 2}, {1, 1, 1});
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 2; ++k)
        if ((i < 3) == (j < 3)) at(image, i, j, k) = 1;  // two blocks share one edge of 3 nodes
  const LabelMesh edge = mesh_labels(image, {.voxel_mm = 1});
  EXPECT_TRUE(warns(edge, "cut 3 connection(s)"));
  EXPECT_EQ(edge.mesh.node_count(), 2 * 4 * 4 * 3);
  EXPECT_EQ(face_uses(edge.mesh).size(), 2u);

  LabelImage corner = image_of({4, 4, 4}, {1, 1, 1});
  for (int n = 0; n < 64; ++n) {
    const int i = n % 4, j = n / 4 % 4, k = n / 16;
    if ((i < 2 && j < 2 && k < 2) || (i > 1 && j > 1 && k > 1)) at(corner, i, j, k) = 2;
  }
  const LabelMesh node = mesh_labels(corner, {.voxel_mm = 1, .element = Shape::hexahedron});
  EXPECT_TRUE(warns(node, "cut 1 connection(s)"));
  EXPECT_EQ(node.mesh.node_count(), 2 * 27);
}

TEST(MesherLabels, ChosenLabelsOnlyAndOneRegion) {
  const LabelImage image = organ();
  const LabelMesh inner = mesh_labels(image, {.voxel_mm = 2, .labels = {5}});
  EXPECT_EQ(std::set<int>(inner.mesh.label.begin(), inner.mesh.label.end()), std::set{5});
  const LabelMesh one = mesh_labels(image, {.voxel_mm = 2, .one_region = true});
  EXPECT_EQ(std::set<int>(one.mesh.label.begin(), one.mesh.label.end()), std::set{1});
  EXPECT_EQ(one.regions.size(), 1u);
  EXPECT_EQ(one.mesh.element_count(), mesh_labels(image, {.voxel_mm = 2}).mesh.element_count());
}

TEST(MesherLabels, TheSameImageGivesTheSameMesh) {
  const LabelMesh a = mesh_labels(organ(), {.voxel_mm = 1.7}), b = mesh_labels(organ(), {.voxel_mm = 1.7});
  EXPECT_EQ(a.mesh.nodes, b.mesh.nodes);
  EXPECT_EQ(a.mesh.label, b.mesh.label);
  EXPECT_EQ(0, std::memcmp(a.mesh.X.data(), b.mesh.X.data(), a.mesh.X.size() * sizeof(a.mesh.X[0])));
}

TEST(MesherLabels, SaysWhyNothingCanBeMeshed) {
  const LabelImage image = organ();
  const auto refused = [&](const MesherOptions& options, ErrorKind kind, const std::string& says) {
    const std::string message = message_of([&] { mesh_labels(image, options); }, kind);
    EXPECT_NE(message.find(says), std::string::npos) << message;
  };
  refused({.voxel_mm = 0}, ErrorKind::usage, "the voxel size is 0 mm; it must be positive");
  refused({.voxel_mm = -3}, ErrorKind::usage, "-3 mm");
  refused({.voxel_mm = std::nan("")}, ErrorKind::usage, "must be positive");
  refused({.voxel_mm = HUGE_VAL}, ErrorKind::usage, "must be positive");
  refused({.voxel_mm = 1e-6}, ErrorKind::usage, "less than 1/32");
  refused({.voxel_mm = 0.07}, ErrorKind::usage, "elements, more than the limit of 20000000. Use");
  refused({.voxel_mm = 5, .max_elements = 10}, ErrorKind::usage, "more than the limit of 10");
  refused({.voxel_mm = 1e6}, ErrorKind::usage, "several times the whole image");
  refused({.voxel_mm = 60}, ErrorKind::input, "Use a smaller voxel size");
  refused({.voxel_mm = 5, .scale = 0}, ErrorKind::usage, "scale");
  refused({.voxel_mm = 5, .labels = {2, 3}}, ErrorKind::input, "The labels of the image are: 1 (");
  const std::string message = message_of(
      [] {
        mesh_labels(image_of({3, 3, 3}, {1, 1, 1}), {.voxel_mm = 1});
      },
      ErrorKind::input);
  EXPECT_NE(message.find("none, every voxel is 0"), std::string::npos) << message;
}

TEST(MesherLabels, AVoxelOfEveryLabelIsNoProblem) {
  LabelImage image = image_of({40, 40, 40}, {1, 1, 1});
  for (std::size_t i = 0; i < image.labels.size(); ++i) image.labels[i] = static_cast<int>(i) + 1;
  const LabelMesh result = mesh_labels(image, {.voxel_mm = 20, .element = Shape::hexahedron});
  EXPECT_EQ(result.mesh.label.front(), 1);  // all tie: the smallest
  EXPECT_NE(label_summary(image).find(" more"), std::string::npos);
}

}  // namespace
}  // namespace glisson
