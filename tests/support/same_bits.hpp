// Results that must not differ in a single bit.
#pragma once

#include <cstring>

#include <tests/support/cases.hpp>

namespace glisson::test {

inline bool same_bits(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

/// Twice with one thread, with two, and with more than this machine may have. Returns the displacement.
inline std::vector<Vec3<double>> expect_same_bits_for_any_threads(const Model& model, const Case& c,
                                                                  int steps) {
  auto run = [&](int threads) {
    auto simulation = simulate(model, c, threads);
    simulation->step(steps);
    return simulation->displacement();
  };
  const auto first = run(1);
  for (const int threads : {1, 2, 3}) EXPECT_TRUE(same_bits(first, run(threads))) << threads << " threads";
  return first;
}

}  // namespace glisson::test
