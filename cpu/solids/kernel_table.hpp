// What each instruction set brings: pointers to functions that were compiled for it.
#pragma once

#include <cstddef>

#include <glisson/cpu/node_kernels.hpp>
#include <glisson/cpu/solids/patch.hpp>

namespace glisson::patches {

using PatchKernel = void (*)(const Patch&, const Pass&);
using EnergyKernel = double (*)(const Patch&, const Pass&);  ///< [J]

/// Row in the tables: enum class Formulation in its order, then special cases that only patches know.
enum class Kind { t4, t4anp, h8, h8_fixed, h8_full, h8_parallelepiped };
constexpr int kind_count = 6;

/// Kernels for any law, which they call through Pass::law.
struct FormulationTable {
  int width = 0;  ///< lanes
  PatchKernel load_displacements = nullptr;
  PatchKernel load_pressures = nullptr;  ///< into the w of local rows
  PatchKernel sum_forces = nullptr;
  PatchKernel sum_pressures = nullptr;
  PatchKernel pressures = nullptr;  ///< first sweep of T4ANP
  PatchKernel forces[kind_count] = {};
  EnergyKernel strain_energy[kind_count] = {};
  EnergyKernel hourglass_energy[kind_count] = {};  ///< null: none
  NodeKernels nodes;
  /// For tests: rcbrt, square_root, log_1p, exp_m1 of `width` numbers.
  void (*functions[4])(const float* from, float* to) = {};
};

/// One law: functions that the kernels above call, and kernels of its own where the law is worth compiling
/// into them.
struct LawTable {
  const char* name = nullptr;  ///< as in files
  int parameter_count = 0;
  LawFunction elastic = nullptr, viscous = nullptr;  ///< P [Pa] as Mat3
  LawFunction energy = nullptr;                      ///< W [Pa]
  PatchKernel forces[kind_count] = {};               ///< null: take the general one
  PatchKernel viscous_forces[kind_count] = {};
};

struct InstructionSet {
  const char* name;  ///< sse4.2, avx2, avx512; generic on other machines
  bool (*available)();
  const FormulationTable* formulations;
  const LawTable* const* laws;  ///< [law_count]
  std::size_t law_count;
};

/// Widest first.
struct InstructionSets {
  const InstructionSet* sets;
  std::size_t count;
};
InstructionSets instruction_sets();

/// "auto": the widest that this machine has. Throws Error(usage) for an unknown name, Error(device) for one
/// not available.
const InstructionSet& choose_instruction_set(const char* name);

}  // namespace glisson::patches
