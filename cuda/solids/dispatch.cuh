// Solids on a GPU: one thread block per patch, one thread per element, nodes and forces in shared memory.
#pragma once

#include <glisson/core/solids/patch_kernels.hpp>
#include <glisson/cuda/backend.cuh>

namespace glisson {

template <class R>
using PatchLaunch = void (*)(Cuda&, const PatchView<R>&, const PatchStep<R>&);

/// Defined by a file that CMake writes from cmake/GlissonLaws.cmake; nullptr when there is no such law.
template <class R>
const KernelSet<PatchLaunch<R>>* find_cuda_kernels(std::string_view law, Formulation formulation,
                                                   bool viscous);

template <class R>
struct PatchDispatch<Cuda, R> {
  using Function = PatchLaunch<R>;
  static const KernelSet<Function>* find(std::string_view law, Formulation formulation, bool viscous) {
    return find_cuda_kernels<R>(law, formulation, viscous);
  }
  static std::size_t memory_size(const PatchView<R>&) { return 0; }
  static void run(Cuda& backend, Function function, const PatchView<R>& patches, const PatchStep<R>& step,
                  int, R*) {
    if (patches.patch_count > 0) function(backend, patches, step);
  }
};

}  // namespace glisson
