// Results that must not differ in a single bit.
#pragma once

#include <cstring>
#include <sstream>
#include <utility>

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

/// Steps `before` and `after` in one run, and the latter again from a checkpoint between them. Returns both
/// simulations at their ends.
inline std::pair<std::unique_ptr<AnySimulation>, std::unique_ptr<AnySimulation>> expect_same_bits_resumed(
    const Model& model, const Case& c, int before, int after) {
  auto whole = simulate(model, c);
  whole->step(before);
  std::stringstream file;
  whole->save(file);
  whole->step(after);
  auto resumed = simulate(model, c);
  resumed->load(file);
  resumed->step(after);
  EXPECT_TRUE(same_bits(whole->displacement(), resumed->displacement()));
  return {std::move(whole), std::move(resumed)};
}

}  // namespace glisson::test
