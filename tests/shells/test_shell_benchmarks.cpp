// Rotation-free shells against published and closed solutions; the tables in doc/shells.md come from here.
#include <gtest/gtest.h>

#include <ostream>

#include <tests/shells/sheets.hpp>
#include <tests/shells/statics.hpp>

namespace glisson::test {
namespace {

using Loads = std::vector<Vec3<double>>;

/// Linear solution for a load, from rest.
std::vector<Vec3<double>> linear(const Model& model, const FixedDirections& fixed, const Loads& load) {
  validate(model);
  ShellStatics statics(model, fixed);
  statics.newton_step(load);
  return statics.u();
}

void plane(Model& model, FixedDirections& fixed, Vec3<double> normal,
           const std::function<bool(const Vec3<double>&)>& keep) {
  const auto nodes = sheet_nodes(model, keep);
  model.planes.push_back({nodes, normal});
  fix(fixed, nodes, normal.x != 0 ? "x" : normal.y != 0 ? "y" : "z");
}

bool near(double a, double b) { return std::abs(a - b) < 1e-9; }

Loads area_load(const Model& model, Vec3<double> per_area) {
  Loads load(model.mesh.X.size());
  for (const auto& t : model.mesh.triangles) {
    const auto at = [&](int a) {
      return model.mesh.X[static_cast<std::size_t>(t[static_cast<std::size_t>(a)])];
    };
    const auto N = cross(at(1) - at(0), at(2) - at(0));
    for (const int n : t)
      load[static_cast<std::size_t>(n)] =
          load[static_cast<std::size_t>(n)] + (std::sqrt(dot(N, N)) / 6) * per_area;
  }
  return load;
}

/// Record a row of the convergence table; --gtest_output shows it.
void note(int n, double value, double reference) {
  testing::Test::RecordProperty("n" + std::to_string(n), std::to_string(value / reference));
  printf("    %3d x %-3d %12.6g  %8.4f\n", n, n, value, value / reference);
}

/// MacNeal & Harder 1985: R 25, L 50, t 0.25, 80 degrees, E 4.32e8, nu 0, weight 90 per area; a quarter.
double scordelis_lo(int n) {
  Model model = sheet(
      n, n,
      [](double s, double t) {
        const double a = s * 40 * pi / 180;
        return Vec3<double>{25 * std::sin(a), 25 * t, 25 * std::cos(a)};
      },
      shell_section(4.32e8, 0, 0.25));
  FixedDirections fixed(model.mesh.X.size());
  fix(fixed, sheet_nodes(model, [](const auto& X) { return near(X.y, 25); }), "xz");
  plane(model, fixed, {1, 0, 0}, [](const auto& X) { return near(X.x, 0); });
  plane(model, fixed, {0, 1, 0}, [](const auto& X) { return near(X.y, 0); });
  return -linear(model, fixed, area_load(model, {0, 0, -90}))[static_cast<std::size_t>(n)].z;
}

/// Belytschko et al. 1985: R 300, L 600, t 3, E 3e6, nu 0.3, unit forces; an eighth.
double pinched_cylinder(int n) {
  Model model = sheet(
      n, n,
      [](double s, double t) {
        const double a = s * pi / 2;
        return Vec3<double>{300 * std::sin(a), 300 * t, 300 * std::cos(a)};
      },
      shell_section(3e6, 0.3, 3));
  FixedDirections fixed(model.mesh.X.size());
  fix(fixed, sheet_nodes(model, [](const auto& X) { return near(X.y, 300); }), "xz");
  plane(model, fixed, {1, 0, 0}, [](const auto& X) { return near(X.x, 0); });
  plane(model, fixed, {0, 0, 1}, [](const auto& X) { return near(X.z, 0); });
  plane(model, fixed, {0, 1, 0}, [](const auto& X) { return near(X.y, 0); });
  Loads load(model.mesh.X.size());
  load[0] = {0, 0, -0.25};
  return -linear(model, fixed, load)[0].z;
}

/// MacNeal & Harder 1985: R 10, t 0.04, hole of 18 degrees, E 6.825e7, nu 0.3, forces of 2; a quarter.
double pinched_hemisphere(int n) {
  Model model = sheet(
      n, n,
      [](double s, double t) {
        const double a = s * pi / 2, b = t * 72 * pi / 180;
        return Vec3<double>{10 * std::cos(a) * std::cos(b), 10 * std::sin(a) * std::cos(b), 10 * std::sin(b)};
      },
      shell_section(6.825e7, 0.3, 0.04));
  FixedDirections fixed(model.mesh.X.size());
  plane(model, fixed, {1, 0, 0}, [](const auto& X) { return near(X.x, 0); });
  plane(model, fixed, {0, 1, 0}, [](const auto& X) { return near(X.y, 0); });
  fix(fixed, {0}, "z");
  Loads load(model.mesh.X.size());
  load[0] = {1, 0, 0}, load[static_cast<std::size_t>(n)] = {0, -1, 0};
  return linear(model, fixed, load)[0].x;
}

/// MacNeal & Harder 1985: length 12, width 1.1, t 0.32, twist 90 degrees, E 2.9e7, nu 0.22, unit tip force.
double twisted_beam(int n, bool out_of_plane) {
  Model model = sheet(
      12 * n, 2 * n,
      [](double s, double t) {
        const double a = s * pi / 2, y = 1.1 * (t - 0.5);
        return Vec3<double>{12 * s, y * std::cos(a), y * std::sin(a)};
      },
      shell_section(2.9e7, 0.22, 0.32));
  FixedDirections fixed(model.mesh.X.size());
  const auto root = sheet_nodes(model, [](const auto& X) { return near(X.x, 0); });
  fix(fixed, root, "xyz");
  model.clamped_nodes = root;
  const auto tip = sheet_nodes(model, [](const auto& X) { return near(X.x, 12); });
  Loads load(model.mesh.X.size());
  for (std::size_t k = 0; k < tip.size(); ++k) {
    const double share = (k == 0 || k + 1 == tip.size() ? 0.5 : 1.0) / (2 * n);
    load[static_cast<std::size_t>(tip[k])] =
        out_of_plane ? Vec3<double>{0, share, 0} : Vec3<double>{0, 0, share};
  }
  const auto u = linear(model, fixed, load)[static_cast<std::size_t>(tip[static_cast<std::size_t>(n)])];
  return out_of_plane ? u.y : u.z;
}

/// Timoshenko: clamped square plate, w = 0.00126532 q a^4 / D at nu 0.3; a quarter.
double clamped_plate(int n) {
  Model model = sheet(
      n, n,
      [](double s, double t) {
        return Vec3<double>{0.5 * s, 0.5 * t, 0};
      },
      shell_section(1e6, 0.3, 0.01));
  FixedDirections fixed(model.mesh.X.size());
  const auto border = sheet_nodes(model, [](const auto& X) { return near(X.x, 0.5) || near(X.y, 0.5); });
  fix(fixed, border, "xyz");
  model.clamped_nodes = border;
  plane(model, fixed, {1, 0, 0}, [](const auto& X) { return near(X.x, 0); });
  plane(model, fixed, {0, 1, 0}, [](const auto& X) { return near(X.y, 0); });
  const double D = 1e6 * 1e-6 / (12 * (1 - 0.09));
  return linear(model, fixed, area_load(model, {0, 0, 1}))[0].z * D;
}

struct Benchmark {
  const char* name;
  double (*value)(int);
  double reference;
  std::vector<int> meshes;
};

void PrintTo(const Benchmark& b, std::ostream* out) { *out << b.name; }

class ShellBenchmarks : public testing::TestWithParam<Benchmark> {};

TEST_P(ShellBenchmarks, TheFinestMeshIsWithinTwoPercentOfThePublishedValue) {
  const Benchmark& b = GetParam();
  double last = 0;
  for (const int n : b.meshes) {
    last = b.value(n);
    note(n, last, b.reference);
  }
  EXPECT_NEAR(last / b.reference, 1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    All, ShellBenchmarks,
    testing::Values(
        Benchmark{"ScordelisLo", scordelis_lo, 0.3024, {8, 16, 32, 64}},
        Benchmark{"PinchedCylinder", pinched_cylinder, 1.8248e-5, {16, 32, 64, 96}},
        Benchmark{"PinchedHemisphere", pinched_hemisphere, 0.0940, {16, 32, 64, 96}},
        Benchmark{"TwistedBeamOutOfPlane", [](int n) { return twisted_beam(n, true); }, 1.754e-3, {1, 2, 4}},
        Benchmark{"TwistedBeamInPlane", [](int n) { return twisted_beam(n, false); }, 5.424e-3, {1, 2, 4}},
        Benchmark{"ClampedPlate", clamped_plate, 0.00126532, {4, 8, 16}}),
    [](const auto& test) { return test.param.name; });

/// Elastica (closed form) at P L^2 / (E I) = 1, 2, 5, 10, a strip of nu = 0: the largest error of the tip's
/// displacements over their exact values.
double elastica_error(int n) {
  const double E = 1e6, h = 0.01, L = 1, width = 0.1, I = width * h * h * h / 12;
  Model model = sheet(
      n, 2,
      [&](double s, double t) {
        return Vec3<double>{L * s, width * t, 0};
      },
      shell_section(E, 0, h));
  const auto root = sheet_nodes(model, [](const auto& X) { return near(X.x, 0); });
  FixedDirections fixed(model.mesh.X.size());
  fix(fixed, root, "xyz");
  model.clamped_nodes = root;
  validate(model);
  ShellStatics statics(model, fixed);
  const auto tip = sheet_nodes(model, [](const auto& X) { return near(X.x, 1); });
  const double exact[4][3] = {
      {1, 0.05643, 0.30172}, {2, 0.16064, 0.49346}, {5, 0.38763, 0.71379}, {10, 0.55500, 0.81061}};
  double before = 0, worst = 0;
  for (const auto& row : exact) {
    for (int part = 1; part <= 8; ++part) {
      const double P = (before + (row[0] - before) * part / 8) * E * I / (L * L);
      Loads load(model.mesh.X.size());
      for (std::size_t k = 0; k < 3; ++k)
        load[static_cast<std::size_t>(tip[k])] = {0, 0, P * (k == 1 ? 0.5 : 0.25)};
      EXPECT_TRUE(statics.solve(load, 1e-6)) << "P L^2 / (E I) = " << row[0] << ", part " << part;
    }
    before = row[0];
    const auto u = statics.u()[static_cast<std::size_t>(tip[1])];
    printf("    %3d  PL2/EI %4.0f  axial %.4f  lateral %.4f\n", n, row[0], -u.x / L / row[1],
           u.z / L / row[2]);
    worst = std::max({worst, std::abs(-u.x / L / row[1] - 1), std::abs(u.z / L / row[2] - 1)});
  }
  return worst;
}

TEST(ShellRotation, AStripFollowsTheElastica) {
  EXPECT_LT(elastica_error(10), 0.05);
  EXPECT_LT(elastica_error(20), 0.02);
  EXPECT_LT(elastica_error(40), 0.005);
}

}  // namespace
}  // namespace glisson::test
