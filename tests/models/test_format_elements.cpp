// Every element and attribute of the format at least once, and its meaning in the model.
#include <tests/models/format_base.hpp>

#include <algorithm>
#include <cmath>

namespace glisson::test {
namespace {

/// The only constraint of its kind, appended to the base file.
std::string constraint(const std::string& attributes, const std::string& children) {
  return with("<Constraint " + attributes + ">" + children + "</Constraint>");
}

std::string material(const std::string& type, const std::string& parameters, const std::string& more = "") {
  std::string xml = replaced(base_xml, "Type=\"NH\"", "Type=\"" + type + "\"");
  const auto count = 1 + std::count(parameters.begin(), parameters.end(), ' ');
  return replaced(
      xml, "<ElasticParams NumParams=\"2\">1000 50000</ElasticParams>",
      "<ElasticParams NumParams=\"" + std::to_string(count) + "\">" + parameters + "</ElasticParams>" + more);
}

TEST(FormatMaterials, EachLawKeepsItsParametersInOrder) {
  for (const auto& [type, parameters] :
       std::vector<std::pair<std::string, std::vector<double>>>{{"LE", {1, 2}},
                                                                {"NH", {1, 2}},
                                                                {"AB", {1, 2, 3}},
                                                                {"PY", {1, 2, 3, 4, 5, 6}},
                                                                {"OG", {1, 2, 3, 4, 5, 6, 7}}}) {
    std::string text;
    for (const double p : parameters) text += (text.empty() ? "" : " ") + std::to_string(static_cast<int>(p));
    const auto model = parsed(material(type, text));
    EXPECT_EQ(model.sections[0].material.law, type);
    EXPECT_EQ(model.sections[0].material.parameters, parameters);
  }
}

TEST(FormatMaterials, FibreDirectionsAreScaledToOne) {
  const auto p = parsed(material("TI", "1 2 3 0 3 4")).sections[0].material.parameters;
  EXPECT_EQ(p, (std::vector<double>{1, 2, 3, 0, 0.6, 0.8}));
}

TEST(FormatMaterials, OgdenMayHaveFewerTerms) {
  EXPECT_EQ(parsed(material("OG", "10 2 99")).sections[0].material.parameters,
            (std::vector<double>{10, 2, 0, 2, 0, 2, 99}));
}

TEST(FormatMaterials, PronyTermsOfEitherKindWithEveryLaw) {
  const std::string terms =
      "<ViscoParams NumIsoTerms=\"2\" NumVolTerms=\"1\">0.1 1 0.2 2  0.3 3</ViscoParams>";
  for (const auto& [type, parameters] :
       {std::pair<std::string, std::string>{"NHV", "1 2"}, {"TIV", "1 2 3 0 0 1"}, {"LE", "1 0.3"}}) {
    const auto m = parsed(material(type, parameters, terms)).sections[0].material;
    EXPECT_EQ(m.law, type.substr(0, 2));
    ASSERT_EQ(m.isochoric.size(), 2U);
    ASSERT_EQ(m.volumetric.size(), 1U);
    EXPECT_EQ(m.isochoric[1].alpha, 0.2);
    EXPECT_EQ(m.isochoric[1].tau, 2);
    EXPECT_EQ(m.volumetric[0].alpha, 0.3);
  }
}

TEST(FormatMaterials, DensityOfTheSetBeatsTheDefault) {
  const auto by_default = replaced(replaced(base_xml, "<Density>1000</Density>", ""), "<SystemParams>",
                                   "<SystemParams><Density>900</Density>");
  EXPECT_EQ(parsed(by_default).sections[0].material.density, 900);
  EXPECT_EQ(parsed(replaced(base_xml, "<SystemParams>", "<SystemParams><Density>900</Density>"))
                .sections[0]
                .material.density,
            1000);
}

TEST(FormatSets, ListsStartIndicesAndFormulations) {
  const auto two = replaced(base_xml, "<ElementSet Size=\"all\">",
                            "<ElementSet Size=\"2\" Formulation=\"T4ANP\"><Material "
                            "Type=\"LE\"><ElasticParams NumParams=\"2\">1000 0.3</ElasticParams>"
                            "<Density>1</Density></Material>4 0</ElementSet><ElementSet Size=\"3\">1 ");
  const auto model = parsed(two);
  ASSERT_EQ(model.sections.size(), 2U);
  EXPECT_EQ(model.sections[0].elements, (std::vector<int>{4, 0}));
  EXPECT_EQ(model.sections[0].formulation, Formulation::t4anp);
  EXPECT_EQ(model.sections[1].elements, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(model.sections[1].formulation, Formulation::t4);
}

TEST(FormatSets, MixedMeshesSplitASetByFormulation) {
  const std::string mixed =
      "<Elements NumEls=\"2\" Type=\"T4ANP+H8Full\">8 0 1 2 3 4 5 6 7  4 4 5 7 8</Elements>";
  auto xml = replaced(
      base_xml,
      "<Elements NumEls=\"5\" Type=\"T4\">\n    0 1 3 4  1 2 3 6  1 6 4 5  3 4 6 7  1 3 4 6\n  </Elements>",
      mixed);
  xml = replaced(replaced(xml, "NumNodes=\"8\"", "NumNodes=\"9\""), "0 1 1\n", "0 1 1  0 0 2\n");
  const auto model = parsed(replaced(xml, "<SystemParams>", "<SystemParams><HGKappa>0.1</HGKappa>"));
  ASSERT_EQ(model.sections.size(), 2U);
  EXPECT_EQ(model.sections[0].formulation, Formulation::t4anp);
  EXPECT_EQ(model.sections[0].elements, (std::vector<int>{1}));
  EXPECT_EQ(model.sections[1].formulation, Formulation::h8_full);
  EXPECT_EQ(model.sections[1].hourglass, 0.1);
}

TEST(FormatConstraints, NodesAxesAndShapes) {
  for (const auto& [name, shape] : {std::pair<std::string, LoadShape>{"POLY345", LoadShape::poly345},
                                    {"RAMP", LoadShape::ramp},
                                    {"RAMPHOLD", LoadShape::ramp_hold},
                                    {"STEP", LoadShape::step},
                                    {"HILLY", LoadShape::hilly}}) {
    const auto model = parsed(constraint("Type=\"Force\" DOF=\"1\" NumNodes=\"3\" LoadShape=\"" + name + "\"",
                                         "<Nodes>4</Nodes><Magnitudes Type=\"DIFFORM\">1 2 3</Magnitudes>"));
    ASSERT_EQ(model.forces.size(), 1U);
    EXPECT_EQ(model.forces[0].nodes, (std::vector<int>{4, 5, 6}));
    EXPECT_EQ(model.forces[0].axes, 2U);
    EXPECT_EQ(model.forces[0].values, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(model.forces[0].curve.shape, shape);
  }
}

TEST(FormatConstraints, TimesTablesAndRelease) {
  const auto curve =
      parsed(constraint("Type=\"Force\" NumNodes=\"all\" LoadShape=\"TABLE\" StartTime=\"0.2\" "
                        "EndTime=\"0.6\" Release=\"1\"",
                        "<Table>0 1  0.5 -2</Table><Magnitudes Type=\"UNIFORM\">1</Magnitudes>"))
          .forces[0]
          .curve;
  EXPECT_EQ(curve.shape, LoadShape::table);
  EXPECT_EQ(curve.start, 0.2);
  EXPECT_EQ(curve.end, 0.6);
  EXPECT_TRUE(curve.release_after_end);
  EXPECT_EQ(curve.table, (std::vector<std::pair<double, double>>{{0, 1}, {0.5, -2}}));
}

TEST(FormatConstraints, Gravity) {
  const auto model = parsed(constraint("Type=\"Gravity\" NumNodes=\"all\" LoadShape=\"STEP\"",
                                       "<AccelerationMagnitude>9.81</AccelerationMagnitude>"
                                       "<AccelerationDirection>0 0 -2</AccelerationDirection>"));
  ASSERT_EQ(model.gravity.size(), 1U);
  EXPECT_TRUE(model.gravity[0].nodes.empty());  // all
  EXPECT_DOUBLE_EQ(model.gravity[0].acceleration.z, -9.81);
}

TEST(FormatConstraints, PressureOnListedFacesAndOnTheSurface) {
  const auto listed =
      parsed(constraint("Type=\"Pressure\" NumFaces=\"2\" FaceType=\"Tri\" LoadShape=\"RAMP\"",
                        "<Faces>4 5 6  4 6 7</Faces><Magnitude>100</Magnitude>"));
  ASSERT_EQ(listed.pressures[0].facets.size(), 2U);
  EXPECT_EQ(listed.pressures[0].facets[1].nodes, (std::array<int, 4>{4, 6, 7, -1}));
  EXPECT_EQ(listed.pressures[0].magnitude, 100);
  const auto all =
      parsed(constraint("Type=\"Pressure\" NumFaces=\"all\" LoadShape=\"RAMP\"", "<Magnitude>1</Magnitude>"));
  EXPECT_EQ(all.pressures[0].facets.size(), 12U);
  const auto negative =
      parsed(constraint("Type=\"Pressure\" NumFaces=\"-1\" LoadShape=\"RAMP\"", "<Magnitude>1</Magnitude>"));
  EXPECT_EQ(negative.pressures[0].facets.size(), 12U);  // NiftySim's other spelling of all
}

TEST(FormatConstraints, RestrictToWorksOnFacets) {
  const auto half = parsed(
      constraint("Type=\"Pressure\" SpecType=\"NORMAL\" LoadShape=\"RAMP\"",
                 "<Normal ToleranceAngle=\"5\">0 0 1</Normal>"
                 "<RestrictTo Type=\"HalfSpace\">0.5 0.5 0  1 -1 0</RestrictTo><Magnitude>1</Magnitude>"));
  EXPECT_EQ(half.pressures[0].facets.size(), 1U);
}

TEST(FormatConstraints, TractionKeepsItsSign) {
  const auto model =
      parsed(constraint("Type=\"Traction\" NumFaces=\"2\" FaceType=\"Tri\" LoadShape=\"RAMP\"",
                        "<Faces>4 5 6  4 6 7</Faces><Magnitudes Type=\"DIFFORM\">0 0 1  0 2 0</Magnitudes>"));
  ASSERT_EQ(model.tractions[0].values.size(), 2U);
  EXPECT_EQ(model.tractions[0].values[0].z, 1);
  EXPECT_EQ(model.tractions[0].values[1].y, 2);
}

TEST(FormatConstraints, Springs) {
  const auto springs =
      parsed(constraint("Type=\"Spring\" NumNodes=\"2\" LoadShape=\"RAMP\" TargetLoadShape=\"TABLE\"",
                        "<Nodes>4 6</Nodes><Targets Type=\"DIFFORM\">0 0 1  0 1 0</Targets>"
                        "<Stiffness Type=\"UNIFORM\">7</Stiffness><StrainEnergyCap>0.5</StrainEnergyCap>"
                        "<TargetTable>0 0 1 1</TargetTable>"))
          .springs.at(0);
  EXPECT_EQ(springs.nodes, (std::vector<int>{4, 6}));
  EXPECT_EQ(springs.targets[1].y, 1);
  EXPECT_EQ(springs.stiffness, (std::vector<double>{7}));
  EXPECT_EQ(springs.strain_energy_cap, 0.5);
  EXPECT_EQ(springs.curve.shape, LoadShape::ramp);
  EXPECT_EQ(springs.target_curve.shape, LoadShape::table);
}

TEST(FormatConstraints, PlanesAndInitialVelocities) {
  for (const char* type : {"SlidingPlane", "Symmetry"}) {
    const auto model = parsed(constraint("Type=\"" + std::string(type) + "\"",
                                         "<Box>0 0 0 1 0 1</Box><PlaneNormal>2 0 0</PlaneNormal>"));
    EXPECT_EQ(model.planes.at(0).nodes, (std::vector<int>{0, 3, 4, 7}));
    EXPECT_EQ(model.planes[0].normal.x, 1);
  }
  const auto moving =
      parsed(constraint("Type=\"InitialVelocity\" NumNodes=\"all\"", "<Velocity>1 2 3</Velocity>"));
  EXPECT_EQ(moving.initial_velocities.at(0).nodes.size(), 8U);
  EXPECT_EQ(moving.initial_velocities[0].velocity.y, 2);
}

TEST(FormatContact, BodiesAndTheirMotion) {
  const auto model =
      parsed(with("<ContactPlate><a>0 0 2</a><b>1 0 2</b><c>0 1 2</c><Disp>0 0 -1</Disp><SlvNodes>4 5 6 "
                  "7</SlvNodes><FrictionCoefficient>0.2</FrictionCoefficient></ContactPlate>"
                  "<ContactCylinder LoadShape=\"RAMP\" EndTime=\"0.5\"><Origin>1 2 3</Origin><Axis>0 0 "
                  "1</Axis><Radius>0.5</Radius>"
                  "<Length>2</Length><OrigDisp>1 0 0</OrigDisp><RadChange>0.1</RadChange><SlvNodes "
                  "NumNodes=\"3\">2</SlvNodes></ContactCylinder>"
                  "<ContactUSProbe><Origin>1 2 3</Origin><Axis>0 0 "
                  "1</Axis><Radius>0.5</Radius><Length>2</Length></ContactUSProbe>"));
  ASSERT_EQ(model.bodies.size(), 3U);
  EXPECT_EQ(model.bodies[0].shape, RigidShape::plate);
  EXPECT_EQ(model.bodies[0].corners[2].y, 1);
  EXPECT_EQ(model.bodies[0].displacement.z, -1);
  EXPECT_EQ(model.bodies[0].motion.shape, LoadShape::poly345);
  EXPECT_EQ(model.bodies[0].nodes.size(), 4U);
  EXPECT_EQ(model.bodies[0].friction, 0.2);
  EXPECT_EQ(model.bodies[1].friction, 0);
  EXPECT_EQ(model.bodies[1].shape, RigidShape::cylinder);
  EXPECT_EQ(model.bodies[1].motion.shape, LoadShape::ramp);
  EXPECT_EQ(model.bodies[1].motion.end, 0.5);
  EXPECT_EQ(model.bodies[1].radius_change, 0.1);
  EXPECT_EQ(model.bodies[1].nodes, (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(model.bodies[2].shape, RigidShape::probe);
  EXPECT_TRUE(model.bodies[2].nodes.empty());  // all surface nodes
}

TEST(FormatContact, RigidSurfaces) {
  const auto model =
      parsed(with("<ContactSurface><Nodes NumNodes=\"4\">0 0 -1 1 0 -1 1 1 -1 0 1 -1</Nodes>"
                  "<Elements NumEls=\"2\" Type=\"T3\">0 1 2 0 2 3</Elements>"
                  "<FrictionCoefficient>0.25</FrictionCoefficient><SlaveNodes>0 1 2</SlaveNodes>"
                  "<Motion Type=\"Rotation\">0 0 1.5 1 2 3</Motion></ContactSurface>"
                  "<ContactSurface><Nodes NumNodes=\"4\">0 0 -1 1 0 -1 1 1 -1 0 1 -1</Nodes>"
                  "<Elements NumEls=\"1\" Type=\"Q4\">0 1 2 3</Elements>"
                  "<Motion Type=\"Translation\" LoadShape=\"POLY345\" EndTime=\"0.5\">0 0 "
                  "0.1</Motion></ContactSurface>"));
  ASSERT_EQ(model.surfaces.size(), 2U);
  EXPECT_EQ(model.surfaces[0].surface.facets.size(), 2U);
  EXPECT_EQ(model.surfaces[0].file, "test.xml");
  EXPECT_EQ(model.surfaces[0].facet_lines, (std::vector<int>{23, 23}));
  EXPECT_EQ(model.surfaces[0].friction, 0.25);
  EXPECT_EQ(model.surfaces[0].nodes, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(model.surfaces[0].angles.z, 1.5);
  EXPECT_EQ(model.surfaces[0].centre.y, 2);
  EXPECT_EQ(model.surfaces[0].motion.shape, LoadShape::ramp);
  EXPECT_EQ(model.surfaces[0].motion.end, 1);
  EXPECT_EQ(model.surfaces[1].surface.facets[0].node_count(), 4);
  EXPECT_EQ(model.surfaces[1].displacement.z, 0.1);
  EXPECT_EQ(model.surfaces[1].motion.shape, LoadShape::poly345);
  EXPECT_TRUE(model.surfaces[1].nodes.empty());
}

TEST(FormatContact, Responses) {
  const auto floor = [](const std::string& attributes) {
    return "<ContactSurface" + attributes +
           "><Nodes NumNodes=\"3\">0 0 -1 1 0 -1 1 1 -1</Nodes><Elements NumEls=\"1\" Type=\"T3\">0 1 "
           "2</Elements><RateConstraintDistance>0.25</RateConstraintDistance></ContactSurface>";
  };
  const std::string three =
      floor("") + floor(" Response=\"Multiplier\"") + floor(" Response=\"Penalty\" Stiffness=\"0.125\"");
  auto model = parsed(with(three));
  EXPECT_FALSE(model.contact.penalty);
  EXPECT_FALSE(model.surfaces[0].penalty);
  EXPECT_EQ(model.surfaces[2].penalty.value_or(0), 0.125);
  EXPECT_EQ(model.surfaces[2].distance.value_or(0), 0.25);
  model = parsed(replaced(with(three), "<TimeStep>", "<ContactResponse Type=\"Penalty\"/><TimeStep>"));
  EXPECT_EQ(model.contact.penalty.value_or(0), default_penalty);
  EXPECT_EQ(model.surfaces[0].penalty.value_or(0), default_penalty);
  EXPECT_FALSE(model.surfaces[1].penalty);
  EXPECT_EQ(model.surfaces[2].penalty.value_or(0), 0.125);
}

/// The base file's geometry as a sub-model with a name, moved along x.
std::string named_cube(const std::string& name, int x) {
  const auto from = base_xml.find("<Nodes"), to = base_xml.find("<SystemParams>");
  std::string content = base_xml.substr(from, to - from);
  const auto end = content.find("</Nodes>");
  std::string moved;
  for (const int z : {0, 1})
    for (const auto* corner : {"0 0 ", "1 0 ", "1 1 ", "0 1 "})
      moved += std::to_string(x + corner[0] - '0') + " " + corner[2] + " " + std::to_string(z) + " ";
  content.replace(0, end, "<Nodes NumNodes=\"8\" DOF=\"3\">" + moved);
  return "<SubModel Name=\"" + name + "\">" + content + "</SubModel>";
}

TEST(FormatContact, DeformableBodies) {
  const auto from = base_xml.find("<Nodes"), to = base_xml.find("<SystemParams>");
  std::string xml = base_xml;
  xml.replace(from, to - from,
              named_cube("left", 0) + named_cube("right", 3) +
                  "<ContactPair A=\"left\" B=\"right\">"
                  "<FrictionCoefficient>0.5</FrictionCoefficient></ContactPair>"
                  "<ContactPair A=\"left\" B=\"left\" Touch=\"0\"/>"
                  "<TiedSurfaces A=\"right\" B=\"left\" Distance=\"0.5\"/>"
                  "<ContactNodes>8 9 10</ContactNodes>");
  xml = replaced(xml, "<TimeStep>",
                 "<DoSelfCollision>1</DoSelfCollision><ContactSafetyMargin>0.01</ContactSafetyMargin>"
                 "<DeformableFrictionCoefficient>0.25</DeformableFrictionCoefficient><TimeStep>");
  const auto model = parsed(xml);
  EXPECT_TRUE(model.contact.self);
  EXPECT_TRUE(model.contact.between_bodies);
  EXPECT_EQ(model.contact.friction, 0.25);
  EXPECT_EQ(model.contact.offset, 0.01);
  EXPECT_EQ(model.contact.distance.value_or(0), 0.1);
  EXPECT_EQ(model.contact.nodes, (std::vector<int>{8, 9, 10}));
  ASSERT_EQ(model.bodies_by_name.size(), 2U);
  EXPECT_EQ(model.bodies_by_name[1].name, "right");
  EXPECT_EQ(model.bodies_by_name[1].first, 5);
  EXPECT_EQ(model.bodies_by_name[1].count, 5);
  ASSERT_EQ(model.contact.pairs.size(), 2U);
  EXPECT_EQ(model.contact.pairs[0].friction.value_or(0), 0.5);
  EXPECT_FALSE(model.contact.pairs[1].touch);
  ASSERT_EQ(model.ties.size(), 1U);
  EXPECT_EQ(model.ties[0].a, "right");
  EXPECT_EQ(model.ties[0].b, "left");
  EXPECT_EQ(model.ties[0].distance.value_or(0), 0.5);
  EXPECT_NE(message_of(replaced(xml, "Name=\"right\"", "Name=\"left\"")).find("used twice"),
            std::string::npos);
}

TEST(FormatContact, ShellsOfANamedSubModelHaveItsName) {
  const auto from = base_xml.find("<Nodes"), to = base_xml.find("<SystemParams>");
  const std::string sheet =
      "<SubModel Name=\"sheet\"><Nodes NumNodes=\"3\" DOF=\"3\">0 0 5 1 0 5 0 1 5</Nodes>"
      "<ShellElements Type=\"T3\" NumEls=\"1\">0 1 2</ShellElements><ShellElementSet Size=\"all\">"
      "<Material Type=\"NeoHookean\">1000 "
      "<Thickness>0.1</Thickness><Density>1000</Density></Material></ShellElementSet></SubModel>";
  std::string xml = base_xml;
  xml.replace(from, to - from, named_cube("cube", 0) + sheet);
  const auto model = parsed(xml);
  ASSERT_EQ(model.bodies_by_name.size(), 2U);
  EXPECT_EQ(model.bodies_by_name[0].triangle_count, 0);
  EXPECT_EQ(model.bodies_by_name[1].count, 0);
  EXPECT_EQ(model.bodies_by_name[1].first_triangle, 0);
  EXPECT_EQ(model.bodies_by_name[1].triangle_count, 1);
}

TEST(FormatTime, EveryElementOfSystemParams) {
  const auto model = parsed(replaced(
      replaced(base_xml, "<Model>", "<Model units=\"SI\">"), "<TimeStep>0.001</TimeStep>",
      "<TimeStep>auto</TimeStep><SafetyFactor>0.7</SafetyFactor><TimeStepper>Newmark</TimeStepper>"
      "<MassScaling>0.002</MassScaling><EnergyTolerance>0.1</EnergyTolerance><MonitorFreq>50</"
      "MonitorFreq><ROM>0</ROM>"
      "<DoDeformableCollision "
      "Type=\"MultiPass\">0</DoDeformableCollision><DoSelfCollision>0</DoSelfCollision>"
      "<QuasiStatic><ForceTolerance>1e-3</ForceTolerance><DisplacementTolerance>1e-6</DisplacementTolerance>"
      "<MaxSteps>1234</MaxSteps></QuasiStatic>"));
  EXPECT_EQ(model.units, "SI");
  EXPECT_FALSE(model.time.step);
  EXPECT_EQ(model.time.total, 1);
  EXPECT_EQ(model.time.safety, 0.7);
  EXPECT_EQ(model.time.stepper, Stepper::newmark);
  EXPECT_EQ(model.time.mass_scaling_step, 0.002);
  EXPECT_EQ(model.time.energy_tolerance, 0.1);
  EXPECT_EQ(model.time.monitor_every, 50);
  ASSERT_TRUE(model.time.quasi_static);
  EXPECT_EQ(model.time.quasi_static->force_tolerance, 1e-3);
  EXPECT_EQ(model.time.quasi_static->displacement_tolerance, 1e-6);
  EXPECT_EQ(model.time.quasi_static->max_steps, 1234);
  EXPECT_FALSE(parsed(base_xml).time.stepper);  // the engine's rule by element
}

TEST(FormatTime, QuasiStaticNeedsNoTotalTime) {
  const auto xml = replaced(replaced(base_xml, "<TotalTime>1</TotalTime>", "<QuasiStatic/>"),
                            "<TimeStep>0.001</TimeStep>", "");
  const auto model = parsed(xml);
  EXPECT_EQ(model.time.total, 0);
  EXPECT_EQ(model.displacements[0].curve.end, pseudo_time);  // the loads grow over the ramp, they do not jump
}

TEST(FormatOutput, FrequencyAndVariables) {
  const auto model =
      parsed(with("<Output Freq=\"10\"><Variable>U</Variable><Variable>EKin</Variable></Output>"));
  EXPECT_EQ(model.output.every, 10);
  EXPECT_EQ(model.output.variables, (std::vector<std::string>{"U", "EKin"}));
}

TEST(FormatWarnings, NameWhatHasNoEffect) {
  std::vector<std::string> warnings;
  parsed(
      replaced(
          with("<Constraint Type=\"Fix\" NumNodes=\"0\"/>"), "<SystemParams>",
          "<SystemParams><BVType>AABB</BVType><DoMultiPassContacts/><DeformableFrictionCoefficient>0</"
          "DeformableFrictionCoefficient>"
          "<ContactSafetyMargin>0</ContactSafetyMargin><RateConstraintDistance>0</RateConstraintDistance>"),
      &warnings);
  EXPECT_EQ(warnings.size(), 6U);
  warnings.clear();
  parsed(constraint("Type=\"Fix\" NumNodes=\"1\"", "<Nodes>1</Nodes><Magnitude>3</Magnitude>"), &warnings);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("test.xml:23: <Magnitude>: it has no effect"), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace glisson::test
