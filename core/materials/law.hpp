// What a constitutive law is: a value with a fixed number of parameters, evaluated for any number type R.
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// Stress split for Prony terms: second Piola-Kirchhoff S = isochoric + volumetric.
template <class R>
struct SplitStress {
  Sym3<R> isochoric, volumetric;
};

/// A law is a class template `Law<R>` whose members are exactly `parameter_count` values of R in the order of
/// the NiftySim format, so that it can be loaded from parameter arrays (uniform or per element, scalar or
/// pack). first_pk starts from H = du/dX and cancels nothing at small strain. energy is evaluated in double
/// by the engine. wave_modulus is lambda + 2 mu at rest (an upper bound of the tangent there); bulk_modulus
/// is used by T4ANP.
template <class L, class R>
concept Law = std::is_trivially_copyable_v<L> && requires(const L law, const Mat3<R> H, const R* p) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::parameter_count } -> std::convertible_to<int>;
  { L::load(p) } -> std::same_as<L>;                     // parameters p[0 .. parameter_count)
  { law.first_pk(H) } -> std::same_as<Mat3<R>>;          // P [Pa]
  { law.second_pk(H) } -> std::same_as<SplitStress<R>>;  // S [Pa]
  { law.energy(H) } -> std::same_as<R>;                  // W [Pa]
  { law.wave_modulus() } -> std::same_as<R>;             // [Pa]
  { law.shear_modulus() } -> std::same_as<R>;            // at rest [Pa]
  { law.bulk_modulus() } -> std::same_as<R>;             // [Pa]
};

}  // namespace glisson
