// Strips of every membrane law in uniaxial and biaxial tension against closed forms: stress, force and
// thickness are exact on any mesh and for any thickness.
#include <gtest/gtest.h>

#include <glisson/shells/shell_fields.hpp>
#include <tests/shells/sheets.hpp>
#include <tests/shells/statics.hpp>
#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

constexpr double length = 0.2, width = 0.1;

/// The root of a function that changes its sign once between a and b.
double root(const std::function<double(double)>& f, double a, double b) {
  const bool rises = f(b) > 0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (a + b);
    ((f(middle) > 0) == rises ? b : a) = middle;
  }
  return 0.5 * (a + b);
}

/// A state of plane stress: stretches along x, y and z, second Piola-Kirchhoff stress along x and y [Pa].
struct Exact {
  double x, y, z, Sxx, Syy;
};

struct Strip {
  const char* law;
  std::vector<double> parameters;
  Exact (*uniaxial)(double stretch);
  Exact (*biaxial)(double x, double y);
};

constexpr double E = 1000, nu = 0.3, mu = 400, kappa = 900, b = 2.5, k1 = 500, k2 = 1.5, angle = 35;

Exact linear(double x, double y) {
  const double exx = 0.5 * (x * x - 1), eyy = 0.5 * (y * y - 1), k = E / (1 - nu * nu);
  return {x, y, std::sqrt(1 - 2 * nu / (1 - nu) * (exx + eyy)), k * (exx + nu * eyy), k * (eyy + nu * exx)};
}
/// E_yy = -nu E_xx, S_xx = E E_xx.
Exact linear_strip(double x) {
  const double exx = 0.5 * (x * x - 1);
  return {x, std::sqrt(1 - 2 * nu * exx), std::sqrt(1 - 2 * nu * exx), E * exx, 0};
}

/// S_ii = f (1 - z^2 / l_i^2), z = 1 / (x y): neo-Hookean for f = mu, exponential with its factor.
Exact incompressible(double x, double y, double factor) {
  const double z = 1 / (x * y);
  return {x, y, z, factor * (1 - z * z / (x * x)), factor * (1 - z * z / (y * y))};
}
double exponential(double x, double y) {
  return mu * std::exp(b * (x * x + y * y + 1 / (x * x * y * y) - 3));
}
double narrow(double x) { return 1 / std::sqrt(x); }

/// Cauchy stress of the solid's law, s_i = mu J^(-5/3) (l_i^2 - I1/3) + kappa (J - 1); S_i = J s_i / l_i^2.
Exact compressible(double x, double y) {
  const auto stress = [=](double z, double l) {
    const double J = x * y * z, I1 = x * x + y * y + z * z;
    return mu * std::pow(J, -5.0 / 3) * (l * l - I1 / 3) + kappa * (J - 1);
  };
  const double z = root([&](double q) { return stress(q, q); }, 0.05, 3), J = x * y * z;
  return {x, y, z, J * stress(z, x) / (x * x), J * stress(z, y) / (y * y)};
}
/// Width and thickness are alike: 3 kappa (J - 1) = mu J^(-5/3) (x^2 - J / x).
Exact compressible_strip(double x) {
  const double J = root(
      [=](double j) { return 3 * kappa * (j - 1) - mu * std::pow(j, -5.0 / 3) * (x * x - j / x); }, 0.2, 5);
  const double y = std::sqrt(J / x);
  return {x, y, y, J * 3 * kappa * (J - 1) / (x * x), 0};
}

/// Two families at +-angle: what they add is 4 k1 (I4 - 1) exp(k2 (I4 - 1)^2) times cos^2 along, sin^2
/// across.
Exact two_fibre(double x, double y) {
  const double c = std::cos(angle * pi / 180), s = std::sin(angle * pi / 180);
  const double e = std::max(c * c * x * x + s * s * y * y - 1, 0.0);
  Exact exact = incompressible(x, y, mu);
  exact.Sxx += 4 * k1 * e * std::exp(k2 * e * e) * c * c;
  exact.Syy += 4 * k1 * e * std::exp(k2 * e * e) * s * s;
  return exact;
}
Exact two_fibre_strip(double x) {
  return two_fibre(x, root([=](double y) { return two_fibre(x, y).Syy; }, 0.3, 1.5));
}

const Strip strips[] = {{"Linear", {E, nu}, linear_strip, linear},
                        {"NeoHookean",
                         {mu},
                         [](double x) { return incompressible(x, narrow(x), mu); },
                         [](double x, double y) { return incompressible(x, y, mu); }},
                        {"NeoHookeanCompressible", {mu, kappa}, compressible_strip, compressible},
                        {"Fung",
                         {mu, b},
                         [](double x) { return incompressible(x, narrow(x), exponential(x, narrow(x))); },
                         [](double x, double y) { return incompressible(x, y, exponential(x, y)); }},
                        {"TwoFibre", {mu, k1, k2, angle}, two_fibre_strip, two_fibre}};

void PrintTo(const Strip& s, std::ostream* out) { *out << s.law; }

/// An irregular mesh of 2n x n fields.
Model strip(int n, const Strip& law, double h) {
  Model model = sheet(
      2 * n, n,
      [](double s, double t) {
        const double bubble = s * (1 - s) * t * (1 - t);
        return Vec3<double>{length * (s + 0.5 * bubble * std::sin(9 * t)),
                            width * (t - bubble * std::cos(7 * s)), 0};
      },
      membrane_section(law.law, law.parameters, h));
  model.shells[0].direction = {1, 0, 0};
  return model;
}

std::vector<int> at_x(const Model& model, double x) {
  return sheet_nodes(model, [=](const auto& X) { return std::abs(X.x - x) < 1e-12; });
}
std::vector<int> at_y(const Model& model, double y) {
  return sheet_nodes(model, [=](const auto& X) { return std::abs(X.y - y) < 1e-12; });
}

/// Ends prescribed along x, free to narrow from the symmetry line y = 0; in the plane. With y, the upper side
/// is prescribed too.
FixedDirections grips(const Model& model, bool biaxial) {
  FixedDirections fixed(model.mesh.X.size());
  fix(fixed, sheet_nodes(model, [](const auto&) { return true; }), "z");
  fix(fixed, at_x(model, 0), "x");
  fix(fixed, at_x(model, length), "x");
  fix(fixed, at_y(model, 0), "y");
  if (biaxial) fix(fixed, at_y(model, width), "y");
  return fixed;
}

void expect_state(const Model& model, const std::vector<Vec3<double>>& u, const Exact& exact, double h,
                  double tolerance) {
  const ShellFields f = shells::shell_fields(model, u, {}, 0);
  const double size = std::abs(exact.Sxx) + std::abs(exact.Syy);
  for (std::size_t t = 0; t < f.size(); ++t) {
    ASSERT_NEAR(f.stress[t].xx, exact.Sxx, tolerance * size);
    ASSERT_NEAR(f.stress[t].yy, exact.Syy, tolerance * size);
    ASSERT_NEAR(f.stress[t].xy, 0, tolerance * size);
    ASSERT_NEAR(f.membrane_force[t].xx, h * exact.Sxx, h * tolerance * size);
    ASSERT_NEAR(f.thickness[t], h * exact.z, tolerance * h);
  }
}

double sum(const std::vector<Vec3<double>>& f, const std::vector<int>& nodes, double Vec3<double>::*axis) {
  double total = 0;
  for (const int n : nodes) total += f[static_cast<std::size_t>(n)].*axis;
  return total;
}

class MembraneStrips : public testing::TestWithParam<Strip> {
 protected:
  /// Equilibrium from a start that is wrong inside; stress everywhere and the forces on the grips.
  void expect_exact(const Exact& exact, bool biaxial) const {
    for (const double h : {1e-3, 1e-5})
      for (const int n : {1, 2, 5}) {
        SCOPED_TRACE(testing::Message() << "h " << h << ", n " << n << ", stretch " << exact.x);
        const Model model = strip(n, GetParam(), h);
        validate(model);
        ShellStatics statics(model, grips(model, biaxial));
        for (std::size_t k = 0; k < statics.u().size(); ++k) {
          const auto& X = model.mesh.X[k];
          const double away = X.x * (length - X.x) * X.y * (width - X.y) / (length * width);
          statics.u()[k] = {(exact.x - 1) * X.x + away, (biaxial ? exact.y - 1 : -0.03) * X.y - away, 0};
        }
        const std::vector<Vec3<double>> none(model.mesh.X.size());
        ASSERT_TRUE((n == 1 && biaxial) || statics.solve(none, 1e-12));  // there all nodes are held
        expect_state(model, statics.u(), exact, h, 1e-9);
        std::vector<Vec3<double>> f;
        std::vector<MatrixEntry> K;
        statics.evaluate(f, K);
        const double pull = exact.x * exact.Sxx * width * h;
        EXPECT_NEAR(-sum(f, at_x(model, length), &Vec3<double>::x), pull, 1e-9 * std::abs(pull));
        if (!biaxial) continue;
        const double side = exact.y * exact.Syy * length * h;
        EXPECT_NEAR(-sum(f, at_y(model, width), &Vec3<double>::y), side, 1e-9 * std::abs(side));
      }
  }
};

TEST_P(MembraneStrips, UniaxialTensionIsExact) {
  for (const double stretch : {1.02, 1.25, 1.5}) expect_exact(GetParam().uniaxial(stretch), false);
}

TEST_P(MembraneStrips, BiaxialTensionIsExact) {
  expect_exact(GetParam().biaxial(1.2, 1.2), true);
  expect_exact(GetParam().biaxial(1.3, 1.05), true);
  expect_exact(GetParam().biaxial(0.95, 1.15), true);
}

INSTANTIATE_TEST_SUITE_P(Laws, MembraneStrips, testing::ValuesIn(strips),
                         [](const auto& test) { return std::string(test.param.law); });

/// A strip pushed together to half its width carries the stress of the one that narrows freely.
TEST(MembraneWrinkles, AcrossAStripLeaveItsUniaxialStress) {
  for (const Strip& s : strips) {
    if (std::string(s.law) == "TwoFibre") continue;
    SCOPED_TRACE(s.law);
    Model model = strip(2, s, 1e-3);
    model.shells[0].wrinkling = true;
    validate(model);
    const Exact exact = s.uniaxial(1.25);
    std::vector<Vec3<double>> u;
    for (const auto& X : model.mesh.X) u.push_back({0.25 * X.x, -0.5 * X.y, 0});
    const ShellFields f = shells::shell_fields(model, u, {}, 0);
    for (std::size_t t = 0; t < f.size(); ++t) {
      EXPECT_NEAR(f.stress[t].xx, exact.Sxx, 1e-9 * exact.Sxx);
      EXPECT_NEAR(f.stress[t].yy, 0, 1e-9 * exact.Sxx);
    }
  }
}

class MembraneStripRuns : public Matrix {};

/// The same through the engine: relaxation, the force on the grip, every law on every backend.
TEST_P(MembraneStripRuns, EveryLawPullsAsItsClosedFormSays) {
  const double h = 1e-3;
  for (const Strip& s : strips) {
    SCOPED_TRACE(s.law);
    const Exact exact = s.uniaxial(1.25);
    Model model = strip(2, s, h);
    model.fixed.push_back({sheet_nodes(model, [](const auto&) { return true; }), 4});
    model.fixed.push_back({at_x(model, 0), 1});
    model.fixed.push_back({at_y(model, 0), 2});
    model.displacements.push_back({at_x(model, length), 1, {0.25 * length}, smooth_curve(1)});
    model.time = relaxed(1e-5, 1e-6);
    validate(model);
    auto simulation = simulate(model, GetParam());
    while (!simulation->finished()) simulation->step(50);
    ASSERT_EQ(simulation->report().ending, "converged");
    expect_state(model, simulation->displacement(), exact, h, 3e-4);
    const double pull = exact.x * exact.Sxx * width * h;
    EXPECT_NEAR(-sum(simulation->internal_force(), at_x(model, length), &Vec3<double>::x), pull, 1e-4 * pull);
    EXPECT_NEAR(simulation->displacement().back().y, width * (exact.y - 1), 1e-4 * width);
  }
}
GLISSON_ALL_CASES(MembraneStripRuns);

}  // namespace
}  // namespace glisson::test
