// The phases of a body over all patches, where the body is known as a type and no table of functions is
// needed.
#pragma once

#include <glisson/core/solids/patch_kernels.hpp>

namespace glisson {

template <class R, class Body>
void run_phase(const Body& body, PatchPhase phase, int patch, int thread, R* memory) {
  if (phase == PatchPhase::load)
    body.load(patch, thread, memory);
  else if (phase == PatchPhase::evaluate)
    body.evaluate(patch, thread, memory);
  else
    body.sum(patch, thread, memory);
}

/// A backend with shared memory and barriers specialises it. Here, as in PatchDispatch, a barrier is the end
/// of a loop over all threads of all patches.
template <class B>
struct PhaseRunner {
  template <class R, class Body>
  struct OnePhase {
    Body body;
    PatchPhase phase;
    R* memory;  ///< [patch_count][memory_size]
    void operator()(int i) const {
      const int p = i / Body::threads;
      run_phase(body, phase, p, i % Body::threads,
                memory + std::size_t(p) * Body::memory_size(body.patches.stride));
    }
  };
  /// Values of memory that run() needs for these patches.
  template <class Body, class R>
  static std::size_t memory_size(const PatchView<R>& patches) {
    return std::size_t(patches.patch_count) * Body::memory_size(patches.stride);
  }
  /// Body: with members patches, load, evaluate and sum, threads per patch and memory_size(stride).
  template <class R, class Body>
  static void run(B& backend, const Body& body, R* memory) {
    for (const PatchPhase phase : {PatchPhase::load, PatchPhase::evaluate, PatchPhase::sum})
      backend.for_each(body.patches.patch_count * Body::threads, OnePhase<R, Body>{body, phase, memory});
  }
};

}  // namespace glisson
