// Patches: the pieces into which the solid elements are cut so that their nodes fit into the first cache.
// Plain data, shared by the host code that builds patches and by the kernel files that run them. Layouts:
// doc/developer/cpu-backend.md.
#pragma once

#include <cstdint>

#include <glisson/core/materials/prony.hpp>

namespace glisson::patches {

/// Tetrahedra per strip: each one shares a face with the next, so that 3 of them touch 6 nodes instead of 12.
constexpr int strip_length = 3;
constexpr int strip_corners = strip_length + 3;

/// One-point hexahedra per column: each one shares a face with the next, so that 3 of them touch 16 nodes
/// instead of 24.
constexpr int column_length = 3;
constexpr int column_corners = 4 * (column_length + 1);

/// Row of a lane within the W rows that store_nodes and store_scalars write.
constexpr int row_of_lane(int lane, int width) { return lane % 4 * (width / 4) + lane / 4; }

/// Consecutive local nodes whose forces are sums of equally many rows, so that the loop over rows does not
/// mispredict.
struct SumRun {
  std::uint16_t nodes, rows;
};

/// Elements of one formulation, law and set of Prony terms. A tile is W strips of tetrahedra, W columns of
/// hexahedra or W hexahedra, one per lane. Everything a patch points to lies in one block of memory in the
/// order of the members.
struct Patch {
  int tiles = 0;
  int node_count = 0;
  int interior_count = 0;  ///< the first nodes, which no other patch touches
  int slot = 0;            ///< place of the first other node in the slot arrays
  int interior_runs = 0, runs = 0;
  int parameter_stride = 0;               ///< floats from one tile of elements to the next; 0: uniform [-]
  const int* node = nullptr;              ///< internal node of a local node [-]        [node_count]
  const std::uint16_t* corner = nullptr;  ///< 4 x local node [-]                       [tiles][corners][W]
  const std::uint16_t* row = nullptr;     ///< 4 x force row of each node, run by run [-]
  const SumRun* run = nullptr;            ///< [runs]
  const int* element =
      nullptr;  ///< user's element of a lane, -1: none [-]   [element tiles][W]; only with history
  const float* parameters =
      nullptr;               ///< of the law                               [1 or element tiles][count][W]
  float* history = nullptr;  ///< Prony terms Y [Pa]                       [element tiles][points][term][6][W]
  const float* constants = nullptr;  ///< of the element                           [element tiles][count][W]
};

/// A function of a law for packs: H is a Mat3 of packs, tile a MaterialTile, the result depends on the
/// function. Without types, because code outside the kernel files must not know packs.
using LawFunction = void (*)(const void* H, const void* tile, void* result);

/// What one pass over patches reads and writes. Arrays of nodes are rows x y z w of floats in internal
/// numbering.
struct Pass {
  const float* u = nullptr;                ///< displacement [m]                         [node_count][4]
  float* f = nullptr;                      ///< force [N]                                [node_count][4]
  float* slot_force = nullptr;             ///< force of one patch on a shared node [N]  [slot_count][4]
  float* pressure = nullptr;               ///< averaged at nodes, a quarter of it [Pa]  [node_count]
  float* slot_pressure = nullptr;          ///< parts of it times volume [Pa m^3]        [slot_count]
  const float* pressure_weight = nullptr;  ///< 1 / (4 volume of the elements around) [1/m^3]  [node_count]
  float* local_rows = nullptr;  ///< of this thread: nodes of the patch       [largest node_count][4]
  float* force_rows = nullptr;  ///< of this thread: forces of its elements; the first 16 floats stay 0
  const PronyCoefficients<float>* prony = nullptr;  ///< [isochoric + volumetric]
  int isochoric = 0, volumetric = 0;                ///< number of terms
  const Patch* next = nullptr;  ///< patch to fetch into the cache meanwhile; null: everything fits anyway
  bool advance = true;          ///< store the history
  LawFunction law = nullptr;    ///< of kernels that are not compiled for one law
};

/// Parameters and history of one tile of elements (and integration point).
struct MaterialTile {
  const float* parameters;
  float* history;  ///< [term][6][W]
  const Pass& pass;
};

}  // namespace glisson::patches
