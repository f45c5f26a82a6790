// What outputs show of membranes and shells, against closed forms, and the files that hold it.
#include <gtest/gtest.h>

#include <sstream>

#include <glisson/models/output/shell_sheets.hpp>
#include <glisson/shells/shell_fields.hpp>
#include <tests/shells/sheets.hpp>
#include <tests/support/models.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

Model flat_sheet(ShellSection section) {
  return sheet(
      4, 3,
      [](double s, double t) {
        return Vec3<double>{0.2 * s, 0.1 * t, 0};
      },
      std::move(section));
}

/// The snapshot of a displacement u(X).
Snapshot state_of(const Model& model, const std::function<Vec3<double>(const Vec3<double>&)>& u) {
  Snapshot state;
  for (const auto& X : model.mesh.X) state.displacement.push_back(u(X));
  state.shells = shells::shell_fields(model, state.displacement, {}, 0);
  return state;
}

Vec3<double> corner(const ShellSheet& sheet, std::size_t triangle, std::size_t k) {
  const auto p = static_cast<std::size_t>(sheet.surface.triangles[triangle][k]);
  return sheet.surface.X[p] + sheet.displacement[p];
}

/// S = mu (1 - C33 / Cii) of the incompressible neo-Hookean membrane with C33 = 1 / (l1 l2)^2.
TEST(ShellOutputs, BiaxialStretchOfANeoHookeanMembrane) {
  const double mu = 1000, h = 0.002, l1 = 1.3, l2 = 0.9;
  const Model model = flat_sheet(membrane_section("NeoHookean", {mu}, h));
  const ShellFields f = state_of(model, [&](const auto& X) {
                          return Vec3<double>{(l1 - 1) * X.x, (l2 - 1) * X.y, 0};
                        }).shells;
  const double c33 = 1 / (l1 * l1 * l2 * l2);
  ASSERT_EQ(f.size(), 24u);
  for (std::size_t t = 0; t < f.size(); ++t) {
    EXPECT_NEAR(f.stress[t].xx, mu * (1 - c33 / (l1 * l1)), 1e-9 * mu);
    EXPECT_NEAR(f.membrane_force[t].yy, h * mu * (1 - c33 / (l2 * l2)), 1e-9 * mu * h);
    EXPECT_NEAR(f.strain[t].xx, (l1 * l1 - 1) / 2, 1e-12);
    EXPECT_NEAR(f.strain[t].zz, (c33 - 1) / 2, 1e-12);
    EXPECT_NEAR(f.area_ratio[t], l1 * l2, 1e-12);
    EXPECT_NEAR(f.thickness[t], h / (l1 * l2), 1e-15);
    EXPECT_NEAR(f.J[t], 1, 1e-12);
    const double W = mu / 2 * (l1 * l1 + l2 * l2 + c33 - 3);
    EXPECT_NEAR(f.energy[t], W * h * 0.02 / 24, 1e-12 * W);
  }
}

/// A plate laid on a cylinder of radius R about the y axis: curvature 1/R, M = D / R along and nu D / R
/// across. Rotation-free triangles of a regular mesh give it up to (edge / R)^2.
TEST(ShellOutputs, BendingToACylinder) {
  const double E = 1e6, nu = 0.3, h = 0.005, R = 2, D = E * h * h * h / (12 * (1 - nu * nu));
  const Model model = flat_sheet(shell_section(E, nu, h));
  const auto bent = [&](const Vec3<double>& X) {
    return Vec3<double>{R * std::sin(X.x / R) - X.x, 0, R * (std::cos(X.x / R) - 1)};
  };
  const Snapshot state = state_of(model, bent);
  const ShellFields& f = state.shells;
  const std::size_t inside = 10;  // second row, no border
  EXPECT_NEAR(f.curvature[inside].xx, -1 / R, 2e-3 / R);
  EXPECT_NEAR(f.moment[inside].xx, -D / R, 2e-3 * D / R);
  EXPECT_NEAR(f.moment[inside].yy, -nu * D / R, 3e-3 * nu * D / R);
  // the outer face is stretched by h / 2R, the inner one shortened
  const ShellSheet faces = shell_faces(model.mesh, state);
  const std::size_t outer = 2 * inside, inner = outer + 1;
  ASSERT_EQ(faces.side[outer], 1);
  EXPECT_NEAR(faces.values.strain[outer].xx - faces.values.strain[inner].xx, h / R, 2e-3 * h / R);
  EXPECT_NEAR(faces.values.stress[outer].xx - faces.values.stress[inner].xx, 12 * D / R / (h * h),
              2e-3 * 12 * D / R / (h * h));
}

TEST(ShellOutputs, FacesLieHalfTheThicknessAwayAndCloseTheVolume) {
  const double h = 0.004, l = 1.25;
  const Model model = flat_sheet(membrane_section("NeoHookean", {1000}, h));
  const Snapshot state = state_of(model, [&](const auto& X) {
    return Vec3<double>{(l - 1) * X.x, (l - 1) * X.y, 0};
  });
  const ShellSheet faces = shell_faces(model.mesh, state);
  double volume = 0;
  for (std::size_t t = 0; t < faces.surface.triangles.size(); ++t) {
    volume += dot(corner(faces, t, 0), cross(corner(faces, t, 1), corner(faces, t, 2))) / 6;
    if (faces.side[t] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(corner(faces, t, k).z, faces.side[t] * h / (2 * l * l), 1e-12);
  }
  EXPECT_NEAR(volume, 0.02 * h, 1e-12);  // incompressible
}

/// Three triangles at one edge have no common normal there: each keeps faces of its own.
TEST(ShellOutputs, FacesOfBranchesEndAtTheBranch) {
  Model model;
  model.mesh.X = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  model.mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  model.shells = {membrane_section("NeoHookean", {1000}, 0.1)};
  model.shells[0].elements = {0, 1, 2};
  const ShellSheet faces =
      shell_faces(model.mesh, state_of(model, [](const auto&) { return Vec3<double>{}; }));
  EXPECT_EQ(faces.surface.X.size(), 18u);
  EXPECT_EQ(faces.surface.triangles.size(), 2u * 3u + 2u * 9u);
}

class ShellFieldsOfRuns : public Matrix {};

/// The same fields from every backend, and the energy of the triangles is that of the account.
TEST_P(ShellFieldsOfRuns, SumOfTriangleEnergiesIsTheStrainEnergy) {
  Model model = flat_sheet(shell_section(1e5, 0.3, 0.004));
  model.fixed.push_back({sheet_nodes(model, [](const auto& X) { return X.x < 1e-9; }), all_axes});
  model.gravity.push_back({});
  model.gravity.back().acceleration = {0, 0, -9.81};
  model.time = relaxed(1e-6, 1e-7);
  validate(model);
  auto simulation = simulate(model, GetParam());
  while (!simulation->finished()) simulation->step(50);
  const Snapshot state = Snapshot::of(*simulation);
  double sum = 0;
  for (const double e : state.shells.energy) sum += e;
  const double strain = simulation->energies().strain;
  ASSERT_GT(strain, 0);
  EXPECT_NEAR(sum, strain, 1e-5 * strain);
}
GLISSON_ALL_CASES(ShellFieldsOfRuns);

TEST(ShellOutputs, MidSurfaceLeavesOutNodesOfSolids) {
  Model model = flat_sheet(membrane_section("NeoHookean", {1000}, 0.001));
  model.mesh.X.insert(model.mesh.X.begin(), {9, 9, 9});
  for (auto& t : model.mesh.triangles)
    for (int& n : t) ++n;
  const auto state = state_of(model, [](const auto& X) { return Vec3<double>{0, 0, X.x}; });
  const ShellSheet mid = mid_surface(model.mesh, state);
  ASSERT_EQ(mid.surface.X.size(), 20u);
  for (std::size_t p = 0; p < 20; ++p) EXPECT_EQ(mid.displacement[p].z, mid.surface.X[p].x);
  std::ostringstream out;
  write_vtp(out, mid.surface, mid.fields());
  EXPECT_NE(out.str().find("Name=\"thickness\""), std::string::npos);
  EXPECT_NE(out.str().find("NumberOfPolys=\"24\""), std::string::npos);
}

TEST(ShellOutputs, NoFileHoldsWhatIsNotFinite) {
  const Model model = flat_sheet(membrane_section("NeoHookean", {1000}, 0.001));
  auto state = state_of(model, [](const auto&) { return Vec3<double>{}; });
  state.shells.thickness[7] = std::nan("");
  const ShellSheet mid = mid_surface(model.mesh, state);
  std::ostringstream out;
  try {
    write_vtp(out, mid.surface, mid.fields());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("thickness"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("triangle 7"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(out.str().empty());
}

}  // namespace
}  // namespace glisson::test
