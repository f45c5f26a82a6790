// Names, parameters and allowed ranges of the constitutive laws, as plain data: what files may contain.
// The laws themselves are in core/materials/<law>.hpp; a test compares their names and counts with this
// table.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>

namespace glisson {

/// One parameter and the open interval it must lie in.
struct ParameterRule {
  std::string_view name;
  double above = -std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
  bool modulus = false;      ///< a modulus [Pa]: checked for plausibility when the units are known
  bool may_be_zero = false;  ///< the lower bound itself is allowed
};

struct LawRule {
  std::string_view name;
  std::string_view title;
  std::span<const ParameterRule> parameters;
  int direction = -1;  ///< index of the first of 3 parameters that are a direction; -1: none
};

namespace detail {
constexpr double no_bound = std::numeric_limits<double>::infinity();
constexpr ParameterRule positive(std::string_view name) { return {name, 0, no_bound, true, false}; }
constexpr ParameterRule not_negative(std::string_view name) { return {name, 0, no_bound, true, true}; }
constexpr ParameterRule any(std::string_view name) { return {name, -no_bound, no_bound, false, false}; }

inline constexpr std::array linear_rules{positive("E"), ParameterRule{"nu", -1, 0.5, false, false}};
inline constexpr std::array neo_hookean_rules{positive("mu"), positive("kappa")};
inline constexpr std::array arruda_boyce_rules{
    positive("mu"), ParameterRule{"lambda_m", 0, no_bound, false, false}, positive("kappa")};
inline constexpr std::array polynomial_rules{any("c10"), any("c01"), any("c20"),
                                             any("c02"), any("c11"), positive("kappa")};
inline constexpr std::array transverse_rules{positive("mu"), positive("kappa"), not_negative("eta"),
                                             any("a1"),      any("a2"),         any("a3")};
inline constexpr std::array ogden_rules{any("mu1"), any("alpha1"), any("mu2"),       any("alpha2"),
                                        any("mu3"), any("alpha3"), positive("kappa")};
}  // namespace detail

inline constexpr std::array law_table{
    LawRule{"LE", "linear (St Venant-Kirchhoff)", detail::linear_rules},
    LawRule{"NH", "neo-Hookean", detail::neo_hookean_rules},
    LawRule{"AB", "Arruda-Boyce", detail::arruda_boyce_rules},
    LawRule{"PY", "polynomial of second order", detail::polynomial_rules},
    LawRule{"TI", "transversely isotropic neo-Hookean", detail::transverse_rules, 3},
    LawRule{"OG", "Ogden, three terms", detail::ogden_rules},
};

/// nullptr when there is no law of this name.
constexpr const LawRule* find_law(std::string_view name) {
  for (const auto& law : law_table)
    if (law.name == name) return &law;
  return nullptr;
}

}  // namespace glisson
