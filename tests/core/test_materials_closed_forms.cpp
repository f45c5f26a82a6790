// Constitutive laws against textbook formulas and closed forms: each exact solution drives the law and judges
// it.
#include <gtest/gtest.h>

#include <functional>

#include "tests/core/material_cases.hpp"

namespace glisson::test {
namespace {

/// W by the printed formula, straight from F, with the parameters of example_parameters. Good only at large
/// strain.
double textbook_energy(const std::string& law, const Matrix& F) {
  const std::vector<double> p = example_parameters(law);
  const Matrix C = transpose(F) * F;
  const double J = determinant(F), I1 = trace(C) * std::pow(J, -2.0 / 3);
  const double I2 = 0.5 * (trace(C) * trace(C) - trace(C * C)) * std::pow(J, -4.0 / 3);
  auto volume = [&](double kappa) { return kappa / 2 * (J - 1) * (J - 1); };
  if (law == "NH") return p[0] / 2 * (I1 - 3) + volume(p[1]);
  if (law == "LE") {
    const double lambda = p[0] * p[1] / ((1 + p[1]) * (1 - 2 * p[1])), mu = p[0] / (2 * (1 + p[1]));
    const Matrix E2 = minus_identity(C);
    return lambda / 8 * trace(E2) * trace(E2) + mu / 4 * trace(E2 * E2);
  }
  if (law == "AB") {
    const double c[] = {1.0 / 2, 1.0 / 20, 11.0 / 1050, 19.0 / 7000, 519.0 / 673750};
    double W = p[2] / 2 * ((J * J - 1) / 2 - std::log(J));
    for (int i = 1; i <= 5; ++i)
      W += p[0] * c[i - 1] / std::pow(p[1], 2 * i - 2) * (std::pow(I1, i) - std::pow(3, i));
    return W;
  }
  if (law == "PY") {
    const double i1 = I1 - 3, i2 = I2 - 3;
    return p[0] * i1 + p[1] * i2 + p[2] * i1 * i1 + p[3] * i2 * i2 + p[4] * i1 * i2 + volume(p[5]);
  }
  if (law == "TI") {
    const double a[] = {p[3], p[4], p[5]};
    double a_C_a = 0, a_a = 0;
    for (int i = 0; i < 3; ++i) {
      a_a += a[i] * a[i];
      for (int k = 0; k < 3; ++k) a_C_a += a[i] * C.m[i][k] * a[k];
    }
    const double i4 = a_C_a / a_a * std::pow(J, -2.0 / 3) - 1;
    return p[0] / 2 * (I1 - 3) + p[2] / 4 * i4 * i4 + volume(p[1]);
  }
  return NAN;
}

TEST(ClosedForms, EnergyIsTheTextbookFormula) {
  std::mt19937 random(7);
  for_each_type(AllLaws<double>{}, [&]<class L>() {
    const std::string name = L::name;
    if (name == "OG") return;  // judged by principal stretches below
    const L law = example<L, double>();
    for (int n = 0; n < 200; ++n) {
      const Matrix H = random_large_gradient(random);
      Matrix F = H;
      for (int i = 0; i < 3; ++i) F.m[i][i] += 1;
      const double W = textbook_energy(name, F);
      EXPECT_NEAR(law.energy(H), W, 1e-12 * (W + law.wave_modulus())) << name;
    }
  });
}

TEST(ClosedForms, OgdenEnergyOfKnownPrincipalStretches) {
  std::mt19937 random(11);
  const auto p = example_parameters("OG");
  const auto law = example<Ogden<double>, double>();
  std::uniform_real_distribution<double> stretch(0.5, 2);
  for (int n = 0; n < 200; ++n) {
    const double l[] = {stretch(random), stretch(random), n % 2 ? 1.25 : stretch(random)};
    const double equal = n % 4 == 3 ? 1.25 : l[1];  // also with equal stretches
    const double J = l[0] * equal * l[2];
    double W = p[6] / 2 * (J - 1) * (J - 1);
    for (int i = 0; i < 3; ++i)
      for (const double value : {l[0], equal, l[2]})
        W += p[2 * i] / p[2 * i + 1] * (std::pow(value / std::cbrt(J), p[2 * i + 1]) - 1);
    const Matrix F = random_rotation(random) * diagonal(l[0], equal, l[2]) * random_rotation(random);
    EXPECT_NEAR(law.energy(minus_identity(F)), W, 1e-12 * (W + law.wave_modulus()));
  }
}

constexpr double kappa =
    1e9;  ///< with moduli of order 1: J - 1 is of order 1e-9, the rounding of kappa (J - 1) 1e-7

/// Nominal stress P_11 at stretch l along x, the other two directions free (transverse isotropy: along the
/// fibres).
template <class L>
double uniaxial_nominal(const L& law, double l) {
  double low = 0.1, high = 10;
  for (int n = 0; n < 200; ++n) {
    const double middle = 0.5 * (low + high);
    const double P22 = law.first_pk(minus_identity(diagonal(l, middle, middle))).m[1][1];
    (P22 > 0 ? high : low) = middle;
  }
  return law.first_pk(minus_identity(diagonal(l, low, low))).m[0][0];
}

/// Nominal stress P_11 at stretch l along x and y, z free.
template <class L>
double equibiaxial_nominal(const L& law, double l) {
  double low = 0.01, high = 10;
  for (int n = 0; n < 200; ++n) {
    const double middle = 0.5 * (low + high);
    (law.first_pk(minus_identity(diagonal(l, l, middle))).m[2][2] > 0 ? high : low) = middle;
  }
  return law.first_pk(minus_identity(diagonal(l, l, low))).m[0][0];
}

const double stretches[] = {0.8, 1.2, 1.5, 2};
// The bisection ends within one unit in the last place of the lateral stretch, 1e-16, times kappa: 1e-7 per
// unit stretch.
constexpr double tolerance = 3e-6;

TEST(ClosedForms, UniaxialIncompressible) {
  const NeoHookean<double> nh{1, kappa};
  const double nominal[] = {-0.7625, 0.5056, 1.0556, 1.7500}, cauchy[] = {-0.6100, 0.6067, 1.5833, 3.5000};
  for (int n = 0; n < 4; ++n) {
    const double P = uniaxial_nominal(nh, stretches[n]);
    EXPECT_NEAR(P, nominal[n], 5e-5 + tolerance);
    EXPECT_NEAR(P * stretches[n], cauchy[n], 5e-5 + tolerance);
  }
  for (const double l : stretches) {
    const double neo_hooke = l - 1 / (l * l);
    EXPECT_NEAR(uniaxial_nominal(nh, l), neo_hooke, tolerance);
    EXPECT_NEAR(uniaxial_nominal(Polynomial<double>{0.3, 0.2, 0, 0, 0, kappa}, l),
                2 * neo_hooke * (0.3 + 0.2 / l),
                tolerance);  // Mooney-Rivlin
    const double I1 = l * l + 2 / l, x = I1 / (1.5 * 1.5);
    const double sum = 0.5 + x / 10 + 11 * x * x / 350 + 19 * x * x * x / 1750 + 519 * x * x * x * x / 134750;
    EXPECT_NEAR(uniaxial_nominal(ArrudaBoyce<double>{1, 1.5, kappa}, l), 2 * sum * neo_hooke, tolerance);
    const double fibres = 0.7 * l * (l * l - 1);
    EXPECT_NEAR(uniaxial_nominal(TransverselyIsotropic<double>{1, kappa, 0.7, {1, 0, 0}}, l),
                neo_hooke + fibres, tolerance);
    const double ogden =
        0.6 * (std::pow(l, 1.5) - std::pow(l, -2.25)) - 0.2 * (std::pow(l, -4) - std::pow(l, 0.5));
    EXPECT_NEAR(uniaxial_nominal(Ogden<double>{0.6, 2.5, -0.2, -3, 0, 0, kappa}, l), ogden, tolerance);
  }
}

TEST(ClosedForms, EquibiaxialIncompressible) {
  const double cauchy[] = {-1.8014, 0.9577, 2.0525, 3.9375};
  for (int n = 0; n < 4; ++n) {
    const double l = stretches[n], P = equibiaxial_nominal(NeoHookean<double>{1, kappa}, l);
    EXPECT_NEAR(P * l, cauchy[n], 5e-5 + tolerance);
    EXPECT_NEAR(P * l, l * l - std::pow(l, -4), tolerance);
    const double mooney = 2 * (l * l - std::pow(l, -4)) * (0.3 + 0.2 * l * l);
    EXPECT_NEAR(equibiaxial_nominal(Polynomial<double>{0.3, 0.2, 0, 0, 0, kappa}, l) * l, mooney,
                10 * tolerance);
  }
}

/// Cauchy stress of simple shear F = I + gamma e1 e2^T; J = 1 exactly, so kappa has no influence.
template <class L>
Matrix simple_shear(const L& law, double gamma) {
  Matrix F = identity();
  F.m[0][1] = gamma;
  return law.first_pk(minus_identity(F)) * transpose(F);
}

TEST(ClosedForms, SimpleShear) {
  for (const double gamma : {1e-3, 0.1, 0.5, 1.0, 2.0}) {
    const Matrix nh = simple_shear(NeoHookean<double>{3, 50}, gamma);
    EXPECT_NEAR(nh.m[0][1], 3 * gamma, 1e-13);
    EXPECT_NEAR(nh.m[0][0] - nh.m[1][1], 3 * gamma * gamma, 1e-13);
    const Matrix mr = simple_shear(Polynomial<double>{0.9, 0.6, 0, 0, 0, 50}, gamma);
    EXPECT_NEAR(mr.m[0][1], 3 * gamma, 1e-13);
    EXPECT_NEAR(mr.m[0][0] - mr.m[1][1], 3 * gamma * gamma, 1e-13);
    EXPECT_NEAR(mr.m[1][1] - mr.m[2][2], -1.2 * gamma * gamma, 1e-13);
  }
}

TEST(ClosedForms, StVenantKirchhoffBar) {
  const double E = 3000, nu = 0.3, parameters[] = {E, nu};
  const auto law = StVenantKirchhoff<double>::load(parameters);
  for (const double l : {0.8, 1.0 + 1e-6, 1.2, 1.5}) {
    const double side = std::sqrt(1 - nu * (l * l - 1));  // E_22 = -nu E_11
    const Matrix P = law.first_pk(minus_identity(diagonal(l, side, side)));
    EXPECT_NEAR(P.m[0][0], l * E * (l * l - 1) / 2, 1e-12 * E);
    EXPECT_NEAR(P.m[1][1], 0, 1e-12 * E);
  }
}

TEST(ClosedForms, PureVolumeChange) {
  for (const double J : {0.6, 0.9, 1 + 1e-7, 1.3, 2.5}) {
    const Matrix H = minus_identity(diagonal(std::cbrt(J), std::cbrt(J), std::cbrt(J)));
    const double j = determinant(diagonal(H.m[0][0] + 1, H.m[1][1] + 1, H.m[2][2] + 1)) - 1,
                 area = std::cbrt(J * J);
    for_each_type(AllLaws<double>{}, [&]<class L>() {
      const std::string name = L::name;
      const L law = example<L, double>();
      if (name == "LE") return;
      const double pressure = law.bulk_modulus() * (name == "AB" ? 0.5 * (J - 1 / J) : j);
      const Matrix P = law.first_pk(H);
      const double expected = pressure * area;
      EXPECT_LT(largest_difference(P, diagonal(expected, expected, expected)),
                1e-14 * 10 * law.wave_modulus())
          << name;
    });
  }
}

/// Both laws give the same stress and energy at any deformation, to the rounding of their moduli.
template <class A, class B>
void expect_same(const A& a, const B& b) {
  std::mt19937 random(5);
  for (int n = 0; n < 200; ++n) {
    const Matrix H = n % 2 ? random_large_gradient(random) : random_gradient(random, 1e-5), P = b.first_pk(H);
    const double size = (largest(P) + (n % 2 ? 1 : 1e-5) * b.wave_modulus());
    EXPECT_LT(largest_difference(a.first_pk(H), P), 1e-14 * 5 * size);
    EXPECT_NEAR(a.energy(H), b.energy(H), 1e-14 * 5 * (n % 2 ? size + b.energy(H) : b.energy(H)));
  }
}

TEST(ClosedForms, SpecialCasesAgree) {
  expect_same(Polynomial<double>{0.5, 0, 0, 0, 0, 50}, NeoHookean<double>{1, 50});
  expect_same(Ogden<double>{1, 2, 0, 0, 0, 0, 50}, NeoHookean<double>{1, 50});
  expect_same(Ogden<double>{0, 0, -1, -2, 0, 0, 50}, Polynomial<double>{0, 0.5, 0, 0, 0, 50});
  expect_same(Ogden<double>{0.6, 2, 0, 0, -0.4, -2, 50}, Polynomial<double>{0.3, 0.2, 0, 0, 0, 50});
  expect_same(TransverselyIsotropic<double>{1, 50, 0, {0, 1, 0}}, NeoHookean<double>{1, 50});
}

TEST(ClosedForms, FibreDirectionMayHaveAnyLengthButZero) {
  const double unit[] = {1, 50, 3, 0.6, 0, 0.8}, long_one[] = {1, 50, 3, -6, 0, -8},
               zero[] = {1, 50, 3, 0, 0, 0};
  const auto a = TransverselyIsotropic<double>::load(unit), b = TransverselyIsotropic<double>::load(long_one);
  const Matrix H{{{0.1, 0.2, 0.05}, {0, -0.1, 0.1}, {0.02, 0, 0.3}}};
  EXPECT_LT(largest_difference(a.first_pk(H), b.first_pk(H)), 1e-13);
  EXPECT_TRUE(std::isnan(TransverselyIsotropic<double>::load(zero).energy(H)));
}

}  // namespace
}  // namespace glisson::test
