// Solid elements for the Threads backend in single precision: patches, strips and packs.
#pragma once

#include <memory>
#include <string>

#include <glisson/core/numbering.hpp>
#include <glisson/core/solids/solid_forces.hpp>
#include <glisson/cpu/threads.hpp>

namespace glisson {

/// instruction_set: auto, or one of sse4.2, avx2, avx512 (generic on other machines). Results do not depend
/// on the number of threads, but in the last digits on the instruction set. `threads` must outlive the
/// result; the model need not. Throws Error(device) when this machine lacks the instruction set, Error(input)
/// for a law that does not exist.
std::unique_ptr<SolidForces<float>> make_patch_solids(Threads& threads, const Model& model,
                                                      const Numbering& numbering,
                                                      const std::string& instruction_set = "auto");

/// The set that "auto" stands for on this machine: for messages.
std::string widest_instruction_set();

}  // namespace glisson
