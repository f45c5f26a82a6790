// What each instruction set brings for membranes and shells.
#pragma once

#include <glisson/cpu/solids/kernel_table.hpp>

namespace glisson::shells {

/// Functions of a law for packs. First argument: Plane of packs, result: Plane or pack.
struct ShellLawFunctions {
  const char* name = nullptr;
  patches::LawFunction stress[2] = {}, energy[2] = {};  ///< [wrinkling]
  /// With the law compiled in; null: the general one.
  patches::PatchKernel membrane_forces = nullptr, shell_forces = nullptr;
};
constexpr int shell_law_count = 5;

struct ShellKernels {
  const char* set = nullptr;  ///< name of the instruction set
  patches::PatchKernel membrane_forces = nullptr;
  patches::EnergyKernel membrane_energy = nullptr;
  patches::PatchKernel shell_forces = nullptr, border_forces = nullptr;  ///< border: some side has an image
  patches::EnergyKernel shell_energy = nullptr, border_energy = nullptr;
  ShellLawFunctions laws[shell_law_count];
};

/// Throws Error for a set that does not exist or that this machine lacks.
const ShellKernels& shell_kernels(const char* set);

}  // namespace glisson::shells
