// Membranes and shells of the Threads backend: strips and packs against one triangle at a time in double.
#include <gtest/gtest.h>

#include <algorithm>

#include <glisson/cpu/solids/kernel_table.hpp>
#include <glisson/run/shell_packs/triangle_strips.hpp>
#include <glisson/shells/laws/laws.hpp>
#include <tests/shells/sheets.hpp>
#include <tests/support/cases.hpp>

namespace glisson::test {
namespace {

using shells::RotationFree;
using shells::TurnedTriangle;

/// A curved sheet held at two sides, free at one, mirrored at one, that is pushed out and swings.
Model swinging_sheet(const ShellSection& section) {
  Model model = sheet(
      17, 13,
      [](double s, double t) {
        return Vec3<double>{0.1 * s, 0.08 * t, 0.01 * std::sin(3 * s + 2 * t)};
      },
      section);
  model.fixed.push_back({sheet_nodes(model, [](const auto& X) { return X.x < 1e-9 || X.y < 1e-9; })});
  SlidingPlane plane;
  plane.nodes = sheet_nodes(model, [](const auto& X) { return X.y > 0.08 - 1e-9; });
  plane.normal = {0, 1, 0};
  model.planes.push_back(plane);
  const auto moving = sheet_nodes(model, [](const auto& X) { return X.x > 0.03; });
  model.initial_velocities.push_back({moving, {0.1, 0, 0.8}});
  return model;
}

struct Kind {
  const char* name;
  ShellSection section;
};

std::vector<Kind> kinds() {
  std::vector<Kind> all{
      {"Linear", membrane_section("Linear", {6000, 0.45}, 0.001)},
      {"NeoHookean", membrane_section("NeoHookean", {2000}, 0.001)},
      {"NeoHookeanCompressible", membrane_section("NeoHookeanCompressible", {2000, 20000}, 0.001)},
      {"Fung", membrane_section("Fung", {2000, 2}, 0.001)},
      {"TwoFibre", membrane_section("TwoFibre", {2000, 500, 1, 30}, 0.001)},
      {"Wrinkling", membrane_section("NeoHookean", {2000}, 0.001)},
      {"ViscousMembrane", membrane_section("NeoHookean", {2000}, 0.001)},
      {"Shell", shell_section(6000, 0.45, 0.002)},
      {"NeoHookeanShell", shell_section(6000, 0.45, 0.002)},
      {"ViscousShell", shell_section(6000, 0.45, 0.002)},
  };
  all[4].section.direction = {1, 0.3, 0};
  all[5].section.wrinkling = true;
  all[6].section.prony = {{0.4, 0.01}, {0.2, 0.1}};
  all[8].section.law = "NeoHookean", all[8].section.parameters = {2000};
  all[9].section.prony = {{0.4, 0.01}};
  return all;
}

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

class PackedShells : public testing::TestWithParam<Kind> {};

/// Every instruction set of this machine: forces, energy and history. Few steps, because a sheet in
/// compression buckles, which makes much of rounding.
TEST_P(PackedShells, MoveAsOneTriangleAtATimeInDouble) {
  constexpr int steps = 40;
  const Model model = swinging_sheet(GetParam().section);
  auto reference = simulate(model, serial_double);
  reference->step(steps);
  const auto expected = reference->displacement();
  const double size = std::abs(std::max_element(expected.begin(), expected.end(), [](auto& a, auto& b) {
                                 return std::abs(a.z) < std::abs(b.z);
                               })->z);
  ASSERT_GT(size, 0.01);
  const auto sets = patches::instruction_sets();
  for (std::size_t i = 0; i < sets.count; ++i) {
    if (!sets.sets[i].available()) continue;
    const std::string set = sets.sets[i].name;
    SimulationOptions options;
    options.threads = 2;
    options.instruction_set = set;
    auto packed = make_simulation(model, options);
    packed->step(steps);
    const auto u = packed->displacement();
    double error = 0;
    for (std::size_t n = 0; n < u.size(); ++n)
      error = std::max(error, std::sqrt(dot(u[n] - expected[n], u[n] - expected[n])));
    EXPECT_LT(error / size, 1e-6) << set;
    EXPECT_NEAR(packed->energies().strain, reference->energies().strain, 1e-5 * reference->energies().strain);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PackedShells, testing::ValuesIn(kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(TriangleStrips, HoldEveryTriangleOnceAndShareNodesAsPromised) {
  const Model model = sheet(
      9, 8,
      [](double s, double t) {
        return Vec3<double>{s, t, 0};
      },
      shell_section(1, 0, 1));
  const auto& triangles = model.mesh.triangles;
  const auto strips = shells::triangle_strips(triangles);
  std::vector<int> seen(triangles.size());
  for (const auto& strip : strips)
    for (std::size_t j = 0; j < 3 && strip[j].number >= 0; ++j) {
      const auto corner = [&](std::size_t k, int a) {
        return triangles[static_cast<std::size_t>(strip[k].number)]
                        [static_cast<std::size_t>(strip[k].corner[static_cast<std::size_t>(a)])];
      };
      ++seen[static_cast<std::size_t>(strip[j].number)];
      if (j == 0) continue;
      EXPECT_EQ(corner(j, 0), corner(j - 1, 1));
      EXPECT_EQ(corner(j, 1), corner(j - 1, 2));
    }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
  EXPECT_LT(strips.size(), triangles.size() / 2);
}

/// Forces of a shell triangle do not know which of its corners is the first.
TEST(TriangleStrips, TurnedConstantsGiveTheSameForces) {
  const Vec3<double> X[6] = {{0, 0, 0},     {1, 0.1, 0.2},    {0.3, 0.9, -0.1},
                             {1.2, 1, 0.3}, {-0.7, 0.8, 0.1}, {0.6, -0.8, 0.2}};
  const Vec3<double> u[6] = {{0.1, 0, 0.1},    {0, 0.05, 0.2},  {-0.1, 0.1, 0},
                             {0.2, 0.1, -0.1}, {0, -0.1, 0.15}, {0.05, 0.1, 0.1}};
  using enum shells::Across;
  const auto c =
      RotationFree::make(X, {neighbour, neighbour, neighbour}, {{}, {}, {}}, {1, 0.2, 0}, 0.01, 3, 0.4);
  const shells::ShellPatch<double>& patch = c;
  const auto law = shells::Linear<double>::load(std::array<double, 2>{100, 0.3}.data());
  const auto stress = [&](const auto& strain) { return law.second_pk(strain); };
  Vec3<double> f[6];
  RotationFree::forces(patch, u, stress, f);
  std::array<int, 3> corner{0, 1, 2};
  do {
    Vec3<double> u_turned[6], f_turned[6];
    const auto old = [&](int a) { return corner[static_cast<std::size_t>(a % 3)] + a / 3 * 3; };
    for (int a = 0; a < 6; ++a) u_turned[a] = u[old(a)];
    RotationFree::forces(shells::turned(patch, corner), u_turned, stress, f_turned);
    for (int a = 0; a < 6; ++a) {
      const auto difference = f_turned[a] - f[old(a)];
      EXPECT_LT(dot(difference, difference), 1e-24 * dot(f[0], f[0]));
    }
  } while (std::next_permutation(corner.begin(), corner.end()));
}

}  // namespace
}  // namespace glisson::test
