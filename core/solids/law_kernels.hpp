// Fills the table of kernels of one law. Included only by the files that CMake writes.
#pragma once

#include <initializer_list>

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/kernels/element_forces.hpp>
#include <glisson/core/kernels/patch_bodies.hpp>
#include <glisson/core/solids/run_phases.hpp>

namespace glisson::detail {

/// Kernels by formulation and viscosity; h8 and h8_fixed differ in their constants only.
template <class Function>
struct LawKernels {
  std::string_view name;
  KernelSet<Function> t4[2], t4anp[2], h8[2], h8_full[2];
};

/// The loop bodies of the plain form.
struct PlainBodies {
  template <class R, class E, class L, bool viscous>
  using Forces = ElementForces<R, E, L, viscous>;
  template <class R, class E, class L>
  using Energy = ElementEnergy<R, E, L>;
  template <class R, class E>
  using Hourglass = ElementHourglassEnergy<R, E>;
  template <class R, class L, bool viscous>
  using MeanForces = AveragedForces<R, L, viscous>;
  template <class R, class L>
  using Pressure = ElementPressure<R, L>;
  template <class R, class L>
  using MeanEnergy = AveragedEnergy<R, L>;
};

// StagedSolids keeps what they need.
static_assert(forms_constants<T4> && forms_constants<H8> && !forms_constants<H8Full>);

/// Those of patches.
struct PatchBodies {
  template <class R, class E, class L, bool viscous>
  using Forces = PatchForces<R, E, L, viscous>;
  template <class R, class E, class L>
  using Energy = PatchEnergy<R, E, L>;
  template <class R, class E>
  using Hourglass = PatchHourglassEnergy<R, E>;
  template <class R, class L, bool viscous>
  using MeanForces = PatchAveragedForces<R, L, viscous>;
  template <class R, class L>
  using Pressure = PatchPressure<R, L>;
  template <class R, class L>
  using MeanEnergy = PatchAveragedEnergy<R, L>;
};

/// A loop body as a function to call for each element.
struct CallBodies : PlainBodies {
  template <class R>
  using Function = ElementFunction<R>;
  template <class R, class Body>
  static void of(const BlockView<R>& block, const EvaluationView<R>& now, int e) {
    Body{block, now}(e);
  }
};

/// The phases of a patch as a function to call for each thread.
struct CallPhases : PatchBodies {
  template <class R>
  using Function = PhaseFunction<R>;
  template <class R, class Body>
  static void of(const PatchView<R>& patches, const PatchStep<R>& step, PatchPhase phase, int patch,
                 int thread, R* memory) {
    run_phase(Body{{patches, step}}, phase, patch, thread, memory);
  }
};

template <class How, class R, class E, class L, bool viscous>
auto element_kernels() {
  return KernelSet<typename How::template Function<R>>{
      How::template of<R, typename How::template Forces<R, E, L, viscous>>, nullptr,
      How::template of<R, typename How::template Energy<R, E, L>>,
      How::template of<R, typename How::template Hourglass<R, E>>};
}

template <class How, class R, class L, bool viscous>
auto averaged_kernels() {
  return KernelSet<typename How::template Function<R>>{
      How::template of<R, typename How::template MeanForces<R, L, viscous>>,
      How::template of<R, typename How::template Pressure<R, L>>,
      How::template of<R, typename How::template MeanEnergy<R, L>>,
      How::template of<R, typename How::template Hourglass<R, T4>>};
}

/// How: which loop bodies, and what becomes of them: CallBodies, CallPhases or the counterpart of a device.
template <class How, class R, class L>
const auto* law_kernels() {
  static const LawKernels<typename How::template Function<R>> kernels{
      L::name,
      {element_kernels<How, R, T4, L, false>(), element_kernels<How, R, T4, L, true>()},
      {averaged_kernels<How, R, L, false>(), averaged_kernels<How, R, L, true>()},
      {element_kernels<How, R, H8, L, false>(), element_kernels<How, R, H8, L, true>()},
      {element_kernels<How, R, H8Full, L, false>(), element_kernels<How, R, H8Full, L, true>()}};
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
