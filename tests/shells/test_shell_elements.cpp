// Elements and laws by themselves: forces are the derivative of the energy, rigid motion gives none, constant
// strain is exact on any mesh.
#include <gtest/gtest.h>

#include <random>

#include <Eigen/Dense>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/triangles.hpp>

#include <tests/shells/sheets.hpp>
#include <tests/shells/statics.hpp>

namespace glisson::test {
namespace {

using shells::Plane;

struct LawCase {
  const char* name;
  std::vector<double> parameters;
};
const LawCase laws[] = {{"Linear", {1000, 0.3}},
                        {"NeoHookean", {400}},
                        {"NeoHookeanCompressible", {400, 900}},
                        {"Fung", {300, 2.5}},
                        {"TwoFibre", {200, 500, 1.5, 35}}};

template <class Body>
void with_law(const LawCase& c, Body&& body) {
  for_each_type(shells::MembraneLaws<Real>{}, [&]<class L>() {
    if (std::string(c.name) != L::name) return;
    std::vector<Real> p;
    for (const double x : c.parameters) p.emplace_back(x);
    body(L::load(p.data()));
  });
}

/// dW/dc_xx is S_xx / 2; both off-diagonal components move together, so that dW/dc_xy is S_xy.
TEST(ShellLaws, StressIsTheDerivativeOfTheEnergy) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-0.4, 1.5), shear(-0.3, 0.3);
  for (const LawCase& c : laws)
    with_law(c, [&](const auto& law) {
      for (int i = 0; i < 50; ++i) {
        const double x = value(random), y = value(random), xy = shear(random);
        const auto S = law.second_pk(Plane<Real>{Real(x), Real(y), Real(xy)});
        const double stress[3] = {0.5 * S.xx.value, 0.5 * S.yy.value, S.xy.value};
        for (int k = 0; k < 3; ++k) {
          const auto W = law.energy(Plane<Real>{Real(x, k == 0), Real(y, k == 1), Real(xy, k == 2)});
          EXPECT_NEAR(W.derivative, stress[k], 1e-7 * (1 + std::abs(stress[k])))
              << c.name << " component " << k;
        }
      }
    });
}

/// Energies are of second order in the strain: nothing near 1 may be subtracted on the way, or a body at rest
/// has an energy that the balance of a run cannot explain.
TEST(ShellLaws, EnergiesOfSmallStrainsKeepTheirDigitsInFloat) {
  for (const LawCase& law : laws)
    for (const double size : {0.3, 1e-2, 1e-4, 1e-6, 1e-8})
      for (const Plane<float> c : {Plane<float>{float(size), float(-0.4 * size), float(0.2 * size)},
                                   Plane<float>{float(-0.6 * size), float(0.5 * size), float(0.1 * size)}}) {
        const auto energy = [&]<class R>(R) {
          R W{};
          for_each_type(shells::MembraneLaws<R>{}, [&]<class L>() {
            if (std::string(law.name) != L::name) return;
            std::vector<R> p(law.parameters.begin(), law.parameters.end());
            W = L::load(p.data()).energy(Plane<R>{R(c.xx), R(c.yy), R(c.xy)});
          });
          return double(W);
        };
        const double exact = energy(0.0), single = energy(0.0F);
        EXPECT_NEAR(single, exact, 1e-5 * exact) << law.name << " strain " << size;
      }
}

TEST(ShellLaws, ATensionFieldHasNoCompressionAndTheStressOfItsEnergy) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> value(-0.5, 1.2), shear(-0.3, 0.3);
  for (const LawCase& c : laws) {
    if (std::string(c.name) == "TwoFibre") continue;
    with_law(c, [&](const auto& law) {
      for (int i = 0; i < 50; ++i) {
        const double x = value(random), y = value(random), xy = shear(random);
        const auto S = shells::tension_field_stress(law, Plane<Real>{Real(x), Real(y), Real(xy)});
        const double stress[3] = {0.5 * S.xx.value, 0.5 * S.yy.value, S.xy.value};
        const double mean = 0.5 * (S.xx.value + S.yy.value), half = 0.5 * (S.xx.value - S.yy.value);
        EXPECT_GT(mean - std::sqrt(half * half + S.xy.value * S.xy.value), -1e-6) << c.name;
        for (int k = 0; k < 3; ++k) {
          const auto W = law.energy(
              shells::tension_field(law, Plane<Real>{Real(x, k == 0), Real(y, k == 1), Real(xy, k == 2)}).c);
          EXPECT_NEAR(W.derivative, stress[k], 1e-6 * (1 + std::abs(stress[k])))
              << c.name << " component " << k;
        }
      }
    });
  }
}

/// The plane stress law against the solid's energy, minimised over the thickness by a search.
TEST(ShellLaws, CompressibleNeoHookeanHasTheThicknessOfLeastEnergy) {
  const double mu = 400, kappa = 900;
  const double parameters[] = {mu, kappa};
  const auto law = shells::NeoHookeanCompressible<double>::load(parameters);
  for (const Plane<double> c : {Plane<double>{0.5, -0.2, 0.1}, {-0.3, -0.4, 0}, {2, 3, 0.5}, {1e-6, 0, 0}}) {
    const double D = 1 + shells::area_change(c);
    const auto W = [&](double q) {
      const double J = std::sqrt(D * q);
      return 0.5 * mu * (std::pow(J, -2.0 / 3) * (2 + c.xx + c.yy + q) - 3) + 0.5 * kappa * (J - 1) * (J - 1);
    };
    const double q = 1 + law.thickness_change(c), e = 1e-4 * q;
    EXPECT_NEAR((W(q + e) - W(q - e)) / (2 * e), 0, 1e-5 * mu) << c.xx;
    EXPECT_NEAR(law.energy(c), W(q), 1e-9 * mu);
  }
}

Model bent_sheet(ShellSection section, double fold) {
  return sheet(
      3, 3,
      [fold](double s, double t) {
        const double bump = 0.03 * std::sin(7 * s + 3 * t);
        return s <= 0.5 ? Vec3<double>{s + 0.05 * t, t + 0.04 * bump, bump}
                        : Vec3<double>{0.5 + (s - 0.5) * std::cos(fold) + 0.05 * t, t + 0.04 * bump,
                                       bump + (s - 0.5) * std::sin(fold)};
      },
      std::move(section));
}

std::vector<Vec3<double>> forces(const Model& model, const std::vector<Vec3<double>>& u) {
  std::vector<MatrixEntry> K;
  std::vector<Vec3<double>> f;
  ShellStatics statics(model, FixedDirections(u.size()));
  statics.u() = u;
  statics.evaluate(f, K);
  return f;
}

TEST(ShellElements, RigidMotionOfFlatCurvedAndFoldedSheetsGivesNoForce) {
  for (const double fold : {0.0, 0.6, 1.5})
    for (const bool bends : {false, true}) {
      const Model model = bent_sheet(
          bends ? shell_section(1e6, 0.3, 0.02) : membrane_section("NeoHookean", {1e5}, 0.02), fold);
      validate(model);
      std::vector<Vec3<double>> u;
      const double c = std::cos(2.1), s = std::sin(2.1);
      for (const auto& X : model.mesh.X) {
        const Vec3<double> x{c * X.x - s * X.z + 3, X.y - 2, s * X.x + c * X.z + 1};
        const Vec3<double> y{x.x, c * x.y - s * x.z, s * x.y + c * x.z};
        u.push_back(y - X);
      }
      for (const auto& f : forces(model, u)) EXPECT_LT(std::sqrt(dot(f, f)), 1e-8) << fold << bends;
    }
}

TEST(ShellElements, TheTangentIsSymmetricSoThatForcesHaveAnEnergy) {
  Model model = bent_sheet(shell_section(1e6, 0.3, 0.02), 0.7);
  model.clamped_nodes = sheet_nodes(model, [](const auto& X) { return X.x < 0.06; });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-0.05, 0.05);
  ShellStatics statics(model, FixedDirections(model.mesh.X.size()));
  for (auto& x : statics.u()) x = {value(random), value(random), value(random)};
  std::vector<MatrixEntry> K;
  std::vector<Vec3<double>> f;
  statics.evaluate(f, K);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(Eigen::Index(statics.dofs()), Eigen::Index(statics.dofs()));
  for (const auto& t : K) dense(t.row, t.col) += t.value;
  EXPECT_LT((dense - dense.transpose()).norm(), 1e-11 * dense.norm());
}

/// Constant strain: no force on inner nodes, whatever the mesh.
TEST(ShellElements, ConstantStrainAndConstantCurvatureLeaveInnerNodesAtRest) {
  for (const bool bends : {false, true}) {
    Model model = sheet(
        4, 4,
        [](double s, double t) {
          return Vec3<double>{s + 0.05 * std::sin(9 * t * s), t + 0.04 * std::sin(8 * s + t), 0};
        },
        bends ? shell_section(1e6, 0.3, 0.02) : membrane_section("NeoHookean", {1e5}, 0.02));
    std::vector<Vec3<double>> u;
    for (const auto& X : model.mesh.X)
      u.push_back({0.1 * X.x + 0.05 * X.y, -0.03 * X.y + 0.02 * X.x, 0.04 * X.x});
    const auto f = forces(model, u);
    const auto inner = [](int n) { return n % 5 > 0 && n % 5 < 4 && n / 5 > 0 && n / 5 < 4; };
    for (int n = 0; n < 25; ++n)
      EXPECT_LT(inner(n) ? std::sqrt(dot(f[std::size_t(n)], f[std::size_t(n)])) : 0.0, 1e-7) << n;
  }
}

TEST(ShellValidation, BadTrianglesAreRefusedWithAReason) {
  const Model good = sheet(
      2, 2,
      [](double s, double t) {
        return Vec3<double>{s, t, 0};
      },
      shell_section(1, 0.3, 0.1));
  const auto refused = [&](const std::function<void(Model&)>& spoil, const std::string& word) {
    Model model = good;
    spoil(model);
    try {
      validate(model);
      ADD_FAILURE() << "accepted: " << word;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  EXPECT_NO_THROW(validate(good));
  refused([](Model& m) { m.mesh.triangles[0] = {0, 1, 2}; }, "lie on a line");
  refused([](Model& m) { m.mesh.triangles[0] = {0, 1, 99}; }, "uses node 99");
  refused([](Model& m) { m.mesh.triangles[1] = m.mesh.triangles[0]; }, "same nodes");
  refused([](Model& m) { std::swap(m.mesh.triangles[0][0], m.mesh.triangles[0][1]); }, "orientations");
  refused([](Model& m) { m.shells[0].thickness = 0; }, "thickness");
  refused([](Model& m) { m.shells[0].density = -1; }, "density");
  refused([](Model& m) { m.shells[0].parameters = {1}; }, "parameters");
  refused([](Model& m) { m.shells[0].parameters = {1, 0.5}; }, "nu");
  refused([](Model& m) { m.shells[0].law = "NH"; }, "no law");
  refused([](Model& m) { m.shells[0].law = "Fung", m.shells[0].parameters = {1, 1}; }, "membrane part");
  refused([](Model& m) { m.shells[0].wrinkling = true; }, "wrinkling");
  refused([](Model& m) { m.shells[0].elements.pop_back(); }, "in no ShellElementSet");
  refused([](Model& m) { m.shells[0].elements.push_back(0); }, "two sets");
  refused([](Model& m) { m.shells[0].prony = {{1.2, 1}}; }, "sum");
  refused([](Model& m) { m.clamped_nodes = {77}; }, "names node 77");
  refused(
      [](Model& m) {
        m.mesh.X.push_back({0.3, 0.3, 1});
        m.mesh.triangles.push_back({0, 4, 9});
        m.shells[0].elements.push_back(8);
      },
      "more than two triangles");
  EXPECT_EQ(
      [&] {
        auto t = good.mesh.triangles;
        std::swap(t[3][0], t[3][1]);
        return orient(t);
      }(),
      1);
}

}  // namespace
}  // namespace glisson::test
