// Membranes and shells for the Threads backend in single precision: patches, strips and packs.
#pragma once

#include <memory>
#include <string>

#include <glisson/core/numbering.hpp>
#include <glisson/core/solids/solid_forces.hpp>
#include <glisson/cpu/threads.hpp>

namespace glisson::shells {

/// solids: those of the same model, or null. `threads` must outlive the result; the model need not. As for
/// solids, results do not depend on the number of threads, but in the last digits on the instruction set.
std::unique_ptr<SolidForces<float>> make_packed_shells(Threads& threads, const Model& model,
                                                       const Numbering& numbering,
                                                       std::unique_ptr<SolidForces<float>> solids,
                                                       const std::string& instruction_set);

}  // namespace glisson::shells
