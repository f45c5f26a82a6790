// What benches for providers show, whatever their backend and precision: these as a value, and nodes on the
// host.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include <glisson/core/numbering.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

enum class BenchCase { serial_double, serial_float, threads_double, threads_float, emulated_float };

inline std::string name_of(BenchCase c) {
  const char* const names[] = {"SerialDouble", "SerialFloat", "ThreadsDouble", "ThreadsFloat",
                               "EmulatedFloat"};
  return names[static_cast<int>(c)];
}
inline void PrintTo(BenchCase c, std::ostream* out) { *out << name_of(c); }
/// Whether in single precision.
inline bool in_float(BenchCase c) { return c != BenchCase::serial_double && c != BenchCase::threads_double; }

using BenchTest = testing::TestWithParam<BenchCase>;
inline std::string bench_case_name(const testing::TestParamInfo<BenchCase>& info) {
  return name_of(info.param);
}

/// Undamped central difference with the members that the engine's steppers have.
template <class R>
struct PlainStepper {
  R kick, drift;  ///< [s]
  GLISSON_HD Vec3<R> velocity(const Vec3<R>& v, const Vec3<R>& f, R inverse_mass) const {
    return v + (kick * inverse_mass) * f;
  }
};

/// User node n has the internal number (7 n + 3) mod count, if 7 and count are coprime; identity otherwise.
inline Numbering shuffled_numbering(int count) {
  Numbering numbering;
  const bool coprime = std::gcd(7, count) == 1;
  numbering.internal_of_user.resize(std::size_t(count));
  numbering.user_of_internal.resize(std::size_t(count));
  for (int n = 0; n < count; ++n) {
    const int internal = coprime ? (7 * n + 3) % count : n;
    numbering.internal_of_user[std::size_t(n)] = internal;
    numbering.user_of_internal[std::size_t(internal)] = n;
  }
  return numbering;
}

struct BenchNodes {
  explicit BenchNodes(BenchCase its_row, int count, double mass = 1)
      : row(its_row),
        numbering(shuffled_numbering(count)),
        masses(std::size_t(count), mass),
        u(std::size_t(count)),
        v(u),
        f(u) {}

  /// Rounding of numbers near 1.
  double tolerance() const { return in_float(row) ? 2e-6 : 1e-13; }
  /// The kick of the central difference: half a step from v(0) to v(dt/2).
  double kick(double dt) const { return step_count == 0 ? 0.5 * dt : dt; }
  /// One step of the central difference for free nodes; counts step_count on.
  void advance(double dt) {
    const PlainStepper<double> stepper{kick(dt), dt};
    for (std::size_t n = 0; n < u.size(); ++n) {
      v[n] = stepper.velocity(v[n], f[n], 1 / masses[n]);
      u[n] = u[n] + dt * v[n];
    }
    ++step_count;
  }

  BenchCase row;
  Numbering numbering;
  std::vector<double> masses;         ///< [kg]
  std::vector<Vec3<double>> u, v, f;  ///< user's numbering
  std::int64_t step_count = 0;
};

inline Vec3<double> sum_of(const std::vector<Vec3<double>>& values) {
  Vec3<double> sum;
  for (const auto& a : values) sum = sum + a;
  return sum;
}
inline void expect_near(const Vec3<double>& a, const Vec3<double>& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace glisson

#define GLISSON_BENCH_CASES(suite)                                                           \
  INSTANTIATE_TEST_SUITE_P(                                                                  \
      All, suite,                                                                            \
      testing::Values(glisson::BenchCase::serial_double, glisson::BenchCase::serial_float,   \
                      glisson::BenchCase::threads_double, glisson::BenchCase::threads_float, \
                      glisson::BenchCase::emulated_float),                                   \
      glisson::bench_case_name)
