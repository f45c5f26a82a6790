// validate(): every refusal with the word that tells the user what is wrong, every warning, and silence for a
// good model.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/model.hpp>

namespace glisson {
namespace {

Model good_model() {
  Model model;
  model.mesh.X = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (const auto& nodes : {std::array{0, 1, 3, 4}, std::array{1, 2, 3, 6}, std::array{1, 6, 4, 5},
                            std::array{3, 4, 6, 7}, std::array{1, 3, 4, 6}})
    model.mesh.add_element(Shape::tetrahedron, nodes);
  model.sections.push_back(
      {"set", Formulation::t4, {"NH", {1000, 50000}, 1000, {{0.3, 1}}, {}, {}}, {0, 1, 2, 3, 4}, 0.075});
  model.fixed.push_back({{0, 1, 2, 3}, all_axes});
  model.displacements.push_back({{4, 5, 6, 7}, 4, {0.1}, {}});
  model.time.total = 1;
  return model;
}

struct Case {
  const char* word;  ///< of the message
  std::function<void(Model&)> spoil;
};

MaterialSpec& material(Model& model) { return model.sections[0].material; }
void law(Model& model, const char* name, std::vector<double> parameters) {
  material(model).law = name;
  material(model).parameters = std::move(parameters);
}
const double nan = std::numeric_limits<double>::quiet_NaN();

const Case refused[] = {
    {"no elements", [](Model& m) { m.mesh = {}; }},
    {"not finite", [](Model& m) { m.mesh.X[3].y = nan; }},
    {"node 8", [](Model& m) { m.mesh.nodes[2] = 8; }},
    {"node 3 twice", [](Model& m) { m.mesh.nodes[0] = m.mesh.nodes[2]; }},
    {"labels",
     [](Model& m) {
       m.mesh.label = {1, 2};
     }},
    {"inverted", [](Model& m) { std::swap(m.mesh.nodes[0], m.mesh.nodes[1]); }},
    {"flat",
     [](Model& m) {
       m.mesh.X[4] = {0.5, 0.5, 0};
     }},
    {"no element has a material", [](Model& m) { m.sections.clear(); }},
    {"element 4: it is in no ElementSet", [](Model& m) { m.sections[0].elements.pop_back(); }},
    {"element 2 is also in set",
     [](Model& m) { m.sections.push_back(m.sections[0]), m.sections[1].elements = {2}; }},
    {"lists element 5", [](Model& m) { m.sections[0].elements.push_back(5); }},
    {"does not fit the shape", [](Model& m) { m.sections[0].formulation = Formulation::h8; }},
    {"has no elements",
     [](Model& m) { m.sections.push_back(m.sections[0]), m.sections[1].elements.clear(); }},
    {"hourglass", [](Model& m) { m.sections[0].hourglass = -1; }},
    {"no law 'XX'", [](Model& m) { law(m, "XX", {1}); }},
    {"needs 2 parameters", [](Model& m) { law(m, "NH", {1}); }},
    {"mu of NH is 0",
     [](Model& m) {
       law(m, "NH", {0, 1});
     }},
    {"kappa of NH is -1",
     [](Model& m) {
       law(m, "NH", {1, -1});
     }},
    {"nu of LE is 0.5",
     [](Model& m) {
       law(m, "LE", {1, 0.5});
     }},
    {"between -1 and 0.5",
     [](Model& m) {
       law(m, "LE", {1, -1});
     }},
    {"lambda_m of AB",
     [](Model& m) {
       law(m, "AB", {1, 0, 1});
     }},
    {"c10 + c01",
     [](Model& m) {
       law(m, "PY", {1, -1, 0, 0, 0, 1});
     }},
    {"fibre direction",
     [](Model& m) {
       law(m, "TI", {1, 1, 1, 0, 0, 0});
     }},
    {"eta of TI",
     [](Model& m) {
       law(m, "TI", {1, 1, -1, 0, 0, 1});
     }},
    {"mu alpha",
     [](Model& m) {
       law(m, "OG", {1, -2, 0, 1, 0, 1, 5});
     }},
    {"exponent",
     [](Model& m) {
       law(m, "OG", {1, 2, 1, 0, 0, 1, 5});
     }},
    {"mu of NH is nan",
     [](Model& m) {
       law(m, "NH", {nan, 1});
     }},
    {"density is 0", [](Model& m) { material(m).density = 0; }},
    {"tau = 0", [](Model& m) { material(m).isochoric[0].tau = 0; }},
    {"alpha = -0.1",
     [](Model& m) {
       material(m).volumetric = {{-0.1, 1}};
     }},
    {"sum to 1",
     [](Model& m) {
       material(m).isochoric = {{0.5, 1}, {0.5, 2}};
     }},
    {"3 per-element values",
     [](Model& m) {
       material(m).element_parameters = {{0, {1, 1, 1}}};
     }},
    {"element 3: the parameter mu",
     [](Model& m) {
       material(m).element_parameters = {{0, {1, 1, 1, -1, 1}}};
     }},
    {"does not have",
     [](Model& m) {
       material(m).element_parameters = {{2, {1, 1, 1, 1, 1}}};
     }},
    {"selection of nodes is empty", [](Model& m) { m.fixed[0].nodes.clear(); }},
    {"Fix 0: it names node 8", [](Model& m) { m.fixed[0].nodes.push_back(8); }},
    {"along no axis", [](Model& m) { m.displacements[0].axes = 0; }},
    {"2 values for 4",
     [](Model& m) {
       m.displacements[0].values = {1, 2};
     }},
    {"not finite", [](Model& m) { m.displacements[0].values = {nan}; }},
    {"time interval", [](Model& m) { m.displacements[0].curve.end = -1; }},
    {"table is empty", [](Model& m) { m.displacements[0].curve.shape = LoadShape::table; }},
    {"do not increase",
     [](Model& m) {
       m.displacements[0].curve.shape = LoadShape::table;
       m.displacements[0].curve.table = {{0, 1}, {0, 2}};
     }},
    {"selection of facets is empty", [](Model& m) { m.pressures.push_back({}); }},
    {"element 9",
     [](Model& m) {
       m.pressures.push_back({{Facet{{0, 1, 2, -1}, 9}}, 1, {}});
     }},
    {"not finite",
     [](Model& m) {
       m.tractions.push_back({outer_surface(m.mesh), {{nan, 0, 0}}, {}});
     }},
    {"push away",
     [](Model& m) {
       m.springs.push_back({{0}, {{}}, {-1}, {}});
     }},
    {"cap",
     [](Model& m) {
       m.springs.push_back({{0}, {{}}, {1}, {}, {}, 0.0});
     }},
    {"unit vector",
     [](Model& m) {
       m.planes.push_back({{0}, {2, 0, 0}});
     }},
    {"one line", [](Model& m) { m.bodies.push_back({}); }},
    {"radius",
     [](Model& m) {
       m.bodies.push_back({RigidShape::probe, "", {}, {}, {0, 0, 1}, 0, 1});
     }},
    {"total time", [](Model& m) { m.time.total = 0; }},
    {"time step", [](Model& m) { m.time.step = -1; }},
    {"safety", [](Model& m) { m.time.safety = 1.5; }},
    {"damping", [](Model& m) { m.time.damping = nan; }},
    {"mass scaling", [](Model& m) { m.time.mass_scaling_step = 0; }},
    {"force tolerance", [](Model& m) { m.time.quasi_static = QuasiStatic{0}; }},
    {"units \"cgs\"", [](Model& m) { m.units = "cgs"; }},
};

TEST(Validate, RefusesWhatCannotBeSimulated) {
  for (const auto& [word, spoil] : refused) {
    Model model = good_model();
    spoil(model);
    try {
      validate(model);
      ADD_FAILURE() << "accepted: " << word;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << error.what() << " lacks: " << word;
    }
  }
}

const Case warned[] = {
    {"belong to no element",
     [](Model& m) {
       m.mesh.X.push_back({2, 2, 2});
     }},
    {"another one lies", [](Model& m) { m.mesh.X.push_back(m.mesh.X[4]), m.mesh.nodes[3] = 8; }},
    {"badly shaped",
     [](Model& m) {
       m.mesh.X[4] = {0.05, 0.05, 0.01};
     }},
    {"nothing will happen", [](Model& m) { m.displacements.clear(); }},
    {"lock",
     [](Model& m) {
       law(m, "NH", {1, 1000});
     }},
    {"lambda_m",
     [](Model& m) {
       law(m, "AB", {1, 0.9, 1});
     }},
    {"large",
     [](Model& m) {
       m.units = "SI",
       m.mesh.X = {{}, {99}, {99, 99}, {0, 99}, {0, 0, 99}, {99, 0, 99}, {99, 99, 99}, {0, 99, 99}};
     }},
    {"density", [](Model& m) { m.units = "SI", material(m).density = 1; }},
    {"kg/mm^3", [](Model& m) { m.units = "mm-kg-s"; }},
    {"mu = 1 Pa",
     [](Model& m) {
       m.units = "SI", law(m, "NH", {1, 50});
     }},
    {"nothing holds",
     [](Model& m) { m.time.quasi_static = QuasiStatic{}, m.fixed.clear(), m.displacements.clear(); }},
    {"1e+12 steps", [](Model& m) { m.time.step = 1e-12; }},
};

TEST(Validate, WarnsOfWhatLooksWrong) {
  for (const auto& [word, spoil] : warned) {
    Model model = good_model();
    spoil(model);
    std::string all;
    ASSERT_NO_THROW(for (const auto& line : validate(model)) all += line + "\n") << word;
    EXPECT_NE(all.find(word), std::string::npos) << all << " lacks: " << word;
  }
}

TEST(Validate, IsSilentForAGoodModel) {
  Model model = good_model();
  model.units = "SI";
  EXPECT_TRUE(validate(model).empty());
}

TEST(Validate, KnowsFoldedHexahedra) {
  Model model = good_model();
  model.mesh.begin = {0};
  model.mesh.nodes.clear();
  model.mesh.shape.clear();
  model.mesh.add_element(Shape::hexahedron, std::array{0, 1, 2, 3, 4, 5, 6, 7});
  model.sections[0].elements = {0};
  model.sections[0].formulation = Formulation::h8_full;
  EXPECT_NO_THROW(validate(model));
  model.mesh.nodes[7] = 4;  // a wedge
  EXPECT_THROW(validate(model), Error);
  model.mesh.nodes[7] = 7;
  model.mesh.X[6] = {0.05, 0.05, 0.05};  // one corner pushed through the middle
  EXPECT_THROW(validate(model), Error);
  std::swap(model.mesh.X[0], model.mesh.X[4]);
  EXPECT_THROW(validate(model), Error);
}

}  // namespace
}  // namespace glisson
