#include <string>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/solids/kernel_table.hpp>

namespace glisson::patches {

const InstructionSet& choose_instruction_set(const char* name) {
  const std::string wanted = name;
  const InstructionSets all = instruction_sets();
  std::string known = "auto";
  for (std::size_t i = 0; i < all.count; ++i) {
    const InstructionSet& set = all.sets[i];
    known += std::string(", ") + set.name;
    if (wanted == "auto" && set.available()) return set;
    if (wanted != set.name) continue;
    if (set.available()) return set;
    throw Error(ErrorKind::device,
                "This machine does not have the instruction set " + wanted + ". Use auto.");
  }
  if (wanted == "auto")
    throw Error(ErrorKind::device,
                "This machine has none of the instruction sets that this program was built for (" + known +
                    "). Use the device serial, or build the program on this machine.");
  throw Error(ErrorKind::usage, "The instruction set " + wanted + " is not known. Use one of " + known + ".");
}

}  // namespace glisson::patches

namespace glisson {

const NodeKernels& node_kernels(const char* instruction_set) {
  return patches::choose_instruction_set(instruction_set).formulations->nodes;
}

}  // namespace glisson
