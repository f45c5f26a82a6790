// What must hold of every constitutive law, in float and double: stress from energy, objectivity, rest, wave
// speed, NaN.
#include <gtest/gtest.h>

#include "tests/core/material_cases.hpp"

namespace glisson::test {
namespace {

template <template <class> class L, class Real>
struct Case {
  using R = Real;
  template <class N>
  using LawOf = L<N>;
};

template <class C>
class EveryLaw : public testing::Test {
 protected:
  using Real = typename C::R;
  using Tested = typename C::template LawOf<Real>;
  using Differentiated = typename C::template LawOf<Dual<Real>>;
  const Tested law = example<Tested, Real>();
  static constexpr double epsilon = std::numeric_limits<Real>::epsilon();
  std::mt19937 random{20240611};

  /// dW/dF by dual numbers.
  static Matrix energy_derivative(const Matrix& H) {
    const auto dual_law = example<Differentiated, Dual<Real>>();
    Matrix P;
    for (int c = 0; c < 9; ++c) {
      Mat3<Dual<Real>> H_dual;
      for (int d = 0; d < 9; ++d) H_dual.m[d / 3][d % 3] = Dual<Real>(Real(H.m[d / 3][d % 3]), Real(c == d));
      P.m[c / 3][c % 3] = dual_law.energy(H_dual).derivative;
    }
    return P;
  }
  Matrix stress(const Matrix& H) const { return to_double(law.first_pk(convert<Real>(H))); }
};

using Cases =
    testing::Types<Case<NeoHookean, float>, Case<NeoHookean, double>, Case<StVenantKirchhoff, float>,
                   Case<StVenantKirchhoff, double>, Case<ArrudaBoyce, float>, Case<ArrudaBoyce, double>,
                   Case<Polynomial, float>, Case<Polynomial, double>, Case<TransverselyIsotropic, float>,
                   Case<TransverselyIsotropic, double>, Case<Ogden, float>, Case<Ogden, double>>;
static_assert(AllLaws<float>::size == 6, "a new law needs its line above and in example_parameters");
TYPED_TEST_SUITE(EveryLaw, Cases);

// Round-off: about a hundred operations lie between H and P, each with half an epsilon, partly of terms
// larger than P.
TYPED_TEST(EveryLaw, StressIsTheDerivativeOfTheEnergy) {
  for (const double size : {0.3, 1e-2, 1e-4})
    for (int n = 0; n < 50; ++n) {
      const Matrix H = random_gradient(this->random, size), P = this->stress(H);
      EXPECT_LT(largest_difference(P, this->energy_derivative(H)), 50 * this->epsilon * largest(P)) << size;
    }
  for (int n = 0; n < 100; ++n) {
    const Matrix H = random_large_gradient(this->random), P = this->stress(H);
    const double scale = largest(P) + double(this->law.wave_modulus());
    EXPECT_LT(largest_difference(P, this->energy_derivative(H)), 50 * this->epsilon * scale);
  }
}

TYPED_TEST(EveryLaw, SecondPiolaKirchhoffStressSumsToTheFirst) {
  using R = typename TypeParam::R;
  for (int n = 0; n < 100; ++n) {
    const Matrix H = random_large_gradient(this->random), P = this->stress(H);
    const SplitStress<R> S = this->law.second_pk(convert<R>(H));
    const Matrix Q = to_double(push_first(convert<R>(H), S.isochoric + S.volumetric));
    EXPECT_LT(largest_difference(P, Q), 50 * this->epsilon * (largest(P) + double(this->law.wave_modulus())));
  }
}

TYPED_TEST(EveryLaw, IsObjectiveAndKeepsAngularMomentum) {
  using R = typename TypeParam::R;
  for (int n = 0; n < 100; ++n) {
    const Matrix H = random_large_gradient(this->random), Q = random_rotation(this->random);
    Matrix F = H;
    for (int i = 0; i < 3; ++i) F.m[i][i] += 1;
    const Matrix H_turned = minus_identity(Q * F), P = this->stress(H), P_turned = this->stress(H_turned);
    // C of stretch 2 is known to 4 epsilon, and the stress it gives is of the order of modulus times stretch
    const double scale = 4 * double(this->law.wave_modulus()) + largest(P);
    EXPECT_LT(largest_difference(P_turned, Q * P), 100 * this->epsilon * scale);
    const double W = this->law.energy(convert<R>(H)), W_turned = this->law.energy(convert<R>(H_turned));
    EXPECT_NEAR(W_turned, W, 100 * this->epsilon * scale);
    const Matrix kirchhoff = P * transpose(F);
    EXPECT_LT(largest_difference(kirchhoff, transpose(kirchhoff)), 100 * this->epsilon * scale);
  }
}

TYPED_TEST(EveryLaw, RestHasNoStressAndNoEnergy) {
  using R = typename TypeParam::R;
  const Matrix H{};
  EXPECT_EQ(largest(this->stress(H)), 0);
  EXPECT_EQ(this->law.energy(convert<R>(H)), R(0));
  const SplitStress<R> S = this->law.second_pk(convert<R>(H));
  EXPECT_EQ(largest(to_double(full(S.isochoric))), 0);
  EXPECT_EQ(largest(to_double(full(S.volumetric))), 0);
  for (int n = 0; n < 20; ++n) {
    const Matrix P = this->stress(minus_identity(random_rotation(this->random)));
    EXPECT_LT(largest(P), 20 * this->epsilon * double(this->law.wave_modulus()));
  }
}

TYPED_TEST(EveryLaw, InvertedElementGivesNaN) {
  using R = typename TypeParam::R;
  for (const Matrix& F :
       {diagonal(-1, 1, 1), diagonal(0, 1, 1), diagonal(-0.5, -2, -1), diagonal(-1e-3, 1.1, 0.9)}) {
    const Mat3<R> H = convert<R>(minus_identity(F));
    const Matrix P = to_double(this->law.first_pk(H));
    for (const auto& row : P.m)
      for (const double value : row) EXPECT_TRUE(std::isnan(value));
    EXPECT_TRUE(std::isnan(this->law.energy(H)));
    const SplitStress<R> S = this->law.second_pk(H);
    EXPECT_TRUE(std::isnan(S.isochoric.xx + S.volumetric.xx));
  }
}

/// Largest and smallest eigenvalue of the acoustic tensor Q_ik = n_J dP_iJ/dH_kL n_L at rest, by central
/// differences: the stress is accurate relative to itself, so that a step of 1e-6 costs 1e-12 and no
/// cancellation.
template <class L>
std::pair<double, double> acoustic_range(const L& law, const Vec3<double>& direction) {
  const double n[3] = {direction.x, direction.y, direction.z}, h = 1e-6;
  Matrix Q{};
  for (int k = 0; k < 3; ++k) {
    Matrix up{}, down{};
    for (int c = 0; c < 3; ++c) up.m[k][c] = h * n[c], down.m[k][c] = -h * n[c];
    const Matrix P = law.first_pk(up), P_down = law.first_pk(down);
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < 3; ++c) Q.m[i][k] += (P.m[i][c] - P_down.m[i][c]) / (2 * h) * n[c];
  }
  EXPECT_LT(largest_difference(Q, transpose(Q)), 1e-9 * largest(Q));
  const auto e =
      eigen_symmetric(Sym3<double>{Q.m[0][0], Q.m[1][1], Q.m[2][2], Q.m[0][1], Q.m[1][2], Q.m[0][2]});
  return {std::max({e.value[0], e.value[1], e.value[2]}), std::min({e.value[0], e.value[1], e.value[2]})};
}

TYPED_TEST(EveryLaw, ModuliAreThoseOfTheTangentAtRest) {
  using L = typename TypeParam::template LawOf<double>;
  const L exact = example<L, double>();
  const double M = exact.wave_modulus();
  for (int n = 0; n < 100; ++n) {
    const Matrix Q = random_rotation(this->random);
    const auto [fastest, slowest] = acoustic_range(exact, {Q.m[0][0], Q.m[0][1], Q.m[0][2]});
    EXPECT_LE(fastest, M * (1 + 1e-9));
    if constexpr (!std::is_same_v<L, TransverselyIsotropic<double>>) {
      EXPECT_NEAR(fastest, M, 1e-9 * M);
      EXPECT_NEAR(slowest, exact.shear_modulus(), 1e-9 * M);
    }
  }
  if constexpr (std::is_same_v<L, TransverselyIsotropic<double>>) {
    EXPECT_NEAR(acoustic_range(exact, exact.a).first, M, 1e-9 * M);
  }
  const Matrix P = exact.first_pk(diagonal(1e-7, 1e-7, 1e-7)),
               P_down = exact.first_pk(diagonal(-1e-7, -1e-7, -1e-7));
  const double pressure = (trace(P) - trace(P_down)) / 6;
  EXPECT_NEAR(pressure, 3e-7 * exact.bulk_modulus(), 1e-6 * pressure);
}

// Float with the same H and parameters as double: the state keeps displacement gradients, so nothing may be
// lost below. One thing is inherent: where the entries of tr H cancel, their two additions round by epsilon
// sum |H_ii| at most, which the bulk modulus turns into a pressure; the sums in e = H + H^T + H^T H round
// likewise by the size of H, which the rest of the wave modulus turns into shear stress. J |C^-1| < 2 at the
// strains here.
TYPED_TEST(EveryLaw, FloatIsAccurateAtAnyStrain) {
  if constexpr (std::is_same_v<typename TypeParam::R, float>) {
    using L = typename TypeParam::template LawOf<double>;
    const L exact = example<L, double>();
    double worst = 0;
    for (const double size : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5})
      for (int n = 0; n < 200; ++n) {
        const Matrix H = random_gradient(this->random, size), P = exact.first_pk(H);
        const double sum = std::fabs(H.m[0][0]) + std::fabs(H.m[1][1]) + std::fabs(H.m[2][2]);
        const double inherent = 2 * this->epsilon * exact.bulk_modulus() * sum;
        EXPECT_LT(largest_difference(this->stress(H), P), 1e-6 * largest(P) + inherent) << size;
        worst = std::max(worst, largest_difference(this->stress(H), P) / largest(P));
        const double W = exact.energy(H);
        EXPECT_NEAR(this->law.energy(convert<float>(H)), W, 1e-6 * W) << size;
        const SplitStress<float> S = this->law.second_pk(convert<float>(H));
        const SplitStress<double> S_exact = exact.second_pk(H);
        const Matrix iso = full(S_exact.isochoric), vol = full(S_exact.volumetric);
        const double differences =
            2 * this->epsilon * (exact.wave_modulus() - exact.bulk_modulus()) * 3 * largest(H);
        EXPECT_LT(largest_difference(to_double(full(S.isochoric)), iso), 1e-6 * largest(iso) + differences)
            << size;
        EXPECT_LT(largest_difference(to_double(full(S.volumetric)), vol), 1e-6 * largest(vol) + inherent)
            << size;
      }
    this->RecordProperty("worst_relative_error_of_P", std::to_string(1e6 * worst) + " 1e-6");
    EXPECT_LT(worst, 1e-5);
  }
}

}  // namespace
}  // namespace glisson::test
