// Every mesh format and encoding gives the same small mesh.
#include <gtest/gtest.h>
#include <glisson/core/base/error.hpp>
#include <glisson/models/mesh/read_mesh.hpp>

#include <fstream>
#include <sstream>
#include <tests/models/mesh_files.hpp>

namespace glisson::test {
namespace {

void expect_two_tetrahedra(const std::string& text, MeshFormat format, std::vector<int> labels = {3, 4}) {
  Warnings warnings;
  const Mesh mesh = parse_solid_mesh(text, "made here", format, &warnings);
  ASSERT_EQ(mesh.node_count(), 5);
  EXPECT_EQ(mesh.X[4].y, 0.5);
  EXPECT_EQ(mesh.X[4].z, -1);
  EXPECT_EQ(mesh.shape, (std::vector{Shape::tetrahedron, Shape::tetrahedron}));
  EXPECT_EQ(mesh.nodes, (std::vector<int>{0, 1, 2, 3, 0, 1, 4, 2}));  // the second one is turned
  EXPECT_EQ(mesh.label, labels);
  ASSERT_TRUE(mesh.cell_arrays.contains("E"));
  EXPECT_EQ(mesh.cell_arrays.at("E").values, (std::vector<double>{1000, 2000.5}));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("made here: 1 tetrahedra"), std::string::npos) << warnings[0];
}

TEST(MeshRead, Gmsh2) {
  for (const auto code : {Code::text, Code::little, Code::big})
    expect_two_tetrahedra(gmsh_2(code), MeshFormat::gmsh);
}

TEST(MeshRead, Gmsh4WithEntitiesAndParametricNodes) {
  for (const auto code : {Code::text, Code::little, Code::big})
    expect_two_tetrahedra(gmsh_4(code), MeshFormat::gmsh);
}

TEST(MeshRead, GmshFileOfGmshItself) {
  for (const auto name : {"gmsh41.msh", "gmsh41_binary.msh"}) {
    const Mesh mesh = read_solid_mesh(GLISSON_SOURCE_DIR "/tests/data/meshes/" + std::string(name));
    EXPECT_EQ(mesh.node_count(), 8) << name;
    EXPECT_GT(mesh.element_count(), 4) << name;
    for (const int label : mesh.label) EXPECT_EQ(label, 17) << name;
  }
}

TEST(MeshRead, LegacyVtkInBothLayouts) {
  for (const int version : {3, 5})
    for (const auto code : {Code::text, Code::big}) {
      expect_two_tetrahedra(vtk_file(code, version), MeshFormat::vtk);
      const Mesh mesh = parse_solid_mesh(vtk_file(code, version), "a.vtk", MeshFormat::vtk);
      EXPECT_EQ(mesh.point_arrays.at("fibre axis").values[13], 0.5);
      EXPECT_EQ(mesh.point_arrays.at("T").components, 9);
      EXPECT_EQ(mesh.point_arrays.at("T").values[44], 8);
    }
}

TEST(MeshRead, VtuAsText) { expect_two_tetrahedra(vtu_text, MeshFormat::vtk_xml); }

TEST(MeshRead, VtuInEveryEncodingThatVtkWrites) {
  // base64 with and without zlib, appended raw and base64, both byte orders and header types; all written by
  // VTK 9.
  for (const auto name : {"base64_big", "base64_zlib_64", "appended_raw_zlib", "appended_raw_64_big",
                          "appended_base64_zlib_big", "appended_base64"}) {
    const auto path = GLISSON_SOURCE_DIR "/tests/data/meshes/" + std::string(name) + ".vtu";
    const Mesh mesh = read_solid_mesh(path);
    ASSERT_EQ(mesh.node_count(), 10) << path;
    EXPECT_EQ(mesh.X[9].x, 1.0 / 3) << path;
    EXPECT_EQ(mesh.nodes, (std::vector<int>{4, 5, 7, 8, 5, 6, 7, 9, 0, 1, 2, 3, 4, 5, 6, 7})) << path;
    EXPECT_EQ(mesh.label, (std::vector<int>{3, 4, 7})) << path;
    EXPECT_EQ(mesh.cell_arrays.at("E").values, (std::vector<double>{1000, 2000.5, 3000})) << path;
    EXPECT_EQ(mesh.cell_arrays.at("two words").values, (std::vector<double>{3, 4, 7})) << path;
    EXPECT_EQ(mesh.point_arrays.at("vec").values[29], 29.0 / 7) << path;
  }
}

TEST(MeshRead, VtuOfTwoPieces) {
  const auto start = vtu_text.find("<Piece"), end = vtu_text.find("</UnstructuredGrid>");
  std::string twice = vtu_text;
  twice.insert(end, vtu_text.substr(start, end - start));
  const Mesh mesh = parse_solid_mesh(twice, "a.vtu", MeshFormat::vtk_xml);
  EXPECT_EQ(mesh.node_count(), 10);
  EXPECT_EQ(mesh.element_count(), 4);
  EXPECT_EQ(mesh.element(2)[0], 5);
  EXPECT_EQ(mesh.label, (std::vector<int>{3, 4, 3, 4}));
}

TEST(MeshRead, VoxelsBecomeHexahedra) {
  std::string text = "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n";
  for (int n = 0; n < 8; ++n)
    text += std::to_string(n & 1) + " " + std::to_string(n >> 1 & 1) + " " + std::to_string(n >> 2) + "\n";
  text += "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n";
  const Mesh mesh = parse_solid_mesh(text, "a.vtk", MeshFormat::vtk);
  EXPECT_EQ(mesh.shape, std::vector{Shape::hexahedron});
  EXPECT_EQ(mesh.nodes, (std::vector<int>{0, 1, 3, 2, 4, 5, 7, 6}));
  // As a surface, the same file gives its outside.
  EXPECT_EQ(parse_surface_mesh(text, "a.vtk", MeshFormat::vtk).facets.size(), 6U);
}

void expect_two_triangles(const std::string& text, MeshFormat format) {
  const auto surface = parse_surface_mesh(text, "made here", format);
  ASSERT_EQ(surface.X.size(), 4U);
  EXPECT_EQ(surface.X[2].x, 1);
  EXPECT_EQ(surface.X[2].y, 1);
  ASSERT_EQ(surface.facets.size(), 2U);
  EXPECT_EQ(surface.facets[0].nodes, (std::array{0, 1, 2, -1}));
  EXPECT_EQ(surface.facets[1].nodes, (std::array{0, 2, 3, -1}));
}

TEST(MeshRead, Surfaces) {
  expect_two_triangles(stl_text(), MeshFormat::stl);
  expect_two_triangles(stl_binary(), MeshFormat::stl);
  for (const auto code : {Code::text, Code::little, Code::big})
    expect_two_triangles(ply_file(code), MeshFormat::ply);
  expect_two_triangles(off_text, MeshFormat::off);
  expect_two_triangles(obj_text, MeshFormat::obj);
  expect_two_triangles(
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 "
      "0\nLINES 1 3\n2 0 1\n"
      "POLYGONS 2 8\n3 0 1 2 3 0 2 3\nCELL_DATA 3\nSCALARS a int\n1 2 3\n",
      MeshFormat::vtk);
  expect_two_triangles(
      "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"4\" "
      "NumberOfPolys=\"2\"><Points><DataArray "
      "type=\"Float32\" NumberOfComponents=\"3\">0 0 0 1 0 0 1 1 0 0 1 "
      "0</DataArray></Points><Polys><DataArray "
      "type=\"Int64\" Name=\"connectivity\">0 1 2 0 2 3</DataArray><DataArray type=\"Int64\" "
      "Name=\"offsets\">3 "
      "6</DataArray></Polys></Piece></PolyData></VTKFile>",
      MeshFormat::vtk_xml);
}

TEST(MeshRead, PolygonsStripsAndQuadrilaterals) {
  const auto fan = parse_surface_mesh("OFF\n5 1 0\n0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n5 0 1 2 3 4\n", "a.off",
                                      MeshFormat::off);
  ASSERT_EQ(fan.facets.size(), 3U);
  EXPECT_EQ(fan.facets[2].nodes, (std::array{0, 3, 4, -1}));
  const auto quad =
      parse_surface_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "a.obj", MeshFormat::obj);
  EXPECT_EQ(quad.facets[0].nodes, (std::array{0, 1, 2, 3}));
  Warnings warnings;
  const auto strip = parse_surface_mesh(
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 "
      "0\nTRIANGLE_STRIPS 1 6\n"
      "5 0 1 2 3 3\n",
      "a.vtk", MeshFormat::vtk, &warnings);
  ASSERT_EQ(strip.facets.size(), 2U);
  EXPECT_EQ(strip.facets[1].nodes, (std::array{2, 1, 3, -1}));
  ASSERT_EQ(warnings.size(), 1U);  // the last triangle has a vertex twice
}

TEST(MeshRead, ArraysWithHolesAreLeftOutWithAWarning) {
  std::string text = gmsh_2(Code::text);
  text.replace(text.find("1\n2\n2 \n1000"), 4, "1\n1\n");
  text.erase(text.find("3 \n2000"), std::string("3 \n2000.500000 \n").size());
  Warnings warnings;
  const Mesh mesh = parse_solid_mesh(text, "a.msh", MeshFormat::gmsh, &warnings);
  EXPECT_TRUE(mesh.cell_arrays.empty());
  EXPECT_EQ(warnings.size(), 2U);
}

TEST(MeshRead, LabelsAreTakenFromWholeNumbersOnly) {
  std::string text = vtu_text;
  text.replace(text.find("Int32\" Name=\"label"), 18, "Float32\" Name=\"Region");
  EXPECT_EQ(parse_solid_mesh(text, "a.vtu", MeshFormat::vtk_xml).label, (std::vector<int>{3, 4}));
  text.replace(text.find("8 3 4"), 5, "8 3.5 4");
  const Mesh mesh = parse_solid_mesh(text, "a.vtu", MeshFormat::vtk_xml);
  EXPECT_TRUE(mesh.label.empty());
  EXPECT_EQ(mesh.cell_arrays.at("Region").values[0], 3.5);
}

TEST(MeshRead, TheFormatIsKnownByNameOrContents) {
  EXPECT_EQ(mesh_format("", "a.MSH"), MeshFormat::gmsh);
  EXPECT_EQ(mesh_format("# vtk DataFile Version 3.0", "noname"), MeshFormat::vtk);
  EXPECT_EQ(mesh_format(gmsh_2(Code::big), "a.dat"), MeshFormat::gmsh);
  EXPECT_EQ(mesh_format(ply_file(Code::big), "a.dat"), MeshFormat::ply);
  EXPECT_THROW(mesh_format("what is this", "a.dat"), Error);
}

}  // namespace
}  // namespace glisson::test
