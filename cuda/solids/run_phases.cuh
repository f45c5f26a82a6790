// Any body over patches on a GPU.
#pragma once

#include <glisson/core/solids/run_phases.hpp>
#include <glisson/cuda/solids/patch_kernel.cuh>

namespace glisson {

template <>
struct PhaseRunner<Cuda> {
  template <class Body, class R>
  static std::size_t memory_size(const PatchView<R>&) {
    return 0;
  }
  template <class R, class Body>
  static void run(Cuda& backend, const Body& body, R*) {
    if (body.patches.patch_count == 0) return;
    const std::size_t bytes = Body::memory_size(body.patches.stride) * sizeof(R);
    backend.launch(body.patches.patch_count, Body::threads, bytes, detail::patch_kernels<R, Body>(), body);
  }
};

}  // namespace glisson
