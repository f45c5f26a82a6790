// Relaxation: the discrete backward-Euler solution exactly, the continuous one as dt goes to 0, and what must
// not relax.
#include <gtest/gtest.h>

#include <glisson/core/materials/prony.hpp>

#include "tests/core/material_cases.hpp"

namespace glisson::test {
namespace {

struct Series {
  std::vector<PronyCoefficients<double>> coefficients;
  int isochoric = 0;
  PronyTerms<double> view() const {
    return {coefficients.data(), isochoric, int(coefficients.size()) - isochoric};
  }
};
struct Term {
  double alpha, tau;
};
Series series(const std::vector<Term>& isochoric, const std::vector<Term>& volumetric, double dt) {
  Series s;
  for (const Term& t : isochoric) s.coefficients.push_back(prony_coefficients(t.alpha, t.tau, dt));
  for (const Term& t : volumetric) s.coefficients.push_back(prony_coefficients(t.alpha, t.tau, dt));
  s.isochoric = int(isochoric.size());
  return s;
}

const Matrix step_strain{{{0.2, 0.1, 0}, {-0.05, -0.1, 0.15}, {0.02, 0, 0.1}}};

TEST(Prony, StepStrainIsTheDiscreteSolutionForEveryLaw) {
  const std::vector<Term> iso{{0.3, 0.02}, {0.2, 0.5}}, vol{{0.1, 0.05}};
  const double dt = 0.01;
  const Series s = series(iso, vol, dt);
  for_each_type(AllLaws<double>{}, [&]<class L>() {
    const L law = example<L, double>();
    const SplitStress<double> S = law.second_pk(step_strain);
    std::vector<double> Y(18, 0.0);
    const StridedHistory<double> history{Y.data(), 1};
    for (int n = 1; n <= 100; ++n) {
      const Matrix P = first_pk_relaxed(law, step_strain, s.view(), history, true);
      // Y_n = alpha S (1 - B^n) with B = tau / (dt + tau)
      double g = 1, k = 1;
      for (const Term& t : iso) g -= t.alpha * (1 - std::pow(t.tau / (dt + t.tau), n));
      for (const Term& t : vol) k -= t.alpha * (1 - std::pow(t.tau / (dt + t.tau), n));
      const Matrix expected = push_first(step_strain, g * S.isochoric + k * S.volumetric);
      EXPECT_LT(largest_difference(P, expected), 1e-12 * largest(expected)) << L::name << " step " << n;
    }
  });
}

/// Shear stress P_12 at time T of a stress history S_12(t) = stretch of a linear law, for ramps and cycles.
struct LinearShear {
  SplitStress<double> second_pk(const Matrix& H) const { return {{0, 0, 0, H.m[0][1], 0, 0}, {}}; }
};
template <class F>
double last_stress(const std::vector<Term>& terms, double dt, double T, F strain) {
  const Series s = series(terms, {}, dt);
  std::vector<double> Y(6 * terms.size(), 0.0);
  const StridedHistory<double> history{Y.data(), 1};
  double stress = 0;
  const long count = std::lround(T / dt);
  for (long n = 1; n <= count; ++n) {
    Matrix H{};
    H.m[0][1] = strain(double(n) * dt);
    stress = second_pk_relaxed(LinearShear{}, H, s.view(), history, true).xy;
  }
  return stress;
}

/// Errors at dt and dt/2 against the exact value: backward Euler is of first order.
void expect_first_order(double coarse, double fine, double exact) {
  EXPECT_NEAR((coarse - exact) / (fine - exact), 2, 0.05);
  EXPECT_NEAR(2 * fine - coarse, exact, 1e-5);  // extrapolated
}

const std::vector<Term> two_terms{{0.4, 0.1}, {0.25, 0.7}};

TEST(Prony, StepStrainTendsToExponentials) {
  auto run = [](double dt) { return last_stress(two_terms, dt, 0.3, [](double) { return 1.0; }); };
  double exact = 1;
  for (const Term& t : two_terms) exact -= t.alpha * (1 - std::exp(-0.3 / t.tau));
  expect_first_order(run(1e-3), run(5e-4), exact);
}

TEST(Prony, RampTendsToItsClosedForm) {
  auto run = [](double dt) { return last_stress(two_terms, dt, 0.3, [](double t) { return 2 * t; }); };
  double exact = 0.6;  // Y = alpha r (t - tau (1 - exp(-t/tau)))
  for (const Term& t : two_terms) exact -= t.alpha * 2 * (0.3 - t.tau * (1 - std::exp(-0.3 / t.tau)));
  expect_first_order(run(1e-3), run(5e-4), exact);
}

TEST(Prony, CycleHasStorageAndLossModulus) {
  const double tau = 0.05, alpha = 0.4, omega = 15, T = 2;  // 40 tau: the start is forgotten to exp(-40)
  auto run = [&](double dt) {
    return last_stress({{alpha, tau}}, dt, T, [&](double t) { return std::sin(omega * t); });
  };
  const double wt = omega * tau, storage = 1 - alpha / (1 + wt * wt), loss = alpha * wt / (1 + wt * wt);
  expect_first_order(run(1e-3), run(5e-4), storage * std::sin(omega * T) + loss * std::cos(omega * T));
}

TEST(Prony, TermsActOnTheirPartOnly) {
  const auto law = example<NeoHookean<double>, double>();
  std::vector<double> Y(6, 0.0);
  const StridedHistory<double> history{Y.data(), 1};
  const Matrix swelling = diagonal(0.1, 0.1, 0.1), P = law.first_pk(swelling);
  const Series iso = series({{0.5, 1e-3}}, {}, 1e-3), vol = series({}, {{0.5, 1e-3}}, 1e-3);
  for (int n = 0; n < 10; ++n)
    EXPECT_LT(largest_difference(first_pk_relaxed(law, swelling, iso.view(), history, true), P),
              1e-12 * largest(P));
  Y.assign(6, 0.0);
  for (int n = 0; n < 60; ++n) first_pk_relaxed(law, swelling, vol.view(), history, true);
  const Matrix half = first_pk_relaxed(law, swelling, vol.view(), history, false);
  EXPECT_NEAR(half.m[0][0], 0.5 * P.m[0][0], 1e-12 * P.m[0][0]);  // (1 - alpha) remains
}

TEST(Prony, EvaluationLeavesTheHistoryAlone) {
  const auto law = example<TransverselyIsotropic<double>, double>();
  const Series s = series({{0.5, 0.01}}, {{0.2, 0.1}}, 1e-3);
  std::vector<double> Y(12);
  for (int n = 0; n < 12; ++n) Y[n] = n;
  const std::vector<double> before = Y;
  const StridedHistory<double> history{Y.data(), 1};
  const Matrix P = first_pk_relaxed(law, step_strain, s.view(), history, false);
  EXPECT_EQ(Y, before);
  EXPECT_EQ(largest_difference(P, first_pk_relaxed(law, step_strain, s.view(), history, true)), 0);
  EXPECT_NE(Y, before);
}

TEST(Prony, WithoutTermsItIsTheLaw) {
  for_each_type(AllLaws<double>{}, []<class L>() {
    const L law = example<L, double>();
    const Matrix P = first_pk_relaxed(law, step_strain, PronyTerms<double>{}, StridedHistory<double>{}, true);
    EXPECT_LT(largest_difference(P, law.first_pk(step_strain)), 1e-13 * law.wave_modulus()) << L::name;
  });
}

TEST(Prony, HistoryOfManyElementsIsStrided) {
  const auto law = example<NeoHookean<double>, double>();
  const Series s = series({{0.5, 0.01}}, {{0.2, 0.1}}, 1e-3);
  const int elements = 5;
  std::vector<double> all(12 * elements, 0.0), one(12, 0.0);
  first_pk_relaxed(law, step_strain, s.view(), StridedHistory<double>{all.data() + 3, elements}, true);
  first_pk_relaxed(law, step_strain, s.view(), StridedHistory<double>{one.data(), 1}, true);
  for (int c = 0; c < 12; ++c)
    for (int e = 0; e < elements; ++e) EXPECT_EQ(all[c * elements + e], e == 3 ? one[c] : 0.0);
}

// Near its steady state the history changes by less than half an epsilon of itself and stops: 6e-8 / rate of
// it is missing.
TEST(Prony, FloatReachesTheSteadyStateOfSlowTerms) {
  const auto c = prony_coefficients(0.5, 1.0, 1e-4);
  const PronyCoefficients<float> slow{float(c.alpha), float(c.rate)};
  const PronyTerms<float> terms{&slow, 1, 0};
  std::vector<float> Y(6, 0.0f);
  const auto law = example<NeoHookean<float>, float>();
  const Mat3<float> H = convert<float>(step_strain);
  for (int n = 0; n < 200000; ++n) second_pk_relaxed(law, H, terms, StridedHistory<float>{Y.data(), 1}, true);
  const double expected = 0.5 * law.second_pk(H).isochoric.xy;
  EXPECT_NEAR(Y[3], expected, 1.1 * 0.5 * std::numeric_limits<float>::epsilon() / 1e-4 * std::fabs(expected));
}

}  // namespace
}  // namespace glisson::test
