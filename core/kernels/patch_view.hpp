// A patch: consecutive elements of a block whose nodes are staged in fast memory that its threads share.
// Three phases with barriers between them: load the nodes, evaluate one element per thread, sum per node.
// What no element or law has a part in. Layouts: doc/developer/cuda-backend.md.
#pragma once

#include <cstdint>

#include <glisson/core/kernels/element_forces.hpp>
#include <glisson/core/kernels/shared_forces.hpp>

namespace glisson {

/// Rows of a patch: one force per element and corner.
constexpr int patch_rows = 1024;
/// Elements of a full patch, and threads, in whole warps: 256 tetrahedra or 128 hexahedra.
constexpr int patch_threads(int corners) { return patch_rows / corners / 32 * 32; }
/// Nodes of a patch at most: with seven values per node and three per row, 48 KiB in double, which every GPU
/// gives a block unasked. Elements in locality order stay far below.
constexpr int patch_node_limit = 416;

/// What the constants of elements follow from. Memory bounds these kernels, not arithmetic: a node's position
/// is read once per patch, the constants of a tetrahedron would be 40 bytes, those of a hexahedron 128.
template <class R>
struct RestView {
  const R* X = nullptr;  ///< from the middle of the patch [m]; null: not needed   [3][place_count]
  const R* hourglass =
      nullptr;  ///< H8: stiffness of rest_constants() [Pa]  [element_count], or with stride 0 one
  int place_count = 0, hourglass_stride = 0;
  bool at_centre = false;  ///< H8: with the gradient of the centre
};

/// The patches of one block of elements, in the backend's memory. A place is a node of a patch.
template <class R>
struct PatchView {
  /// Without nodes, f_element, volume_change and nodal_pressure; constants only where they are not formed
  /// from rest positions.
  BlockView<R> block;
  RestView<R> rest;
  const int* element_begin = nullptr;     ///< [patch_count + 1]
  const int* node_begin = nullptr;        ///< first place                                   [patch_count + 1]
  const int* interior_count = nullptr;    ///< the first places, which no other patch has    [patch_count]
  const int* node = nullptr;              ///< internal number                               [place_count]
  const int* slot = nullptr;              ///< where the sum of a shared node goes, else -1  [place_count]
  const int* shared = nullptr;            ///< number among the shared nodes, else -1        [place_count]
  const int* row_begin = nullptr;         ///< [place_count + 1]
  const std::uint16_t* row = nullptr;     ///< corner * threads + element of the patch       [rows of all]
  const std::uint16_t* corner = nullptr;  ///< place within the patch                [corner][element_count]
  Vec4<R>* slot_force = nullptr;          ///< [N]                                           [slot_count]
  R* slot_pressure = nullptr;             ///< T4ANP: parts of p V [J]                       [slot_count]
  R* nodal_pressure = nullptr;            ///< T4ANP, of nodes in one patch only [Pa]        [node_count]
  const R* inverse_volume = nullptr;      ///< T4ANP: of the elements around a node [1/m^3]  [node_count]
  const int* shared_begin = nullptr;  ///< first slot of a shared node                   [shared_count + 1]
  int patch_count = 0;
  int stride = 0;  ///< places of the largest patch, a multiple of 32 [-]
};

/// What one evaluation needs of the step.
template <class R>
struct PatchStep {
  const Vec4<R>* u = nullptr;  ///< [m]  [node_count]
  Vec4<R>* f = nullptr;        ///< [N]  [node_count]
  bool store = true;           ///< advance the Prony history
};

/// The memory that the threads of a patch share: u by axis, T4ANP's pressure, rest positions and rows by
/// axis.
template <class R>
struct PatchMemory {
  R* values;
  int stride;
  GLISSON_HD R* u(int axis) const { return values + axis * stride; }
  GLISSON_HD R* pressure() const { return values + 3 * stride; }
  GLISSON_HD R* rest(int axis) const { return values + (4 + axis) * stride; }
  GLISSON_HD R* rows(int axis) const { return values + 7 * stride + axis * patch_rows; }
  static constexpr std::size_t size(int stride) { return 7 * std::size_t(stride) + 3 * patch_rows; }
};

template <class R>
GLISSON_HD PatchMemory<R> patch_memory(const PatchView<R>& patches, R* values) {
  return {values, patches.stride};
}

/// First phase.
template <class R>
GLISSON_HD void load_nodes(const PatchView<R>& patches, const Vec4<R>* u, int p, int t, int threads,
                           const PatchMemory<R>& memory) {
  const int first = patches.node_begin[p], count = patches.node_begin[p + 1] - first;
  for (int i = t; i < count; i += threads) {
    const Vec4<R> w = u[patches.node[first + i]];
    memory.u(0)[i] = w.x, memory.u(1)[i] = w.y, memory.u(2)[i] = w.z;
  }
  if (!patches.rest.X) return;
  for (int axis = 0; axis < 3; ++axis) {
    const R* X = patches.rest.X + axis * std::size_t(patches.rest.place_count) + first;
    for (int i = t; i < count; i += threads) memory.rest(axis)[i] = X[i];
  }
}

/// For T4ANP: mean pressure of each place. The parts of a shared node are summed by every patch that has it,
/// in the order of the slots: no launch of its own.
template <class R>
GLISSON_HD void load_pressure(const PatchView<R>& patches, int p, int t, int threads,
                              const PatchMemory<R>& memory) {
  const int first = patches.node_begin[p], count = patches.node_begin[p + 1] - first;
  for (int i = t; i < count; i += threads) {
    const int n = patches.node[first + i], s = patches.shared[first + i];
    if (s < 0) {
      memory.pressure()[i] = patches.nodal_pressure[n];
      continue;
    }
    R sum = R(0);
    for (int k = patches.shared_begin[s]; k < patches.shared_begin[s + 1]; ++k)
      sum = sum + patches.slot_pressure[k];
    memory.pressure()[i] = sum * patches.inverse_volume[n];
  }
}

/// Third phase: f of nodes that only this patch has, slots of the others.
template <class R>
GLISSON_HD void sum_forces(const PatchView<R>& patches, Vec4<R>* f, int p, int t, int threads,
                           const PatchMemory<R>& memory) {
  const int first = patches.node_begin[p], count = patches.node_begin[p + 1] - first;
  const R *x = memory.rows(0), *y = memory.rows(1), *z = memory.rows(2);
  for (int i = t; i < count; i += threads) {
    Vec3<R> sum{R(0), R(0), R(0)};
    for (int k = patches.row_begin[first + i]; k < patches.row_begin[first + i + 1]; ++k) {
      const int r = patches.row[k];
      sum.x = sum.x + x[r], sum.y = sum.y + y[r], sum.z = sum.z + z[r];
    }
    if (i < patches.interior_count[p]) {
      Vec4<R>& to = f[patches.node[first + i]];
      to = {to.x + sum.x, to.y + sum.y, to.z + sum.z, to.w};
    } else {
      patches.slot_force[patches.slot[first + i]] = {sum.x, sum.y, sum.z, R(0)};
    }
  }
}

/// The same for T4ANP's p V, of which there is one per element: the first `threads` values of rows(0).
template <class R>
GLISSON_HD void sum_pressure(const PatchView<R>& patches, int p, int t, int threads,
                             const PatchMemory<R>& memory) {
  const int first = patches.node_begin[p], count = patches.node_begin[p + 1] - first;
  for (int i = t; i < count; i += threads) {
    R sum = R(0);
    for (int k = patches.row_begin[first + i]; k < patches.row_begin[first + i + 1]; ++k)
      sum = sum + memory.rows(0)[patches.row[k] % threads];
    const int n = patches.node[first + i];
    if (i < patches.interior_count[p])
      patches.nodal_pressure[n] = sum * patches.inverse_volume[n];
    else
      patches.slot_pressure[patches.slot[first + i]] = sum;
  }
}

/// Over the shared nodes, after all patches of all blocks: adds the slots of each in their order.
template <class R>
struct AddSharedForces {
  const int* nodes;  ///< internal number [shared_count]
  SharedForces<R> shared;
  Vec4<R>* f;  ///< [N]  [node_count]
  GLISSON_HD void operator()(int s) const { f[nodes[s]] = shared.add(s, f[nodes[s]]); }
};

}  // namespace glisson
