// Patches of membranes and shells, run phase by phase on the emulated device, against the plain double
// reference.
#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include <glisson/cpu/emulated_device.hpp>
#include <glisson/cpu/serial.hpp>
#include <glisson/shells/patches/staged_shells.hpp>
#include <glisson/shells/shell_forces.hpp>
#include <tests/shells/sheets.hpp>
#include <tests/support/inner_forces.hpp>

namespace glisson::test {
namespace {

template <class B, class R>
std::unique_ptr<SolidForces<R>> make_form(B& backend, const Model& model, const Numbering& numbering) {
  if constexpr (B::space == Space::device)
    return std::make_unique<shells::StagedShells<B, R>>(backend, model, numbering, nullptr);
  else
    return std::make_unique<shells::ShellForces<B, R>>(backend, model, numbering, nullptr);
}

Vec3<double> displacement(const Vec3<double>& X, double scale) {
  const double s = 0.004 * scale;
  return {s * std::sin(60 * X.y + 2), s * std::cos(50 * X.x - 30 * X.y),
          2 * s * std::sin(40 * X.x + 50 * X.y)};
}

constexpr Vec3<double> start{0.001, 0.002, 0.003};

template <class B, class R>
struct Shells : InnerForces<B, R> {
  explicit Shells(const Model& model, B backend = B())
      : InnerForces<B, R>(std::move(backend), model, make_form<B, R>, {displacement, start}) {}
};

template <class R>
double difference(const std::vector<Vec4<R>>& a, const std::vector<Vec4<double>>& b) {
  return test::difference(a, b, start);
}

/// Of opposing forces around each node, in R.
template <class R>
constexpr double rounding() {
  return sizeof(R) == 4 ? 2e-5 : 1e-12;
}

/// A curved sheet of 2 x 23 x 19 triangles in several patches: one border clamped, one in a symmetry plane,
/// two free. Every third triangle is in a second section, so that a rotation-free section has neighbours in
/// another one; thickness, and the direction where there is one, differ from triangle to triangle in the
/// first.
Model curved_sheet(ShellSection first, const ShellSection& second) {
  Model model = sheet(
      23, 19,
      [](double s, double t) {
        return Vec3<double>{0.1 * s, 0.08 * t, 0.01 * std::sin(3 * s + 2 * t)};
      },
      std::move(first), true);
  model.shells.push_back(second);
  model.shells[1].elements.clear(), model.shells[0].elements.clear();
  for (int e = 0; e < static_cast<int>(model.mesh.triangles.size()); ++e)
    model.shells[e % 3 == 1 ? 1 : 0].elements.push_back(e);
  for (auto& section : model.shells) std::reverse(section.elements.begin(), section.elements.end());
  ShellSection& varied = model.shells[0];
  for (std::size_t k = 0; k < varied.elements.size(); ++k)
    varied.element_thickness.push_back(varied.thickness * (1 + 0.02 * double(k % 20)));
  if (varied.direction.x > 0)
    for (std::size_t k = 0; k < varied.elements.size(); ++k)  // zero: the first side
      varied.element_direction.push_back({double(k % 3), 0.3 * double(k % 2), 0});
  model.clamped_nodes = sheet_nodes(model, [](const auto& X) { return X.x < 1e-9; });
  SlidingPlane plane;
  plane.nodes = sheet_nodes(model, [](const auto& X) { return X.y > 0.08 - 1e-9; });
  plane.normal = {0, 1, 0};
  model.planes.push_back(plane);
  return model;
}

struct Kind {
  const char* name;
  ShellSection section;
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

ShellSection neo_hookean_shell(const std::string& law, std::vector<double> parameters) {
  ShellSection section = shell_section(6000, 0.45, 0.002);
  section.law = law, section.parameters = std::move(parameters);
  return section;
}

/// Every law, and where they may have them with a tension field and with Prony terms.
std::vector<Kind> kinds() {
  std::vector<Kind> all;
  all.push_back({"Linear", membrane_section("Linear", {6000, 0.45}, 0.001)});
  all.push_back({"NeoHookean", membrane_section("NeoHookean", {2000}, 0.001)});
  all.push_back({"Compressible", membrane_section("NeoHookeanCompressible", {2000, 20000}, 0.001)});
  all.push_back({"Fung", membrane_section("Fung", {2000, 2}, 0.001)});
  all.push_back({"TwoFibre", membrane_section("TwoFibre", {2000, 500, 1, 30}, 0.001)});
  all.push_back({"LinearShell", shell_section(6000, 0.45, 0.002)});
  all.push_back({"NeoHookeanShell", neo_hookean_shell("NeoHookean", {2000})});
  all.push_back({"CompressibleShell", neo_hookean_shell("NeoHookeanCompressible", {2000, 20000})});
  all[4].section.direction = {1, 0.3, 0};
  return all;
}

using Case = std::tuple<Kind, bool, bool>;  // law, tension field, Prony terms
std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Kind& kind : kinds())
    for (const bool wrinkling : {false, true})
      for (const bool viscous : {false, true}) {
        const bool bends = kind.section.formulation == ShellFormulation::rotation_free;
        if (wrinkling && (bends || kind.section.law == "TwoFibre")) continue;
        cases.emplace_back(kind, wrinkling, viscous);
      }
  return cases;
}

class StagedShellForms : public testing::TestWithParam<Case> {
 protected:
  static Model model() {
    auto [kind, wrinkling, viscous] = GetParam();
    kind.section.wrinkling = wrinkling;
    if (viscous) kind.section.prony = {{0.4, 0.01}, {0.2, 0.1}};
    ShellSection second = kind.section;
    second.thickness *= 1.7;
    return curved_sheet(kind.section, second);
  }
  template <class R>
  void compare(const Model& model) {
    Shells<EmulatedDevice, R> staged(model);
    Shells<Serial, double> plain(model);
    for (const double scale : {1.0, 0.7}) {
      EXPECT_LT(difference(staged.forces(scale), plain.forces(scale)), rounding<R>());
      const double energy = plain.strain_energy(scale);
      EXPECT_GT(energy, 0);
      EXPECT_NEAR(staged.strain_energy(scale), energy, rounding<R>() * energy);
    }
    const auto history = staged.get().history(), expected = plain.get().history();
    ASSERT_EQ(history.size(), expected.size());
    double largest = 0;
    for (const double Y : expected) largest = std::max(largest, std::abs(Y));
    EXPECT_EQ(largest > 0, !expected.empty());
    for (std::size_t i = 0; i < history.size(); ++i)
      ASSERT_NEAR(history[i], expected[i], rounding<R>() * largest);
  }
};

TEST_P(StagedShellForms, AgreeWithTheReference) {
  compare<float>(model());
  compare<double>(model());
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  const auto& [kind, wrinkling, viscous] = info.param;
  return std::string(kind.name) + (wrinkling ? "_wrinkling" : "") + (viscous ? "_viscous" : "");
}
INSTANTIATE_TEST_SUITE_P(All, StagedShellForms, testing::ValuesIn(all_cases()), name_of);

/// A membrane beside a shell, and a flap of membrane on the middle line, where three triangles meet.
Model branching() {
  Model model = curved_sheet(shell_section(6000, 0.45, 0.002), membrane_section("NeoHookean", {2000}, 0.001));
  const std::vector<int> line =
      sheet_nodes(model, [](const auto& X) { return std::abs(X.x - 0.1 * 11 / 23) < 1e-9; });
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto X = model.mesh.X[static_cast<std::size_t>(line[i])];
    model.mesh.X.push_back({X.x, X.y, X.z + 0.005});
    model.shells[1].elements.push_back(static_cast<int>(model.mesh.triangles.size()));
    model.mesh.triangles.push_back({line[i], line[i + 1], model.mesh.node_count() - 1});
  }
  return model;
}

TEST(StagedShellModels, MayBranch) {
  const Model model = branching();
  Shells<EmulatedDevice, double> staged(model);
  Shells<Serial, double> plain(model);
  EXPECT_LT(difference(staged.forces(1), plain.forces(1)), rounding<double>());
}

/// What the sweep over the nodes adds is what add_forces() would have added, bit for bit.
TEST(StagedShellModels, MayLeaveTheSharedForces) {
  const Model model = branching();
  Shells<EmulatedDevice, float> whole(model), parts(model);
  const auto expected = whole.forces(1), f = parts.forces_with_left(1);
  EXPECT_EQ(std::memcmp(f.data(), expected.data(), f.size() * sizeof f[0]), 0);
}

TEST(StagedShellBits, DoNotDependOnTheOrderOfThreads) {
  const Model model = branching();
  Shells<EmulatedDevice, float> first(model, EmulatedDevice(1));
  const auto expected = first.forces(1);
  const double energy = first.strain_energy(1);
  for (const std::uint64_t seed : {2, 3, 4}) {
    Shells<EmulatedDevice, float> other(model, EmulatedDevice(seed));
    const auto f = other.forces(1);
    EXPECT_EQ(std::memcmp(f.data(), expected.data(), f.size() * sizeof f[0]), 0);
    EXPECT_EQ(other.strain_energy(1), energy);
  }
}

TEST(StagedShellState, EvaluationAloneLeavesTheHistory) {
  ShellSection section = shell_section(6000, 0.45, 0.002);
  section.prony = {{0.4, 0.01}};
  const Model model = curved_sheet(section, section);
  Shells<EmulatedDevice, float> staged(model), other(model);
  staged.forces(1);
  const auto history = staged.get().history();
  staged.forces(1, false);
  EXPECT_EQ(staged.get().history(), history);
  other.get().set_history(history);
  EXPECT_EQ(other.get().history(), history);
}

}  // namespace
}  // namespace glisson::test
