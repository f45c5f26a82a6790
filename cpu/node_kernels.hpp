// The node update in packs, for the instruction set of this machine.
#pragma once

#include <glisson/core/kernels/advance_nodes.hpp>
#include <glisson/core/steppers/steppers.hpp>

namespace glisson {

/// Entries first .. last - 1 of a loop body: nodes, or chunks of nodes.
template <class Stepper>
struct NodeKernelsOf {
  using Advance = AdvanceNodes<float, Stepper>;
  using Damped = AdvanceNodesDamped<float, Stepper>;
  void (*advance)(const Advance& body, int first, int last) = nullptr;
  void (*damped)(const Damped& body, int first, int last) = nullptr;

  void run(const Advance& body, int first, int last) const { advance(body, first, last); }
  void run(const Damped& body, int first, int last) const { damped(body, first, last); }
};
struct NodeKernels : NodeKernelsOf<CentralDifference<float>>, NodeKernelsOf<Newmark<float>> {
  using NodeKernelsOf<CentralDifference<float>>::run;
  using NodeKernelsOf<Newmark<float>>::run;
};

/// Of an instruction set by name, or "auto". Throws as choose_instruction_set does.
const NodeKernels& node_kernels(const char* instruction_set);

}  // namespace glisson
