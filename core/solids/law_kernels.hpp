// Fills the table of kernels of one law. Included only by the files that CMake writes.
#pragma once

#include <initializer_list>

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/kernels/element_forces.hpp>
#include <glisson/core/solids/solid_kernels.hpp>

namespace glisson::detail {

/// Kernels by formulation and viscosity; h8 and h8_fixed differ in their constants only.
template <class Function>
struct LawKernels {
  std::string_view name;
  KernelSet<Function> t4[2], t4anp[2], h8[2], h8_full[2];
};

/// A loop body as a function to call for each element.
struct CallBodies {
  template <class R>
  using Function = ElementFunction<R>;
  template <class R, class Body>
  static void of(const BlockView<R>& block, const EvaluationView<R>& now, int e) {
    Body{block, now}(e);
  }
};

template <class How, class R, class E, class L, bool viscous>
auto plain_kernels() {
  return KernelSet<typename How::template Function<R>>{
      How::template of<R, ElementForces<R, E, L, viscous>>, nullptr,
      How::template of<R, ElementEnergy<R, E, L>>, How::template of<R, ElementHourglassEnergy<R, E>>};
}

template <class How, class R, class L, bool viscous>
auto averaged_kernels() {
  return KernelSet<typename How::template Function<R>>{
      How::template of<R, AveragedForces<R, L, viscous>>, How::template of<R, ElementPressure<R, L>>,
      How::template of<R, AveragedEnergy<R, L>>, How::template of<R, ElementHourglassEnergy<R, T4>>};
}

/// How: what becomes of a loop body, CallBodies or its counterpart of a device.
template <class How, class R, class L>
const auto* law_kernels() {
  static const LawKernels<typename How::template Function<R>> kernels{
      L::name,
      {plain_kernels<How, R, T4, L, false>(), plain_kernels<How, R, T4, L, true>()},
      {averaged_kernels<How, R, L, false>(), averaged_kernels<How, R, L, true>()},
      {plain_kernels<How, R, H8, L, false>(), plain_kernels<How, R, H8, L, true>()},
      {plain_kernels<How, R, H8Full, L, false>(), plain_kernels<How, R, H8Full, L, true>()}};
  return &kernels;
}

/// nullptr when no law has this name.
template <class Function>
const KernelSet<Function>* find_kernels(std::initializer_list<const LawKernels<Function>*> laws,
                                        std::string_view name, Formulation formulation, bool viscous) {
  for (const auto* law : laws) {
    if (law->name != name) continue;
    switch (formulation) {
      case Formulation::t4:
        return &law->t4[viscous];
      case Formulation::t4anp:
        return &law->t4anp[viscous];
      case Formulation::h8:
      case Formulation::h8_fixed:
        return &law->h8[viscous];
      case Formulation::h8_full:
        return &law->h8_full[viscous];
    }
  }
  return nullptr;
}

}  // namespace glisson::detail
