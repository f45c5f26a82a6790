// Single precision on the fast backend against the double reference, feature by feature. Writes the table of
// doc/precision.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iomanip>

#include <tests/shells/sheets.hpp>
#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

struct Feature {
  std::string name;
  Model model;
};

const std::vector<double> nh{1000, 20000};

/// A cantilever that falls under gravity and swings: large rotation, moderate strain.
Model swinging(Formulation formulation, const Material& material) {
  Model model = box_model({12, 4, 4}, {0.12, 0.04, 0.04}, formulation, material, 0.1);
  model.fixed.push_back({face(model.mesh, 0, 0), all_axes});
  model.gravity.push_back({{}, {0, 0, -3}, ramp_curve(0.3)});
  model.time.total = 0.3;
  return model;
}

std::vector<Facet> top_facets(const Model& model) {
  std::vector<Facet> facets;
  for (int e = 0; e < model.mesh.element_count(); ++e) {
    const auto a = model.mesh.element(e);
    if (std::abs(model.mesh.X[static_cast<std::size_t>(a[4])].z - 0.04) < 1e-9)
      facets.push_back({{a[4], a[5], a[6], a[7]}, e});
  }
  return facets;
}

/// A strip of triangles, 20 x 5 fields, that is held at one end, falls under gravity and swings.
Model swinging_strip(const ShellSection& section) {
  Model model = sheet(
      20, 5,
      [](double s, double t) {
        return Vec3<double>{0.12 * s, 0.03 * t, 0.004 * std::sin(3 * s)};
      },
      section);
  model.fixed.push_back({face(model.mesh, 0, 0), all_axes});
  model.clamped_nodes = model.fixed[0].nodes;
  model.gravity.push_back({{}, {0, 0, -3}, ramp_curve(0.3)});
  model.time.total = 0.3;
  return model;
}

/// Membranes have no bending: they hang like cloth, loaded along their length as well.
Model swinging_cloth(ShellSection section, bool wrinkles) {
  section.wrinkling = wrinkles;
  Model model = swinging_strip(section);
  model.clamped_nodes.clear();
  model.gravity[0].acceleration = {1, 0, -3};
  return model;
}

void add_shells(std::vector<Feature>& all) {
  const double h = 1e-3;
  ShellSection two_fibre = membrane_section("TwoFibre", {2e4, 1e4, 1, 30}, h);
  two_fibre.direction = {1, 0, 0};
  all.push_back({"membrane, Linear", swinging_cloth(membrane_section("Linear", {6e4, 0.3}, h), false)});
  all.push_back({"membrane, NeoHookean", swinging_cloth(membrane_section("NeoHookean", {2e4}, h), false)});
  all.push_back({"membrane, NeoHookeanCompressible",
                 swinging_cloth(membrane_section("NeoHookeanCompressible", {2e4, 1e5}, h), false)});
  all.push_back({"membrane, Fung", swinging_cloth(membrane_section("Fung", {2e4, 2}, h), false)});
  all.push_back({"membrane, TwoFibre", swinging_cloth(two_fibre, false)});
  all.push_back({"membrane with wrinkles", swinging_cloth(membrane_section("NeoHookean", {2e4}, h), true)});
  all.push_back({"shell, Linear", swinging_strip(shell_section(1e6, 0.3, h))});
  Model model = swinging_strip(shell_section(1e6, 0.3, h));
  model.shells[0].law = "NeoHookean", model.shells[0].parameters = {3e5};
  all.push_back({"shell, NeoHookean", model});
  model.shells[0].prony = {{0.3, 0.02}};
  all.push_back({"shell, Prony", model});
}

std::vector<Feature> features() {
  std::vector<Feature> all;
  for (const auto f :
       {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_fixed, Formulation::h8_full})
    all.push_back({std::string("element ") + name_of(f), swinging(f, {"NH", nh})});
  const std::vector<std::pair<std::string, std::vector<double>>> laws{
      {"LE", {3000, 0.45}},
      {"AB", {1000, 2, 20000}},
      {"PY", {300, 200, 50, 50, 20, 20000}},
      {"TI", {1000, 20000, 3000, 1, 1, 0}},
      {"OG", {800, 2, -100, -4, 0, 1, 20000}}};
  for (const auto& [law, parameters] : laws)
    all.push_back({"law " + law, swinging(Formulation::t4, {law, parameters})});
  Model model = swinging(Formulation::t4, {"NH", nh});
  model.sections[0].material.isochoric = {{0.3, 0.02}, {0.2, 0.2}};
  model.sections[0].material.volumetric = {{0.1, 0.05}};
  all.push_back({"Prony, 2 + 1 terms", model});
  model = swinging(Formulation::h8, {"NH", nh});
  model.pressures.push_back({top_facets(model), 20, smooth_curve(0.3)});
  all.push_back({"pressure", model});
  model = swinging(Formulation::h8, {"NH", nh});
  model.tractions.push_back({top_facets(model), {{5, 5, -5}}, smooth_curve(0.3)});
  all.push_back({"traction", model});
  model = swinging(Formulation::t4, {"NH", nh});
  model.springs.push_back(
      {face(model.mesh, 2, 0.04), {{0, 0, 0.01}}, {0.5}, ramp_curve(0.3), step_curve(0.3), 1e-5});
  all.push_back({"springs with energy cap", model});
  model = swinging(Formulation::h8, {"NH", nh});
  RigidBody probe;
  probe.shape = RigidShape::probe;
  probe.origin = {0.06, 0.02, -0.05}, probe.axis = {0, 0, 1}, probe.radius = 0.01, probe.length = 0.03;
  probe.displacement = {0, 0, 0.012}, probe.motion.end = 0.3;
  model.bodies.push_back(probe);
  all.push_back({"ultrasound probe", model});
  model = swinging(Formulation::h8, {"NH", nh});
  model.time.quasi_static = QuasiStatic{1e-5, 1e-5, 100000};
  all.push_back({"dynamic relaxation", model});
  add_shells(all);
  return all;
}

/// Where the table goes: $GLISSON_RESULTS, else the build folder.
std::string table_path(const Case& c) {
  const char* folder = std::getenv("GLISSON_RESULTS");
  return std::string(folder ? folder : GLISSON_BINARY_DIR) + "/precision-" + c.name + ".md";
}

/// Both must take the same steps to be compared: those of the reference, on a GPU, where they cost nothing,
/// at least 1000.
Model with_equal_steps(Model model, const Case& c) {
  if (model.time.quasi_static) return model;
  const double step = simulate(model, serial_double)->report().dt;
  const bool gpu = std::string(c.device) != "cpu";  // or what stands for one
  model.time.step = gpu ? std::min(step, model.time.total / 1000) : step;
  return model;
}

/// A relaxation stops anywhere inside its tolerance; contact decides on a threshold.
double bound_of(const Model& model, const Case& c) {
  if (model.time.quasi_static || !model.bodies.empty()) return 1e-3;
  return std::string(c.device) != "cpu" ? 1e-5 : 2e-5;
}

class SinglePrecision : public Matrix {};

TEST_P(SinglePrecision, AgainstTheDoubleReference) {
  std::ofstream table(table_path(GetParam()));
  table << "| feature | steps | largest difference / largest displacement |\n|---|---|---|\n"
        << std::scientific << std::setprecision(1);
  for (const auto& feature : features()) {
    const Model model = with_equal_steps(feature.model, GetParam());
    auto fast = simulate(model, GetParam()), exact = simulate(model, serial_double);
    while (!fast->finished()) fast->step(100);
    while (!exact->finished()) exact->step(100);
    const auto a = fast->displacement(), b = exact->displacement();
    double difference = 0, size = 0;
    for (std::size_t n = 0; n < a.size(); ++n) {
      const auto d = a[n] - b[n];
      difference = std::max(difference, std::sqrt(dot(d, d)));
      size = std::max(size, std::sqrt(dot(b[n], b[n])));
    }
    table << "| " << feature.name << " | " << exact->step_count() << " | " << difference / size << " |\n";
    EXPECT_GT(size, 1e-3) << feature.name;
    EXPECT_LT(difference / size, bound_of(model, GetParam())) << feature.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, SinglePrecision, testing::Values(threads_float, emulated_float, cuda_float),
                         case_name);

}  // namespace
}  // namespace glisson::test
