// Solids in plain form on a GPU: the kernels of core/kernels/ launched over the elements of a block.
#pragma once

#include <glisson/core/solids/solid_kernels.hpp>
#include <glisson/cuda/backend.cuh>

namespace glisson {

template <class R>
using LaunchFunction = void (*)(Cuda&, const BlockView<R>&, const EvaluationView<R>&);

/// Defined by a file that CMake writes from cmake/GlissonLaws.cmake; nullptr when there is no such law.
template <class R>
const KernelSet<LaunchFunction<R>>* find_cuda_kernels(std::string_view law, Formulation formulation,
                                                      bool viscous);

template <class R>
struct SolidDispatch<Cuda, R> {
  using Function = LaunchFunction<R>;
  static const KernelSet<Function>* find(std::string_view law, Formulation formulation, bool viscous) {
    return find_cuda_kernels<R>(law, formulation, viscous);
  }
  static void run(Cuda& backend, Function function, const BlockView<R>& block, const EvaluationView<R>& now) {
    function(backend, block, now);
  }
};

namespace detail {

/// A loop body as a function that launches it over a block.
struct LaunchBodies {
  template <class R>
  using Function = LaunchFunction<R>;
  template <class R, class Body>
  static void of(Cuda& backend, const BlockView<R>& block, const EvaluationView<R>& now) {
    backend.for_each(block.element_count, Body{block, now});
  }
};

}  // namespace detail
}  // namespace glisson
