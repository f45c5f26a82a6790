// What the kernels of an ensemble work on: one lane is one member, W lanes are a group. Geometry is shared by
// all lanes, everything else has a value per lane. Plain data: code outside the kernel files knows no packs.
#pragma once

#include <cstddef>
#include <cstdint>

namespace glisson::lanes {

/// H: a Mat3 of packs. parameters: [count][W]. result: P as Mat3, S as SplitStress, or W as one pack [Pa].
using LawFunction = void (*)(const void* H, const float* parameters, void* result);

struct LaneLaw {
  const char* name;
  int parameter_count;
  LawFunction first_pk, second_pk, energy;
};

/// Elements of one formulation, law and number of Prony terms.
struct LaneBlock {
  int element_count = 0, constant_count = 0;
  const int* nodes = nullptr;        ///< internal numbers [-]  [element_count][corners]
  const float* constants = nullptr;  ///< E::Constants<float>, the same for all lanes  [element_count]
  const float* hourglass = nullptr;  ///< of one-point hexahedra [N/m]  [element_count][W]
  const float* parameters =
      nullptr;  ///< of the law, then the bulk modulus  [1 or element_count][count + 1][W]
  std::size_t parameter_stride = 0;               ///< floats from one element to the next; 0: uniform
  const float *alpha = nullptr, *rate = nullptr;  ///< Prony terms: see PronyCoefficients [-]  [term][W]
  float* history = nullptr;                       ///< Y [Pa]  [element_count][point][term][6][W]
  float* pressure = nullptr;                      ///< T4ANP: kappa (J - 1) [Pa]  [element_count][W]
  int isochoric = 0, volumetric = 0;              ///< number of terms
  const LaneLaw* law = nullptr;
};

/// Node arrays of a group.
struct LanePass {
  const float* u = nullptr;               ///< displacement [m]  [node_count][3][W]
  float* f = nullptr;                     ///< force [N]: add    [node_count][3][W]
  const float* nodal_pressure = nullptr;  ///< T4ANP: mean [Pa]  [node_count][W]
  const std::int32_t* advance = nullptr;  ///< all bits set: the lane's history moves on  [W]
};

/// T4ANP: the mean over the elements of a node.
struct AveragePass {
  int node_count = 0;
  const int *begin = nullptr, *element = nullptr;
  const float *weight = nullptr, *pressure = nullptr;  ///< pressure: of all elements  [element][W]
  float* nodal_pressure = nullptr;
};

using ForceKernel = void (*)(const LaneBlock&, const LanePass&);
using EnergyKernel = void (*)(const LaneBlock&, const LanePass&, double* sums);  ///< sums [J]  [W]

/// Rows of the tables: T4, T4ANP, one-point hexahedron, hexahedron with 8 points.
constexpr int kinds = 4;

struct LaneTable {
  const char* name;  ///< of the instruction set
  int width;
  bool (*available)();
  /// Members' rows x y z w [lane] -> [node][3][W], and [node][3][W] added to the rows of lanes that are not
  /// null.
  void (*gather)(const float* const* rows, int node_count, float* u);
  void (*scatter)(const float* f, int node_count, float* const* rows);
  ForceKernel forces[kinds];
  ForceKernel neo_hookean;  ///< T4 with the commonest law compiled in, without Prony terms
  ForceKernel pressures;    ///< first sweep of T4ANP
  void (*average)(const AveragePass&);
  EnergyKernel energy[kinds];
  EnergyKernel hourglass;  ///< one-point hexahedron
  const LaneLaw* laws;
  int law_count;
};

/// Widest first.
struct LaneTables {
  const LaneTable* const* tables;
  std::size_t count;
};
LaneTables lane_tables();

}  // namespace glisson::lanes
