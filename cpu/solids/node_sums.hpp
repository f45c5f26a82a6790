// From nodes to a patch and back: what no element or law has a part in.
#pragma once

#include <glisson/cpu/simd/nodes.hpp>
#include <glisson/cpu/solids/patch.hpp>

namespace glisson::patches {

/// Lists of the next patch (from its nodes up to its constants, which the element kernel fetches) and the
/// rows they name. The hardware cannot guess the rows, and gives up a stream at each page and patch.
template <int W>
GLISSON_INLINE void prefetch_next(const Pass& pass) {
  if (!pass.next) return;
  const Patch& next = *pass.next;
  for (auto* line = reinterpret_cast<const char*>(next.run);
       line < reinterpret_cast<const char*>(next.parameters); line += 64)
    __builtin_prefetch(line, 0, 2);
  for (int i = 0; i < next.node_count; ++i)
    __builtin_prefetch(pass.u + 4 * static_cast<std::size_t>(next.node[i]), 0, 2);
  for (int i = 0; i < next.interior_count; ++i)
    __builtin_prefetch(pass.f + 4 * static_cast<std::size_t>(next.node[i]), 1, 2);
}

/// W only separates the instruction sets.
template <int W>
void load_displacements(const Patch& patch, const Pass& pass) {
  for (int i = 0; i < patch.node_count; ++i)
    store_row(pass.local_rows + 4 * i, load_row(pass.u + 4 * static_cast<std::size_t>(patch.node[i])));
  prefetch_next<W>(pass);
}

template <int W>
void load_pressures(const Patch& patch, const Pass& pass) {
  for (int i = 0; i < patch.node_count; ++i) pass.local_rows[4 * i + 3] = pass.pressure[patch.node[i]];
}

/// sum(first row of a node, its number of rows) must give the sum; write(local node, sum) gets it, in order.
template <int W, class Sum, class Write>
GLISSON_INLINE void over_runs(const Patch& patch, int first, int last, const std::uint16_t*& row, int& node,
                              Sum&& sum, Write&& write) {
  for (int r = first; r < last; ++r) {
    const int rows = patch.run[r].rows;
    for (int end = node + patch.run[r].nodes; node < end; ++node, row += rows) write(node, sum(row, rows));
  }
}

template <int W>
void sum_forces(const Patch& patch, const Pass& pass) {
  const float* from = pass.force_rows;
  auto sum = [=](const std::uint16_t* row, int rows) __attribute__((always_inline)) {
    Row a = load_row(from + row[0]), b = load_row(from + row[1]);
    for (int k = 2; k < rows; k += 2) {
      a += load_row(from + row[k]);
      b += load_row(from + row[k + 1]);
    }
    return a + b;
  };
  const std::uint16_t* row = patch.row;
  int node = 0;
  over_runs<W>(
      patch, 0, patch.interior_runs, row, node, sum, [&](int i, Row value) __attribute__((always_inline)) {
        float* f = pass.f + 4 * static_cast<std::size_t>(patch.node[i]);
        store_row(f, load_row(f) + value);
      });
  float* slot = pass.slot_force +
                4 * (static_cast<std::size_t>(patch.slot) - static_cast<std::size_t>(patch.interior_count));
  over_runs<W>(
      patch, patch.interior_runs, patch.runs, row, node,
      sum, [&](int i, Row value) __attribute__((always_inline)) { store_row(slot + 4 * i, value); });
}

template <int W>
void sum_pressures(const Patch& patch, const Pass& pass) {
  const float* from =
      pass.force_rows + 12;  // row r of four floats, r >= 4, is number r of these; number 0 is 0
  auto sum = [=](const std::uint16_t* row, int rows) __attribute__((always_inline)) {
    float a = 0;
    for (int k = 0; k < rows; ++k) a += from[row[k] / 4];
    return a;
  };
  const std::uint16_t* row = patch.row;
  int node = 0;
  over_runs<W>(
      patch, 0, patch.interior_runs, row, node, sum, [&](int i, float value) __attribute__((always_inline)) {
        pass.pressure[patch.node[i]] = value * pass.pressure_weight[patch.node[i]];
      });
  float* slot = pass.slot_pressure + (patch.slot - patch.interior_count);
  over_runs<W>(
      patch, patch.interior_runs, patch.runs, row, node,
      sum, [&](int i, float value) __attribute__((always_inline)) { slot[i] = value; });
}

}  // namespace glisson::patches
