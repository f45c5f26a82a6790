// Dual numbers, the remainders of log and exp, and the fixed-sweep eigenvalues.
#include <gtest/gtest.h>

#include <glisson/core/numbers/remainders.hpp>
#include <glisson/core/tensor/traceless_eigenvalues.hpp>

#include "tests/core/material_cases.hpp"

namespace glisson::test {
namespace {

TEST(Dual, DerivativesAreThoseOfCalculus) {
  for (const double x : {0.1, 0.7, 1.0, 3.5}) {
    const Dual<double> d{x, 1};
    EXPECT_NEAR((d * d * d).derivative, 3 * x * x, 1e-13);
    EXPECT_NEAR((Dual<double>(2) / d).derivative, -2 / (x * x), 1e-12);
    EXPECT_NEAR((-d - d + Dual<double>(1)).derivative, -2, 0);
    EXPECT_NEAR(rcbrt(d).derivative, -std::pow(x, -4.0 / 3) / 3, 1e-12);
    EXPECT_NEAR(square_root(d).derivative, 0.5 / std::sqrt(x), 1e-13);
    EXPECT_NEAR(log_1p(d).derivative, 1 / (1 + x), 1e-13);
    EXPECT_NEAR(exp_m1(d).derivative, std::exp(x), 1e-12);
    EXPECT_NEAR(linear_minus_log(d).derivative, x / (1 + x), 1e-13);
    EXPECT_NEAR(exp_minus_linear(d).derivative, std::expm1(x), 1e-12);
    EXPECT_EQ(select(d < Dual<double>(1), d, -d).derivative, x < 1 ? 1 : -1);
  }
}

template <class R>
void check_remainders(double relative) {
  for (int n = 0; n < 400; ++n) {
    const double size = std::pow(10, -6 + n / 400.0 * 6.2);
    for (const double exact : {size, -0.5 * size}) {
      const R x = R(exact);
      const long double v = x;
      // long double loses what double needs below 1e-3; there the series to x^6 is exact to 1e-15
      const long double log_part = std::fabs(exact) > 1e-3
                                       ? v - std::log1p(v)
                                       : v * v * (0.5L - v * (1 / 3.0L - v * (0.25L - v * (0.2L - v / 6))));
      const long double exp_part = std::fabs(exact) > 1e-3
                                       ? std::expm1(v) - v
                                       : v * v / 2 * (1 + v / 3 * (1 + v / 4 * (1 + v / 5 * (1 + v / 6))));
      EXPECT_NEAR(linear_minus_log(x) / log_part, 1, relative) << exact;
      EXPECT_NEAR(exp_minus_linear(x) / exp_part, 1, relative) << exact;
    }
  }
}

// At the switch to the direct difference the terms are up to ten times larger than the result.
TEST(Remainders, KeepTheirRelativeAccuracy) {
  check_remainders<double>(12 * std::numeric_limits<double>::epsilon());
  check_remainders<float>(12 * std::numeric_limits<float>::epsilon());
}

TEST(EigenSymmetric, FourSweepsReachRoundOff) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> entry(-1, 1), exponent(-12, 0);
  for (int n = 0; n < 20000; ++n) {
    auto value = [&] {
      return n % 2 ? entry(random) : std::copysign(std::pow(10, exponent(random)), entry(random));
    };
    Sym3<double> a{value(), value(), value(), value(), value(), value()};
    if (n % 5 == 0) a.yy = a.xx;
    if (n % 7 == 0) a.zz = a.yy, a.xy = 0;
    if (n % 11 == 0) a.yz = a.xz = 0;
    const auto e = eigen_symmetric(a);
    const Matrix V = e.vectors, back = V * diagonal(e.value[0], e.value[1], e.value[2]) * transpose(V);
    const double size = largest(full(a));
    ASSERT_LT(largest_difference(back, full(a)), 1e-14 * size) << n;
    ASSERT_LT(largest_difference(V * transpose(V), identity()), 1e-14) << n;
  }
}

// Exact sums of powers of the eigenvalues, random tensors and those with equal eigenvalues.
TEST(TracelessEigenvalues, AreRootsAlsoWhereTheyMeet) {
  const Sym3<double> cases[] = {{1, 1, -2, 0, 0, 0},          {-1, 2, -1, 0, 0, 0},
                                {0, 0, 0, 1, 0, 0},           {0, 0, 0, 1, 1, 1},
                                {0, 0, 0, -1, -1, -1},        {3, -1, -2, 0.5, -0.7, 0.1},
                                {1e-8, 1e-8, -2e-8, 0, 0, 0}, {1, -1, 0, 1e-9, 0, 0}};
  for (const Sym3<double>& x : cases) {
    const auto v = traceless_eigenvalues(x);
    const double a = v.apart, b = v.middle - v.half_gap, c = v.middle + v.half_gap, size = contract(x, x);
    EXPECT_GT(v.half_gap, 0);
    EXPECT_NEAR(a + b + c, 0, 1e-15 * std::sqrt(size));
    EXPECT_NEAR(a * a + b * b + c * c, size, 1e-14 * size);
    EXPECT_NEAR(a * b * c, determinant(x), 1e-14 * size * std::sqrt(size));
    EXPECT_GE(std::abs(a - v.middle), v.half_gap);  // apart from both
  }
}

}  // namespace
}  // namespace glisson::test
