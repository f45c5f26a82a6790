// Files named in a simulation file: where they are looked up, meshes with labels and arrays, surfaces, lists
// of values.
#include <tests/models/format_base.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace glisson::test {
namespace {

namespace fs = std::filesystem;

/// Two unit cubes on top of each other with a tetrahedron on top; labels 1 and 2, stiffness and fibres per
/// element.
const char* const vtk_mesh = R"(# vtk DataFile Version 3.0
two cubes and a tetrahedron
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 13 double
0 0 0 1 0 0 1 1 0 0 1 0  0 0 1 1 0 1 1 1 1 0 1 1
0 0 2 1 0 2 1 1 2 0 1 2  0 0 3
CELLS 3 23
8 0 1 2 3 4 5 6 7
8 4 5 6 7 8 9 10 11
4 8 9 11 12
CELL_TYPES 3
12 12 10
CELL_DATA 3
SCALARS label int 1
LOOKUP_TABLE default
1 2 2
SCALARS stiffness double 1
LOOKUP_TABLE default
1000 2000 3000
VECTORS fibres double
2 0 0  0 3 0  0 0 4
)";

const char* const stl_surface = R"(solid plane
facet normal 0 0 1
 outer loop
  vertex -5 -5 2.1
  vertex 5 -5 2.1
  vertex 0 9 2.1
 endloop
endfacet
endsolid plane
)";

class FormatFiles : public testing::Test {
 protected:
  /// Of this test alone: tests run side by side.
  fs::path directory = fs::path(GLISSON_BINARY_DIR) / "format_files" /
                       testing::UnitTest::GetInstance()->current_test_info()->name();
  std::vector<std::string> warnings;

  void SetUp() override {
    fs::create_directories(directory);
    write("mesh.vtk", vtk_mesh);
    write("plane.stl", stl_surface);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory / name, std::ios::binary) << text;
  }
  Model read(const std::string& xml) {
    write("model.xml", xml);
    warnings.clear();
    return read_model((directory / "model.xml").string(), {.warnings = &warnings});
  }
  static std::string model(const std::string& mesh, const std::string& more = "",
                           const std::string& set = "Size=\"all\"", const std::string& material = "") {
    return "<Model>" + mesh + "<ElementSet " + set +
           "><Material Type=\"TI\"><ElasticParams NumParams=\"6\">1 2 3 0 0 "
           "1</ElasticParams><Density>1</Density>" +
           material + "</Material></ElementSet>" + more +
           "<SystemParams><TotalTime>1</TotalTime></SystemParams></Model>";
  }
};

const std::string mesh_element = "<VTKMesh>mesh.vtk</VTKMesh>";

TEST_F(FormatFiles, AreLookedUpBesideTheSimulationFile) {
  EXPECT_EQ(read(model(mesh_element)).mesh.element_count(), 3);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(read(model("<Mesh>" + (directory / "mesh.vtk").string() + "</Mesh>")).mesh.element_count(), 3);
}

TEST_F(FormatFiles, ThenInTheWorkingDirectory) {
  fs::rename(directory / "mesh.vtk", fs::current_path() / "format_files_mesh.vtk");
  EXPECT_EQ(read(model("<VTKMesh>format_files_mesh.vtk</VTKMesh>")).mesh.element_count(), 3);
  fs::remove(fs::current_path() / "format_files_mesh.vtk");
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("working directory"), std::string::npos);
}

TEST_F(FormatFiles, AMissingOneIsNamedWithBothPlaces) {
  try {
    read(model("<VTKMesh>nowhere.vtk</VTKMesh>"));
    FAIL();
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find((directory / "nowhere.vtk").string()), std::string::npos) << message;
    EXPECT_NE(message.find(fs::current_path().string()), std::string::npos) << message;
    EXPECT_EQ(error.place().line, 1);
  }
  EXPECT_THROW(read_model("/no/such/file.xml"), Error);
  EXPECT_THROW(read_model(directory.string()), Error);
}

TEST_F(FormatFiles, SurfacesOfContact) {
  const auto from = [&](const std::string& child) {
    return read(model(mesh_element, "<ContactSurface>" + child + "</ContactSurface>")).surfaces.at(0).surface;
  };
  const SurfaceMesh plane = from("<SurfaceFile>plane.stl<Translation>0 0 1</Translation></SurfaceFile>");
  ASSERT_EQ(plane.facets.size(), 1U);
  EXPECT_EQ(plane.facets[0].node_count(), 3);
  const auto told = read(model(mesh_element,
                               "<ContactSurface><SurfaceFile>plane.stl</SurfaceFile>"
                               "</ContactSurface>"));
  EXPECT_EQ(told.surfaces.at(0).file, (directory / "plane.stl").string());
  ASSERT_EQ(plane.X.size(), 3U);
  for (const auto& X : plane.X) EXPECT_NEAR(X.z, 3.1, 1e-6);  // float in the file
}

/// Each with the file that is wrong and a word that helps.
TEST_F(FormatFiles, SurfacesOfContactThatCannotBeUsed) {
  write("empty.stl", "");
  write("garbage.vtk", std::string("\1\2\3garbage"));
  write("nan.stl", replaced(stl_surface, "-5 -5 2.1", "-5 nan 2.1"));
  const auto lines =
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 0 0\n"
      "LINES 1 3\n2 0 1\n";
  write("lines.vtk", lines);
  fs::create_directories(directory / "folder.stl");
  const std::pair<const char*, const char*> bad[] = {
      {"nowhere.stl", "nowhere.stl"},
      {"folder.stl", "folder.stl"},
      {"", "empty"},
      {"empty.stl", "empty.stl"},
      {"garbage.vtk", "garbage.vtk"},
      {"nan.stl", "nan.stl"},
      {"lines.vtk", "lines.vtk"},
      {"mesh.xyz", "mesh.xyz"},
      {"plane.stl<ScaleFactor>0</ScaleFactor>", "ScaleFactor"},
      {"plane.stl<ScaleFactor>-1</ScaleFactor>", "ScaleFactor"},
      {"plane.stl<Rotation>1 2 3</Rotation>", "Rotation"}};
  for (const auto& [file, word] : bad) try {
      read(model(mesh_element,
                 "<ContactSurface><SurfaceFile>" + std::string(file) + "</SurfaceFile></ContactSurface>"));
      ADD_FAILURE() << "accepted: " << file;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << file;
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

TEST_F(FormatFiles, TypeChoosesShapesAndFormulations) {
  const auto both = read(model("<VTKMesh Type=\"T4ANP+H8FixedHourglass\">mesh.vtk</VTKMesh>"));
  ASSERT_EQ(both.sections.size(), 2U);
  EXPECT_EQ(both.sections[0].formulation, Formulation::t4anp);
  EXPECT_EQ(both.sections[1].formulation, Formulation::h8_fixed);
  const auto bricks = read(model("<VTKMesh Type=\"H8\">mesh.vtk</VTKMesh>"));
  EXPECT_EQ(bricks.mesh.element_count(), 2);
  EXPECT_EQ(bricks.mesh.node_count(), 13);  // nodes keep their numbers
  EXPECT_EQ(bricks.mesh.label, (std::vector<int>{1, 2}));
  EXPECT_EQ(bricks.mesh.cell_arrays.at("stiffness").values, (std::vector<double>{1000, 2000}));
}

TEST_F(FormatFiles, SetsByLabelAndSelectionsByLabel) {
  const auto m = read(model(mesh_element,
                            "<Constraint Type=\"Fix\"><Label>1</Label></Constraint>"
                            "<Constraint Type=\"Pressure\" "
                            "LoadShape=\"RAMP\"><Label>1</Label><Magnitude>1</Magnitude></Constraint>",
                            "Label=\"2\""));
  EXPECT_EQ(m.sections.at(0).elements, (std::vector<int>{2}));  // T4 first, then H8
  EXPECT_EQ(m.sections.at(1).elements, (std::vector<int>{1}));
  EXPECT_EQ(m.fixed.at(0).nodes, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(m.pressures.at(0).facets.size(), 5U);
}

TEST_F(FormatFiles, ParametersAndFibresPerElement) {
  const auto m =
      read(model(mesh_element, "", "Size=\"all\"",
                 "<ElementArray Param=\"mu\">stiffness</ElementArray><FibreArray>fibres</FibreArray>"));
  ASSERT_EQ(m.sections.size(), 2U);
  const auto& bricks = m.sections[1].material.element_parameters;
  ASSERT_EQ(bricks.size(), 4U);
  EXPECT_EQ(bricks[0].first, 0);
  EXPECT_EQ(bricks[0].second, (std::vector<double>{1000, 2000}));
  EXPECT_EQ(bricks[3].first, 5);
  EXPECT_EQ(bricks[1].second, (std::vector<double>{1, 0}));  // a1, scaled to length 1
  EXPECT_EQ(m.sections[0].material.element_parameters[3].second, (std::vector<double>{1}));
  EXPECT_NO_THROW(validate(m));
  EXPECT_THROW(
      read(model(mesh_element, "", "Size=\"all\"", "<ElementArray Param=\"mu\">fibres</ElementArray>")),
      Error);
}

TEST_F(FormatFiles, TransformsRotateThenScaleThenMove) {
  const auto m =
      read(model("<VTKMesh>mesh.vtk<Rotation>1 0 0  0 0 90</Rotation><ScaleFactor>2</ScaleFactor>"
                 "<Translation>10 20 30</Translation></VTKMesh>"));
  const auto x = m.mesh.X[0];  // 2 (Rz (0-1, 0, 0) + (1, 0, 0)) + t
  EXPECT_NEAR(x.x, 2 * 1 + 10, 1e-14);
  EXPECT_NEAR(x.y, 2 * -1 + 20, 1e-14);
  EXPECT_NEAR(x.z, 30, 1e-14);
  const auto y = read(model("<VTKMesh>mesh.vtk<Rotation>0 0 0  90 90 0</Rotation></VTKMesh>")).mesh.X[1];
  EXPECT_NEAR(y.x, 0, 1e-14);  // Ry takes x to -z, then Rx takes -z to y
  EXPECT_NEAR(y.y, 1, 1e-14);
  EXPECT_NEAR(y.z, 0, 1e-14);
  EXPECT_THROW(read(model("<VTKMesh>mesh.vtk<ScaleFactor>-1</ScaleFactor></VTKMesh>")), Error);
}

TEST_F(FormatFiles, DistanceToASurface) {
  const auto m = read(model(
      mesh_element, "<Constraint Type=\"Fix\"><Distance Max=\"0.2\">plane.stl</Distance></Constraint>"));
  EXPECT_EQ(m.fixed.at(0).nodes, (std::vector<int>{8, 9, 10, 11}));
}

TEST_F(FormatFiles, ListsOfValues) {
  write("values.txt", "1 2\n3 4\n");
  const std::string load =
      "<Constraint Type=\"Disp\" LoadShape=\"RAMP\" NumNodes=\"4\"><Nodes>8</Nodes><Magnitudes "
      "Type=\"FILE\">values.txt</Magnitudes></Constraint>";
  EXPECT_EQ(read(model(mesh_element, load)).displacements.at(0).values, (std::vector<double>{1, 2, 3, 4}));
  for (const char* bad : {"1 2 3", "1 2 3 4 5", "1 2 x 4"}) {
    write("values.txt", bad);
    EXPECT_THROW(read(model(mesh_element, load)), Error) << bad;
  }
}

TEST_F(FormatFiles, ValuesFollowAListThatARestrictionShortens) {
  const auto m = read(model(
      mesh_element,
      "<Constraint Type=\"Disp\" LoadShape=\"RAMP\" NumNodes=\"4\"><Nodes>11 8 0 9</Nodes>"
      "<HalfSpace>0 0 1 0 0 1</HalfSpace><Magnitudes Type=\"DIFFORM\">1 2 3 4</Magnitudes></Constraint>"));
  EXPECT_EQ(m.displacements.at(0).nodes, (std::vector<int>{11, 8, 9}));
  EXPECT_EQ(m.displacements[0].values, (std::vector<double>{1, 2, 4}));
}

}  // namespace
}  // namespace glisson::test
