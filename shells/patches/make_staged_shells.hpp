// Declaration alone: the kernels of each backend and precision are compiled in files of their own.
#pragma once

#include <memory>

#include <glisson/core/backend.hpp>
#include <glisson/core/solids/solid_forces.hpp>

namespace glisson {

/// Membranes and shells in patches; solids may be null. Defined in shells/patches/staged_shells.hpp.
template <Backend B, class R>
std::unique_ptr<SolidForces<R>> make_staged_shells(B& backend, const Model& model, const Numbering& numbering,
                                                   std::unique_ptr<SolidForces<R>> solids);

}  // namespace glisson
