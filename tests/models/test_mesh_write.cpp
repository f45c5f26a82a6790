// What is written reads back as the same mesh; transforms and merging.
#include <gtest/gtest.h>
#include <glisson/models/mesh/read_mesh.hpp>
#include <glisson/models/mesh/transform.hpp>
#include <glisson/models/mesh/write_mesh.hpp>
#include <glisson/models/output/vtu_writer.hpp>

#include <chrono>
#include <cmath>
#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <set>
#include <sstream>
#include <tests/models/output_samples.hpp>

namespace glisson {
namespace {

void expect_same_arrays(const std::map<std::string, NamedArray>& a,
                        const std::map<std::string, NamedArray>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, array] : a) {
    ASSERT_TRUE(b.contains(name)) << name;
    EXPECT_EQ(array.components, b.at(name).components) << name;
    EXPECT_EQ(array.values, b.at(name).values) << name;
  }
}

void expect_same(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.X.size(), b.X.size());
  for (std::size_t n = 0; n < a.X.size(); ++n) {
    EXPECT_EQ(a.X[n].x, b.X[n].x) << n;
    EXPECT_EQ(a.X[n].y, b.X[n].y) << n;
    EXPECT_EQ(a.X[n].z, b.X[n].z) << n;
  }
  EXPECT_EQ(a.shape, b.shape);
  EXPECT_EQ(a.begin, b.begin);
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.label, b.label);
  expect_same_arrays(a.cell_arrays, b.cell_arrays);
  expect_same_arrays(a.point_arrays, b.point_arrays);
}

Mesh with_awkward_arrays() {
  Mesh mesh = mixed_mesh();
  mesh.cell_arrays["shear modulus 100%"] = {1, {1e-300, -2.5}};
  mesh.point_arrays["tensor"] = {9, std::vector<double>(81, 1.0 / 3)};
  return mesh;
}

TEST(MeshWrite, LegacyVtkReadsBackTheSame) {
  const Mesh mesh = with_awkward_arrays();
  for (const auto encoding : {Encoding::text, Encoding::binary}) {
    std::ostringstream out;
    write_vtk(out, mesh, encoding);
    expect_same(mesh, parse_solid_mesh(out.str(), "a.vtk", MeshFormat::vtk));
  }
}

TEST(MeshWrite, GmshReadsBackTheSameWithArraysPadded) {
  Mesh mesh = with_awkward_arrays();
  std::ostringstream out;
  write_gmsh(out, mesh);
  mesh.cell_arrays["stiffness"] = {3, {1000, 0.1, 0, 3000, 0.3, 0}};
  expect_same(mesh, parse_solid_mesh(out.str(), "a.msh", MeshFormat::gmsh));
}

TEST(MeshWrite, VtuReadsBackTheSame) {
  const Mesh mesh = with_awkward_arrays();
  std::ostringstream out;
  write_vtu(out, mesh, {}, VtuOptions{OutputPrecision::full});
  expect_same(mesh, parse_solid_mesh(out.str(), "a.vtu", MeshFormat::vtk_xml));
}

TEST(MeshWrite, ALargerVtuOfSeveralBlocksReadsBackTheSame) {
  const Mesh mesh = box_mesh({30, 30, 20}, {1, 1, 1}, Shape::tetrahedron, 0.1);
  std::ostringstream out;
  write_vtu(out, mesh, {}, VtuOptions{OutputPrecision::full});
  expect_same(mesh, parse_solid_mesh(out.str(), "a.vtu", MeshFormat::vtk_xml));
}

TEST(MeshWrite, FilesReadBackByTheirNames) {
  const auto folder = std::filesystem::temp_directory_path() / ("glisson_mesh_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const Mesh mesh = box_mesh({2, 2, 2}, {1, 2, 3}, Shape::hexahedron);
  for (const auto name : {"a.msh", "a.vtk", "a.vtu", "a.VTK"}) {
    const auto path = (folder / name).string();
    write_mesh(path, mesh);
    Mesh read = read_solid_mesh(path);
    if (std::string(name) == "a.msh") read.label.clear();  // Gmsh has a label for every element
    expect_same(mesh, read);
  }
  write_mesh((folder / "a.stl").string(), mesh);
  const auto surface = read_surface_mesh((folder / "a.stl").string());
  EXPECT_EQ(surface.facets.size(), 48U);
  EXPECT_EQ(surface.X.size(), 26U);
  EXPECT_THROW(write_mesh((folder / "a.xyz").string(), mesh), Error);
  EXPECT_THROW(write_surface((folder / "a.ply").string(), surface), Error);
  std::filesystem::remove_all(folder);
}

TEST(MeshWrite, ASurfaceEnclosesTheSameVolumeAfterStl) {
  const Mesh mesh = box_mesh({3, 2, 2}, {3, 2, 2}, Shape::tetrahedron);
  std::ostringstream out;
  write_stl(out, {mesh.X, outer_surface(mesh)});
  const auto surface = parse_surface_mesh(out.str(), "a.stl", MeshFormat::stl);
  double volume = 0;
  for (const auto& facet : surface.facets)
    volume += dot(facet_centre(facet, surface.X), area_vector(facet, surface.X)) / 3;
  EXPECT_NEAR(volume, 12, 1e-5);  // positions are single precision: 12 * 6e-8 * some facets
}

TEST(MeshTransform, RotatesAboutZFirstThenYThenXThenScalesThenMoves) {
  const Transform z{{1, 0, 0}, {0, 0, 90}, 1, {}};
  EXPECT_NEAR(transformed(z, {2, 0, 0}).x, 1, 1e-15);
  EXPECT_NEAR(transformed(z, {2, 0, 0}).y, 1, 1e-15);
  // e_x -> (Rz) e_y -> (Ry) e_y -> (Rx) e_z, then times 2, then + (0, 0, 5).
  const auto x = transformed({{}, {90, 90, 90}, 2, {0, 0, 5}}, {1, 0, 0});
  EXPECT_NEAR(x.x, 0, 1e-15);
  EXPECT_NEAR(x.y, 0, 1e-15);
  EXPECT_NEAR(x.z, 7, 1e-15);
  // The scale is about the origin, and acts on the centre too.
  EXPECT_NEAR(transformed({{1, 0, 0}, {0, 0, 180}, 3, {}}, {0, 0, 0}).x, 6, 1e-14);
  Mesh mesh = mixed_mesh();
  EXPECT_THROW(transform_nodes(Transform{{}, {}, -1, {}}, mesh.X), Error);
  EXPECT_THROW(transform_nodes(Transform{{}, {NAN, 0, 0}, 1, {}}, mesh.X), Error);
}

TEST(MeshMerge, JoinsTheFirstNodeStrictlyCloserThanTheDistance) {
  Mesh mesh;
  for (const double x : {0.0, 0.9, 1.8, 1.0, 0.5}) mesh.X.push_back({x, 0, 0});
  mesh.point_arrays["number"] = {1, {0, 1, 2, 3, 4}};
  // 0.9 joins 0; 1.8 is close to 0.9 only, which is gone; 1.0 is not closer than 1 to 0, but to 1.8; 0.5
  // joins 0.
  EXPECT_EQ(merge_nodes(mesh, 1), (std::vector<int>{0, 0, 1, 1, 0}));
  EXPECT_EQ(mesh.point_arrays["number"].values, (std::vector<double>{0, 2}));
  EXPECT_EQ(merge_nodes(mesh, 0), (std::vector<int>{0, 1}));
  EXPECT_THROW(merge_nodes(mesh, INFINITY), Error);
}

TEST(MeshMerge, AgreesWithTheDefinitionOnRandomNodes) {
  Mesh mesh = box_mesh({7, 6, 5}, {1, 1, 1}, Shape::hexahedron, 0.2, true);
  mesh.nodes.clear();
  mesh.shape.clear();
  mesh.begin = {0};
  const auto X = mesh.X;
  for (const double distance : {1e-200, 0.05, 0.12, 0.2, 3.0}) {
    std::vector<int> expected(X.size());
    std::vector<std::size_t> kept;
    for (std::size_t n = 0; n < X.size(); ++n) {
      std::size_t k = 0;
      while (k < kept.size() && !(std::sqrt(dot(X[kept[k]] - X[n], X[kept[k]] - X[n])) < distance)) ++k;
      if (k == kept.size()) kept.push_back(n);
      expected[n] = static_cast<int>(k);
    }
    Mesh merged = mesh;
    EXPECT_EQ(merge_nodes(merged, distance), expected) << distance;
    EXPECT_EQ(merged.X.size(), kept.size());
  }
}

TEST(MeshMerge, TwoBoxesBecomeOneAndADistanceThatIsTooLargeIsRefused) {
  Mesh mesh = box_mesh({4, 4, 4}, {1, 1, 1}, Shape::hexahedron);
  const Mesh other = box_mesh({4, 4, 4}, {1, 1, 1}, Shape::hexahedron);
  const int nodes = mesh.node_count();
  for (const auto& x : other.X) mesh.X.push_back({x.x + 1, x.y, x.z});
  for (int e = 0; e < other.element_count(); ++e) {
    std::vector<int> its_nodes(other.element(e).begin(), other.element(e).end());
    for (int& n : its_nodes) n += nodes;
    mesh.add_element(Shape::hexahedron, its_nodes);
  }
  Mesh too_far = mesh;
  merge_nodes(mesh, 1e-6);
  EXPECT_EQ(mesh.node_count(), 2 * nodes - 25);
  EXPECT_THROW(merge_nodes(too_far, 0.3), Error);
}

TEST(MeshMerge, TakesTimeInProportionToTheNodes) {
  Mesh mesh = box_mesh({50, 50, 40}, {1, 1, 1}, Shape::hexahedron);
  const auto start = std::chrono::steady_clock::now();
  merge_nodes(mesh, 1e-3);
  // 106 000 nodes take 0.1 s; with a search over all pairs it would be 10 s.
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 4);
}

TEST(MeshNodes, UnusedOnesAreDroppedWithTheirRows) {
  Mesh mesh = mixed_mesh();
  mesh.X.insert(mesh.X.begin() + 2, {9, 9, 9});
  for (int& n : mesh.nodes) n += n >= 2;
  mesh.point_arrays["distance"].values.insert(mesh.point_arrays["distance"].values.begin() + 2, 77);
  EXPECT_EQ(drop_unused_nodes(mesh), (std::vector<int>{0, 1, -1, 2, 3, 4, 5, 6, 7, 8}));
  expect_same(mesh, mixed_mesh());
}

}  // namespace
}  // namespace glisson
