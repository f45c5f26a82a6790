// The loop bodies of every formulation and law behind function pointers, compiled once per law and precision.
// Host backends call them element by element; a CUDA backend instantiates the bodies itself.
#pragma once

#include <string_view>

#include <glisson/core/kernels/element_forces.hpp>
#include <glisson/core/model.hpp>

namespace glisson {

template <class R>
using ElementFunction = void (*)(const BlockView<R>&, const EvaluationView<R>&, int e);

template <class R>
struct SolidKernels {
  ElementFunction<R> forces = nullptr;
  ElementFunction<R> pressure = nullptr;  ///< T4ANP only
  ElementFunction<R> energy = nullptr;
  ElementFunction<R> hourglass = nullptr;
};

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

}  // namespace glisson
