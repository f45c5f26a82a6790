// The phases of patches behind function pointers, compiled once per law and precision, and how a backend
// without shared memory runs them: as loops, with the memory of each patch in an array.
#pragma once

#include <glisson/core/kernels/patch_view.hpp>
#include <glisson/core/solids/solid_kernels.hpp>

namespace glisson {

enum class PatchPhase { load, evaluate, sum };

template <class R>
using PhaseFunction = void (*)(const PatchView<R>&, const PatchStep<R>&, PatchPhase, int patch, int thread,
                               R* memory);

/// nullptr when there is no such law.
template <class R>
const KernelSet<PhaseFunction<R>>* find_patch_phases(std::string_view law, Formulation formulation,
                                                     bool viscous);

/// One phase of one thread of one patch.
template <class R>
struct CallPhase {
  PhaseFunction<R> function;
  PatchView<R> patches;
  PatchStep<R> step;
  PatchPhase phase;
  int threads;  ///< per patch
  R* memory;    ///< [patch_count][PatchMemory::size(stride)]
  void operator()(int i) const {
    const int p = i / threads;
    function(patches, step, phase, p, i % threads,
             memory + std::size_t(p) * PatchMemory<R>::size(patches.stride));
  }
};

/// A backend with shared memory and barriers specialises it. Here a barrier is the end of a loop over all
/// threads of all patches, in any order: a phase that reads what it writes itself, or a place that nobody
/// wrote, gives NaN or other bits on EmulatedDevice.
template <class B, class R>
struct PatchDispatch {
  using Function = PhaseFunction<R>;
  static const KernelSet<Function>* find(std::string_view law, Formulation formulation, bool viscous) {
    return find_patch_phases<R>(law, formulation, viscous);
  }
  /// Values of memory that run() needs for these patches.
  static std::size_t memory_size(const PatchView<R>& patches) {
    return std::size_t(patches.patch_count) * PatchMemory<R>::size(patches.stride);
  }
  static void run(B& backend, Function function, const PatchView<R>& patches, const PatchStep<R>& step,
                  int threads, R* memory) {
    for (const PatchPhase phase : {PatchPhase::load, PatchPhase::evaluate, PatchPhase::sum})
      backend.for_each(patches.patch_count * threads,
                       CallPhase<R>{function, patches, step, phase, threads, memory});
  }
};

}  // namespace glisson
