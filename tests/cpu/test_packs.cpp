// The functions of packs against double, on every instruction set that this machine has.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/solids/kernel_table.hpp>

namespace glisson {
namespace {

enum Function { cube_root, root, logarithm, exponential };

/// values through function number `f` of a set.
std::vector<float> apply(const patches::FormulationTable& table, Function f, std::vector<float> values) {
  const auto W = static_cast<std::size_t>(table.width);
  values.resize((values.size() + W - 1) / W * W, 1.0f);
  for (std::size_t i = 0; i < values.size(); i += W) {
    alignas(64) float from[16], to[16];
    std::copy_n(values.data() + i, W, from);
    table.functions[f](from, to);
    std::copy_n(to, W, values.data() + i);
  }
  return values;
}

/// Largest error in units of the last place of the exact result.
double largest_error(const patches::FormulationTable& table, Function f, const std::vector<float>& values,
                     double (*exact)(double)) {
  const auto results = apply(table, f, values);
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double right = exact(double(values[i]));
    const double place = std::max(std::ldexp(1.0, std::ilogb(right) - 23), 1e-45);
    largest = std::max(largest, std::abs(double(results[i]) - right) / place);
  }
  return largest;
}

/// Steps of equal ratio, both signs if asked for.
std::vector<float> ladder(double from, double to, bool both_signs = false) {
  std::vector<float> values;
  for (double x = from; x < to; x *= 1.00037) {
    values.push_back(float(x));
    if (both_signs) values.push_back(float(-x));
  }
  return values;
}

template <class Visit>
void for_each_available_set(Visit&& visit) {
  const auto all = patches::instruction_sets();
  for (std::size_t i = 0; i < all.count; ++i) {
    SCOPED_TRACE(all.sets[i].name);
    if (all.sets[i].available()) visit(*all.sets[i].formulations);
  }
}

TEST(Packs, FunctionsAreAccurateToAFewUnitsInTheLastPlace) {
  for_each_available_set([](const auto& table) {
    EXPECT_LE(largest_error(table, cube_root, ladder(1e-30, 1e30), [](double x) { return 1 / std::cbrt(x); }),
              2);
    EXPECT_LE(largest_error(table, root, ladder(1e-30, 1e30), [](double x) { return std::sqrt(x); }), 0.51);
    EXPECT_LE(
        largest_error(table, logarithm, ladder(1e-30, 0.9999, true), [](double x) { return std::log1p(x); }),
        2);
    EXPECT_LE(largest_error(table, logarithm, ladder(1, 1e30), [](double x) { return std::log1p(x); }), 2);
    EXPECT_LE(
        largest_error(table, exponential, ladder(1e-30, 39, true), [](double x) { return std::expm1(x); }),
        3);
    EXPECT_LE(largest_error(table, exponential, ladder(39, 88.7), [](double x) { return std::expm1(x); }), 3);
  });
}

TEST(Packs, EdgesAreThoseOfTheScalarFunctions) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for_each_available_set([=](const auto& table) {
    const auto roots = apply(table, cube_root, {0, -0.0f, -1, -1e-30f, nan});
    for (std::size_t i = 0; i < 5; ++i) EXPECT_TRUE(std::isnan(roots[i]));
    const auto logs = apply(table, logarithm, {-1, -1.5f, inf, nan, 0});
    EXPECT_EQ(logs[0], -inf);
    EXPECT_TRUE(std::isnan(logs[1]));
    EXPECT_EQ(logs[2], inf);
    EXPECT_TRUE(std::isnan(logs[3]));
    EXPECT_EQ(logs[4], 0);
    const auto exponentials = apply(table, exponential, {-inf, -200, inf, nan, 0});
    EXPECT_EQ(exponentials[0], -1);
    EXPECT_EQ(exponentials[1], -1);
    EXPECT_EQ(exponentials[2], inf);
    EXPECT_TRUE(std::isnan(exponentials[3]));
    EXPECT_EQ(exponentials[4], 0);
  });
}

TEST(InstructionSets, AreChosenByNameAndRefusedWithAReason) {
  EXPECT_NO_THROW(patches::choose_instruction_set("auto"));
  EXPECT_THROW(patches::choose_instruction_set("mmx"), Error);
  const auto all = patches::instruction_sets();
  for (std::size_t i = 0; i < all.count; ++i) {
    if (all.sets[i].available())
      EXPECT_STREQ(patches::choose_instruction_set(all.sets[i].name).name, all.sets[i].name);
    else
      EXPECT_THROW(patches::choose_instruction_set(all.sets[i].name), Error);
  }
}

}  // namespace
}  // namespace glisson
