// The loop bodies of every formulation and law behind function pointers, compiled once per law and precision.
// Host backends call them element by element; a device backend brings functions that launch a kernel of its
// own.
#pragma once

#include <string_view>

#include <glisson/core/kernels/element_forces.hpp>
#include <glisson/core/model.hpp>

namespace glisson {

/// The functions of one formulation, law and viscosity.
template <class Function>
struct KernelSet {
  Function forces = nullptr;
  Function pressure = nullptr;  ///< T4ANP only
  Function energy = nullptr;
  Function hourglass = nullptr;
};

template <class R>
using ElementFunction = void (*)(const BlockView<R>&, const EvaluationView<R>&, int e);
template <class R>
using SolidKernels = KernelSet<ElementFunction<R>>;

/// nullptr when there is no such law.
template <class R>
const SolidKernels<R>* find_solid_kernels(std::string_view law, Formulation formulation, bool viscous);

/// Loop body for host backends.
template <class R>
struct CallElement {
  ElementFunction<R> function;
  BlockView<R> block;
  EvaluationView<R> now;
  void operator()(int e) const { function(block, now, e); }
};

/// How a backend finds and runs the kernels of a block: the one place where host and device differ. A device
/// backend specialises it.
template <class B, class R>
struct SolidDispatch {
  using Function = ElementFunction<R>;
  static const KernelSet<Function>* find(std::string_view law, Formulation formulation, bool viscous) {
    return find_solid_kernels<R>(law, formulation, viscous);
  }
  static void run(B& backend, Function function, const BlockView<R>& block, const EvaluationView<R>& now) {
    backend.for_each(block.element_count, CallElement<R>{function, block, now});
  }
};

}  // namespace glisson
