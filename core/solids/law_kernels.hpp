// Fills the table of kernels of one law. Included only by the files that CMake writes.
#pragma once

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/kernels/element_forces.hpp>
#include <glisson/core/solids/solid_kernels.hpp>

namespace glisson::detail {

/// Kernels by formulation and viscosity; h8 and h8_fixed differ in their constants only.
template <class R>
struct LawKernels {
  std::string_view name;
  SolidKernels<R> t4[2], t4anp[2], h8[2], h8_full[2];
};

template <class R, class Body>
void call(const BlockView<R>& block, const EvaluationView<R>& now, int e) {
  Body{block, now}(e);
}

template <class R, class E, class L, bool viscous>
SolidKernels<R> plain_kernels() {
  return {call<R, ElementForces<R, E, L, viscous>>, nullptr, call<R, ElementEnergy<R, E, L>>,
          call<R, ElementHourglassEnergy<R, E>>};
}

template <class R, class L, bool viscous>
SolidKernels<R> averaged_kernels() {
  return {call<R, AveragedForces<R, L, viscous>>, call<R, ElementPressure<R, L>>,
          call<R, AveragedEnergy<R, L>>, call<R, ElementHourglassEnergy<R, T4>>};
}

template <class R, class L>
const LawKernels<R>* law_kernels() {
  static const LawKernels<R> kernels{
      L::name,
      {plain_kernels<R, T4, L, false>(), plain_kernels<R, T4, L, true>()},
      {averaged_kernels<R, L, false>(), averaged_kernels<R, L, true>()},
      {plain_kernels<R, H8, L, false>(), plain_kernels<R, H8, L, true>()},
      {plain_kernels<R, H8Full, L, false>(), plain_kernels<R, H8Full, L, true>()}};
  return &kernels;
}

}  // namespace glisson::detail
