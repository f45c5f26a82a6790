// The same model in two spellings, names in other cases, comments, sub-models against one mesh, lenient
// reading.
#include <tests/models/format_base.hpp>

#include <algorithm>

namespace glisson::test {
namespace {

bool same(const Vec3<double>& a, const Vec3<double>& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

void expect_same(const Model& a, const Model& b) {
  ASSERT_EQ(a.mesh.X.size(), b.mesh.X.size());
  EXPECT_TRUE(std::equal(a.mesh.X.begin(), a.mesh.X.end(), b.mesh.X.begin(), same));
  EXPECT_EQ(a.mesh.nodes, b.mesh.nodes);
  EXPECT_EQ(a.mesh.shape, b.mesh.shape);
  ASSERT_EQ(a.sections.size(), b.sections.size());
  for (std::size_t s = 0; s < a.sections.size(); ++s) {
    EXPECT_EQ(a.sections[s].elements, b.sections[s].elements);
    EXPECT_EQ(a.sections[s].material.parameters, b.sections[s].material.parameters);
  }
  ASSERT_EQ(a.fixed.size(), b.fixed.size());
  for (std::size_t i = 0; i < a.fixed.size(); ++i) EXPECT_EQ(a.fixed[i].nodes, b.fixed[i].nodes);
  ASSERT_EQ(a.displacements.size(), b.displacements.size());
  for (std::size_t i = 0; i < a.displacements.size(); ++i) {
    EXPECT_EQ(a.displacements[i].nodes, b.displacements[i].nodes);
    EXPECT_EQ(a.displacements[i].values, b.displacements[i].values);
    EXPECT_EQ(a.displacements[i].axes, b.displacements[i].axes);
  }
  EXPECT_EQ(a.time.total, b.time.total);
}

struct Spelling {
  const char *what, *with;
};

const Spelling same_meaning[] = {
    {"<Nodes>0 1 2 3</Nodes>", "<Nodes>0</Nodes>"},
    {"<Nodes>0 1 2 3</Nodes>", "<Nodes>0 1 <!-- a comment glues nothing --> 2 3</Nodes>"},
    {"<Nodes>0 1 2 3</Nodes>", "<nodes>0<!-- not 01 -->1 2\t3\r\n</nodes>"},
    {"<Nodes>0 1 2 3</Nodes>", "<NODES><![CDATA[0 1 2 3]]></NODES>"},
    {"NumNodes=\"4\"", "numnodes=\"4\" SpecType=\"NODES\""},
    {"NumNodes=\"4\"", "NumNodes=\" 4 \""},
    {"DOF=\"all\" ", ""},
    {"DOF=\"3\"", ""},
    {"Size=\"all\">", "Size=\"5\">0"},
    {"Size=\"all\">", "Label=\"0\">"},
    {"    </Material>\n  </ElementSet>", "    </Material> </ElementSet>"},
    {"1000 50000", "1e3 +5.0e4"},
    {"1000 50000", "1000.\n 50000"},
    {"SpecType=\"NORMAL\"", ""},
    {"SpecType=\"NORMAL\"", "SpecType=\"NORMAL\" NumNodes=\"1\""},
    {">0 0 1</Normal>", ">0 0 250</Normal>"},
    {"<Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "<Normal ToleranceAngle=\"100\">0 0 1</Normal><RestrictTo Type=\"Box\">0 1 0 1 1 1</RestrictTo>"},
    {"<Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "<Normal ToleranceAngle=\"100\">0 0 1</Normal><RestrictTo Type=\"HalfSpace\" Invert=\"1\">0 0 0.5 0 0 "
     "-1</RestrictTo>"},
    {"SpecType=\"NORMAL\">\n    <Normal ToleranceAngle=\"10\">0 0 1</Normal>", "><Box>0 1 0 1 0.9 1.1</Box>"},
    {"SpecType=\"NORMAL\">\n    <Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "SpecType=\"BOX\"><Box>0 1 0 1 0.9 1.1</Box>"},
    {"SpecType=\"NORMAL\">\n    <Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "SpecType=\"SPHERE\"><Sphere>0.9 0.5 0.5 1.5</Sphere>"},
    {"SpecType=\"NORMAL\">\n    <Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "><HalfSpace>0 0 0.9 0 0 1</HalfSpace>"},
    {"SpecType=\"NORMAL\">\n    <Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "><Select Op=\"not\"><Nodes>0 1 2 3</Nodes></Select>"},
    {"SpecType=\"NORMAL\">\n    <Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "SpecType=\"SELECT\"><Select Op=\"or\"><Nodes>4 5</Nodes><Nodes NumNodes=\"2\">6</Nodes></Select>"},
    {"SpecType=\"NORMAL\">\n    <Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "><Select><Surface/><All/><Label>0</Label><HalfSpace>0 0 0.9 0 0 1</HalfSpace></Select>"},
    {"SpecType=\"NORMAL\">\n    <Normal ToleranceAngle=\"10\">0 0 1</Normal>",
     "SpecType=\"SURFACE\"><RestrictTo Type=\"Box\">0 1 0 1 0.9 1.1</RestrictTo>"},
    {"Type=\"UNIFORM\">0.1", "type=\"UNIFORM\"> 0.1 "},
    {"0 1 3 4  1 2 3 6", "0 1 3 4\n\n<!-- 5 --> 1 2 3 6"},
    {"<DampingCoeff>5</DampingCoeff>", "<dampingcoeff>5</dampingcoeff>"},
};

TEST(FormatEquivalence, TwoSpellingsGiveOneModel) {
  const Model expected = parsed(base_xml);
  for (const auto& [what, other] : same_meaning) {
    SCOPED_TRACE(other);
    try {
      expect_same(parsed(replaced(base_xml, what, other)), expected);
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(FormatEquivalence, TheComparisonCanFail) {
  const Model model = parsed(replaced(base_xml, "<Nodes>0 1 2 3</Nodes>", "<Nodes>1</Nodes>"));
  EXPECT_NE(model.fixed[0].nodes, parsed(base_xml).fixed[0].nodes);
}

TEST(FormatEquivalence, InvertedTetrahedraAreTurned) {
  std::vector<std::string> warnings;
  const Model model = parsed(replaced(base_xml, "0 1 3 4  1 2 3 6", "1 0 3 4  1 2 3 6"), &warnings);
  EXPECT_EQ(model.mesh.nodes, parsed(base_xml).mesh.nodes);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("1 tetrahedra"), std::string::npos);
}

TEST(FormatEquivalence, TextBeforeAndAfterChildrenIsAllRead) {
  const auto model = parsed(replaced(replaced(base_xml, "Size=\"all\">", "Size=\"5\">0 1"), "</Material>\n",
                                     "</Material> 2 3 4\n"));
  EXPECT_EQ(model.sections[0].elements, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(FormatLenient, UnknownNamesBecomeWarnings) {
  std::vector<std::string> warnings;
  const auto xml = replaced(replaced(base_xml, "<DampingCoeff>", "<Colour>red</Colour><DampingCoeff>"),
                            "Size=\"all\"", "Size=\"all\" Colour=\"liver\"");
  EXPECT_THROW(parsed(xml), Error);
  const Model model = parse_model(xml, "test.xml", {.lenient = true, .warnings = &warnings});
  expect_same(model, parsed(base_xml));
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[0].find("test.xml:10: <ElementSet>: unknown attribute Colour"), std::string::npos)
      << warnings[0];
  EXPECT_NE(warnings[1].find("<Colour>"), std::string::npos) << warnings[1];
}

std::string cube_at(double z, const std::string& more) {
  std::string nodes;
  for (const double height : {z, z + 1})
    nodes += "0 0 " + std::to_string(height) + " 1 0 " + std::to_string(height) + " 1 1 " +
             std::to_string(height) + " 0 1 " + std::to_string(height) + " ";
  return "<SubModel><Nodes NumNodes=\"8\">" + nodes +
         "</Nodes><Elements NumEls=\"1\" Type=\"H8\">0 1 2 3 4 5 6 7</Elements>" + more + "</SubModel>";
}

const std::string material_set =
    "<ElementSet Size=\"all\"><Material Type=\"NH\"><ElasticParams NumParams=\"2\">1 "
    "2</ElasticParams></Material></ElementSet>";
const std::string system_params = "<SystemParams><TotalTime>1</TotalTime><Density>1</Density></SystemParams>";

TEST(FormatSubModels, AreJoinedAndMerged) {
  const auto xml =
      "<Model>" + cube_at(0, material_set) +
      cube_at(1, material_set +
                     "<Constraint Type=\"Disp\" SpecType=\"NORMAL\" LoadShape=\"RAMP\" DOF=\"2\"><Normal "
                     "ToleranceAngle=\"5\">0 0 1</Normal><Magnitudes Type=\"DIFFORM\">1 2 3 "
                     "4</Magnitudes></Constraint>"
                     "<Constraint Type=\"Gravity\" NumNodes=\"all\" "
                     "LoadShape=\"STEP\"><AccelerationMagnitude>1</AccelerationMagnitude>"
                     "<AccelerationDirection>0 0 1</AccelerationDirection></Constraint>") +
      "<SubModelNodeMergerDistance>1e-3</SubModelNodeMergerDistance>"
      "<Constraint Type=\"Fix\" NumNodes=\"4\"><Nodes>0</Nodes></Constraint>" +
      system_params + "</Model>";
  const Model model = parsed(xml);
  EXPECT_EQ(model.mesh.node_count(), 12);
  EXPECT_EQ(model.mesh.nodes, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(model.sections.at(1).elements, (std::vector<int>{1}));
  EXPECT_EQ(model.displacements.at(0).nodes, (std::vector<int>{8, 9, 10, 11}));
  EXPECT_EQ(model.displacements[0].values, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(model.gravity.at(0).nodes, (std::vector<int>{4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(model.mesh.X[11].z, 2);
}

TEST(FormatSubModels, WithoutADistanceNothingIsMerged) {
  EXPECT_EQ(
      parsed("<Model>" + cube_at(0, material_set) + cube_at(1, material_set) + system_params + "</Model>")
          .mesh.node_count(),
      16);
}

TEST(FormatSubModels, MayBeNestedAndHaveTheirSetsAbove) {
  const auto inner = "<SubModel>" + cube_at(0, "") + cube_at(1, "") +
                     "<SubModelNodeMergerDistance>0.1</SubModelNodeMergerDistance></SubModel>";
  const Model model = parsed("<Model>" + inner + cube_at(5, "") + material_set + system_params + "</Model>");
  EXPECT_EQ(model.mesh.node_count(), 20);
  EXPECT_EQ(model.sections.at(0).elements, (std::vector<int>{0, 1, 2}));
}

TEST(FormatSubModels, ADistanceThatCollapsesElementsIsRefused) {
  const auto message = message_of("<Model>" + cube_at(0, material_set) +
                                  "<SubModelNodeMergerDistance>1.01</SubModelNodeMergerDistance>" +
                                  system_params + "</Model>");
  EXPECT_NE(message.find("no volume"), std::string::npos) << message;
}

}  // namespace
}  // namespace glisson::test
