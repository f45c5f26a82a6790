// ShellElements and ShellElementSet: where triangles come from, what their sets say, and what is refused.
#include <tests/models/format_base.hpp>

#include <algorithm>
#include <set>

#include <glisson/core/mesh/triangles.hpp>

namespace glisson::test {
namespace {

const std::string membrane = R"(<Material Type="NeoHookean"> 1000
    <Density>1100</Density> <Thickness>0.01</Thickness> </Material>)";

std::string set(const std::string& attributes, const std::string& content) {
  return "<ShellElementSet " + attributes + ">" + content + "</ShellElementSet>";
}

const std::string capsule = "<ShellElements Type=\"SURFACE\"/>" + set("Size=\"all\"", membrane);

double area(const Model& model) {
  double sum = 0;
  for (const auto& t : model.mesh.triangles) sum += triangle_area(t, model.mesh.X);
  return sum;
}

/// Volume inside a closed surface; negative when its normals point inwards.
double volume(const Model& model) {
  double sum = 0;
  for (const auto& t : model.mesh.triangles) {
    const auto X = [&](std::size_t a) { return model.mesh.X[static_cast<std::size_t>(t[a])]; };
    sum += dot(X(0), cross(X(1), X(2))) / 6;
  }
  return sum;
}

TEST(FormatShells, TheSurfaceOfTetrahedraFacesOutwards) {
  const Model model = parsed(with(capsule));
  EXPECT_EQ(model.mesh.triangles.size(), 12U);
  EXPECT_NEAR(area(model), 6, 1e-12);
  EXPECT_NEAR(volume(model), 1, 1e-12);
  ASSERT_EQ(model.shells.size(), 1U);
  const ShellSection& section = model.shells[0];
  EXPECT_EQ(section.formulation, ShellFormulation::membrane);
  EXPECT_EQ(section.law, "NeoHookean");
  EXPECT_EQ(section.parameters, std::vector<double>{1000});
  EXPECT_EQ(section.density, 1100);
  EXPECT_EQ(section.thickness, 0.01);
  EXPECT_EQ(section.elements.size(), 12U);
  EXPECT_TRUE(validate(model).empty());
}

/// Two hexahedra side by side, 12 nodes in rows of x.
const std::string bricks = R"(<?xml version="1.0"?>
<Model>
  <Nodes NumNodes="12">
    0 0 0  1 0 0  2 0 0  0 1 0  1 1 0  2 1 0
    0 0 1  1 0 1  2 0 1  0 1 1  1 1 1  2 1 1
  </Nodes>
  <Elements NumEls="2" Type="H8"> 0 1 4 3 6 7 10 9  1 2 5 4 7 8 11 10 </Elements>
  <ElementSet Size="all">
    <Material Type="NH"> <ElasticParams NumParams="2">1000 50000</ElasticParams>
      <Density>1000</Density> </Material>
  </ElementSet>
  <SystemParams> <TotalTime>1</TotalTime> </SystemParams>
</Model>
)";

std::string bricks_with(const std::string& more) {
  return replaced(bricks, "<SystemParams>", more + "<SystemParams>");
}

TEST(FormatShells, QuadrilateralsAreCutWithParallelDiagonals) {
  const Model model = parsed(bricks_with(capsule));
  EXPECT_EQ(model.mesh.triangles.size(), 20U);
  EXPECT_NEAR(area(model), 10, 1e-12);
  EXPECT_NEAR(volume(model), 2, 1e-12);
  std::set<std::pair<int, int>> diagonals;
  for (const auto& edge : edges_of(model.mesh.triangles)) diagonals.emplace(edge.a, edge.b);
  EXPECT_TRUE(diagonals.count({6, 10}) == 1 && diagonals.count({7, 11}) == 1);  // on top
  EXPECT_TRUE(diagonals.count({0, 4}) == 1 && diagonals.count({1, 5}) == 1);    // at the bottom
}

TEST(FormatShells, AShellCoversAPartOfTheSurface) {
  for (const char* where : {"<Normal ToleranceAngle=\"10\">0 0 1</Normal>", "<Box>-1 3 -1 2 0.9 2</Box>",
                            "<Nodes NumNodes=\"6\">6</Nodes>",
                            "<Select Op=\"and\"><HalfSpace>0 0 0.99 0 0 1</HalfSpace></Select>",
                            "<RestrictTo Type=\"Normal\" ToleranceAngle=\"5\">0 0 1</RestrictTo>"}) {
    SCOPED_TRACE(where);
    const Model model = parsed(bricks_with("<ShellElements Type=\"SURFACE\">" + std::string(where) +
                                           "</ShellElements>" + set("Size=\"all\"", membrane)));
    EXPECT_EQ(model.mesh.triangles.size(), 4U);
    EXPECT_NEAR(area(model), 2, 1e-12);
  }
}

TEST(FormatShells, SetsDivideTheTriangles) {
  const std::string shell =
      "<Material Type=\"LinearShell\"> 1e5 0.3 2e5 0.4 <Density>900</Density>"
      "<Thickness>0.02</Thickness></Material>";
  const std::string top = "<Normal ToleranceAngle=\"10\">0 0 1</Normal>";
  const Model model = parsed(bricks_with("<ShellElements Type=\"SURFACE\"/>" + set("", top + shell) +
                                         set("", "<Select Op=\"not\">" + top + "</Select>" + membrane)));
  ASSERT_EQ(model.shells.size(), 2U);
  EXPECT_EQ(model.shells[0].elements.size(), 4U);
  EXPECT_EQ(model.shells[1].elements.size(), 16U);
  EXPECT_EQ(model.shells[0].formulation, ShellFormulation::rotation_free);
  EXPECT_EQ(model.shells[0].law, "Linear");
  EXPECT_EQ(model.shells[0].bending_E, 2e5);
  EXPECT_EQ(model.shells[0].bending_nu, 0.4);
  EXPECT_NO_THROW(validate(model));
}

TEST(FormatShells, ListsAndStartIndicesAsInNiftySim) {
  const std::string two =
      "<ShellElements Type=\"T3\" NumEls=\"4\"> 6 7 10  6 10 9  7 8 11  7 11 10 </ShellElements>";
  for (const char* first : {"0 1", "0"}) {
    const Model model = parsed(bricks_with(two + set("Size=\"2\"", std::string(first) + membrane) +
                                           set("Size=\"2\"", membrane + "2 3")));
    ASSERT_EQ(model.shells.size(), 2U);
    EXPECT_EQ(model.shells[0].elements, (std::vector<int>{0, 1}));
    EXPECT_EQ(model.shells[1].elements, (std::vector<int>{2, 3}));
  }
  const Model quads = parsed(bricks_with("<ShellElements Type=\"Q4\"> 6 7 10 9  7 8 11 10 </ShellElements>" +
                                         set("Size=\"all\"", membrane)));
  EXPECT_EQ(quads.mesh.triangles, (std::vector<Triangle>{{6, 7, 10}, {6, 10, 9}, {7, 8, 11}, {7, 11, 10}}));
}

TEST(FormatShells, TurnedTrianglesAreTurnedBackAndSaid) {
  std::vector<std::string> warnings;
  const Model model = parsed(bricks_with("<ShellElements Type=\"T3\"> 6 7 10  6 9 10 </ShellElements>" +
                                         set("Size=\"all\"", membrane)),
                             &warnings);
  EXPECT_EQ(model.mesh.triangles[1], (Triangle{6, 10, 9}));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("1 shell triangles were turned"), std::string::npos) << warnings[0];
}

/// A square of 2 x 2 fields without any solid, its border fixed.
const std::string sheet_xml = R"(<?xml version="1.0"?>
<Model>
  <Nodes NumNodes="9" DOF="3"> 0 0 0  1 0 0  2 0 0  0 1 0  1 1 0  2 1 0  0 2 0  1 2 0  2 2 0 </Nodes>
  <ShellElements Type="Q4" NumEls="4"> 0 1 4 3  1 2 5 4  3 4 7 6  4 5 8 7 </ShellElements>
  <ShellElementSet Size="all" Name="skin">
    <Material Type="NeoHookeanShell"> 1000 3000 0.49
      <Density>1000</Density> <Thickness>0.1</Thickness>
      <ViscoParams NumTerms="1"> 0.3 0.2 </ViscoParams>
    </Material>
    <ClampedNodes NumNodes="3">0</ClampedNodes>
  </ShellElementSet>
  <Constraint Type="Fix" NumNodes="8"> <Nodes> 0 1 2 3 5 6 7 8 </Nodes> </Constraint>
  <Constraint Type="Pressure" LoadShape="RAMP" NumFaces="all"> <Magnitude>10</Magnitude> </Constraint>
  <SystemParams> <TotalTime>1</TotalTime> </SystemParams>
</Model>
)";

TEST(FormatShells, AModelOfShellsOnly) {
  const Model model = parsed(sheet_xml);
  EXPECT_EQ(model.mesh.element_count(), 0);
  EXPECT_EQ(model.mesh.triangles.size(), 8U);
  EXPECT_EQ(model.clamped_nodes, (std::vector<int>{0, 1, 2}));
  ASSERT_EQ(model.shells[0].prony.size(), 1U);
  EXPECT_EQ(model.shells[0].prony[0].tau, 0.2);
  EXPECT_EQ(model.shells[0].law, "NeoHookean");
  ASSERT_EQ(model.pressures.size(), 1U);
  EXPECT_EQ(model.pressures[0].facets.size(), 8U);
  EXPECT_TRUE(validate(model).empty());
  const std::string peer =
      replaced(sheet_xml, "<ShellElements", "<Elements NumEls=\"0\" Type=\"T4\"/><ShellElements");
  EXPECT_EQ(parsed(peer).mesh.triangles.size(), 8U);
}

TEST(FormatShells, PressureAndTractionActOnShellsWhereTold) {
  const std::string more = R"(
    <Constraint Type="Pressure" LoadShape="RAMP" FaceType="Shell" NumFaces="2">
      <Faces>0</Faces> <Magnitude>-5</Magnitude> </Constraint>
    <Constraint Type="Traction" LoadShape="RAMP" FaceType="Shell" NumFaces="all">
      <Box>0 1 0 1 0 1</Box> <Magnitudes Type="UNIFORM">0 0 1</Magnitudes> </Constraint>)";
  const Model model = parsed(bricks_with(capsule + more));
  ASSERT_EQ(model.pressures.size(), 1U);
  ASSERT_EQ(model.pressures[0].facets.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_EQ(model.pressures[0].facets[i].nodes[a], model.mesh.triangles[i][a]);
  EXPECT_EQ(model.tractions[0].facets.size(), 10U);  // both halves of the first brick's five outer facets
}

TEST(FormatShells, MaterialsAndTheirOptions) {
  const std::string fibres = R"(<Material Type="TwoFibre" Wrinkling="0"> 1000 500 2 30
    <Thickness>0.01</Thickness> <Density>1</Density> <FibreDirection>0 2 0</FibreDirection> </Material>)";
  const Model model = parsed(
      bricks_with("<ShellElements Type=\"SURFACE\"/>" + set("Size=\"10\"", "0" + fibres) +
                  set("Size=\"10\"", "10" + replaced(membrane, "\"> 1000", "\" Wrinkling=\"1\"> 1000"))));
  EXPECT_EQ(model.shells[0].parameters, (std::vector<double>{1000, 500, 2, 30}));
  EXPECT_EQ(model.shells[0].direction.y, 1);
  EXPECT_FALSE(model.shells[0].wrinkling);
  EXPECT_TRUE(model.shells[1].wrinkling);
}

TEST(FormatShells, SubModelsKeepTheirShellsWhenTheyAreMerged) {
  const std::string part = R"(<SubModel>
    <Nodes NumNodes="8"> X 0 0  Y 0 0  Y 1 0  X 1 0  X 0 1  Y 0 1  Y 1 1  X 1 1 </Nodes>
    <Elements NumEls="1" Type="H8"> 0 1 2 3 4 5 6 7 </Elements>
    <ElementSet Size="all"> <Material Type="NH"> <ElasticParams NumParams="2">1000 50000</ElasticParams>
      <Density>1000</Density> </Material> </ElementSet>
    <ShellElements Type="SURFACE"> <Normal ToleranceAngle="10">0 0 1</Normal> </ShellElements>
    <ShellElementSet Size="all"> <Material Type="LinearShell"> 1000 0.3 1000 0.3
      <Density>1100</Density> <Thickness>0.01</Thickness> </Material>
      <ClampedNodes>1 2</ClampedNodes> </ShellElementSet>
    </SubModel>)";
  const auto at = [&](const char* x, const char* y) {
    std::string text = part;
    for (std::size_t i = 0; (i = text.find('X', i)) != std::string::npos;) text.replace(i, 1, x);
    for (std::size_t i = 0; (i = text.find('Y', i)) != std::string::npos;) text.replace(i, 1, y);
    return text;
  };
  const Model model = parsed("<Model>" + at("0", "1") + at("1", "2") +
                             "<SubModelNodeMergerDistance>1e-6</SubModelNodeMergerDistance><SystemParams>"
                             "<TotalTime>1</TotalTime></SystemParams></Model>");
  EXPECT_EQ(model.mesh.node_count(), 12);
  EXPECT_EQ(model.mesh.triangles.size(), 4U);
  ASSERT_EQ(model.shells.size(), 2U);
  EXPECT_EQ(model.shells[1].elements, (std::vector<int>{2, 3}));
  EXPECT_EQ(model.clamped_nodes.size(), 4U);
  int shared = 0;
  for (const auto& edge : edges_of(model.mesh.triangles)) {
    shared += edge.sides.size() == 2;
    if (edge.sides.size() == 2) {
      EXPECT_TRUE(same_orientation(model.mesh.triangles, edge));
    }
  }
  EXPECT_EQ(shared, 3);  // two diagonals and the seam
  EXPECT_NO_THROW(validate(model));
}

TEST(FormatShells, AlternatingDiagonalsAreWarnedOf) {
  std::string nodes, alternating, parallel;
  for (int j = 0; j <= 6; ++j)
    for (int i = 0; i <= 6; ++i) nodes += std::to_string(i) + " " + std::to_string(j) + " 0  ";
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) {
      const auto n = [&](int p, int q) { return std::to_string(i + p + 7 * (j + q)) + " "; };
      const std::string uniform = n(0, 0) + n(1, 0) + n(1, 1) + n(0, 0) + n(1, 1) + n(0, 1);
      parallel += uniform;
      alternating += (i + j) % 2 == 0 ? uniform : n(0, 0) + n(1, 0) + n(0, 1) + n(1, 0) + n(1, 1) + n(0, 1);
    }
  const auto warned = [&](const std::string& triangles, const std::string& type) {
    const auto all =
        validate(parsed("<Model><Nodes NumNodes=\"49\">" + nodes + "</Nodes><ShellElements Type=\"T3\">" +
                        triangles + "</ShellElements><ShellElementSet Size=\"all\"><Material Type=\"" + type +
                        "<Density>1</Density><Thickness>0.1</Thickness></Material></ShellElementSet>"
                        "<SystemParams><TotalTime>1</TotalTime></SystemParams></Model>"));
    return std::any_of(all.begin(), all.end(), [](const std::string& warning) {
      return warning.find("diagonals of the shell's mesh alternate") != std::string::npos;
    });
  };
  EXPECT_FALSE(warned(parallel, "LinearShell\">1 0.3 1 0.3"));
  EXPECT_FALSE(warned(alternating, "Linear\">1 0.3"));
  EXPECT_TRUE(warned(alternating, "LinearShell\">1 0.3 1 0.3"));
}

}  // namespace
}  // namespace glisson::test
