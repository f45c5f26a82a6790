// Names, parameters and ranges of the laws of membranes and shells, as plain data; the laws are in
// shells/laws/.
#pragma once

#include <glisson/core/materials/law_table.hpp>

namespace glisson {

struct ShellLawRule {
  LawRule law;
  bool shell = false;      ///< may be the membrane part of a rotation-free shell
  bool wrinkles = false;   ///< isotropic: the tension field can be found
  bool one_sided = false;  ///< stiffer in tension than in compression from the start
};

namespace detail {
inline constexpr std::array membrane_rules{positive("mu")};
inline constexpr std::array fung_rules{positive("mu"), ParameterRule{"b", 0, no_bound, false, false}};
inline constexpr std::array two_fibre_rules{positive("mu"), not_negative("k1"),
                                            ParameterRule{"k2", 0, no_bound, false, false},
                                            ParameterRule{"angle", -90.001, 90.001, false, false}};
}  // namespace detail

inline constexpr std::array shell_law_table{
    ShellLawRule{{"Linear", "linear plane stress", detail::linear_rules}, true, true},
    ShellLawRule{{"NeoHookean", "incompressible neo-Hookean", detail::membrane_rules}, true, true},
    ShellLawRule{
        {"NeoHookeanCompressible", "neo-Hookean in plane stress", detail::neo_hookean_rules}, true, true},
    ShellLawRule{{"Fung", "exponential, incompressible", detail::fung_rules}, false, true},
    ShellLawRule{
        {"TwoFibre", "two fibre families, incompressible", detail::two_fibre_rules}, false, false, true},
};

/// nullptr when there is no law of this name.
constexpr const ShellLawRule* find_shell_law(std::string_view name) {
  for (const auto& rule : shell_law_table)
    if (rule.law.name == name) return &rule;
  return nullptr;
}

}  // namespace glisson
