// Between node rows (x y z w, 16 bytes) and packs with one element per lane.
#pragma once

#include <cstdint>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <glisson/core/tensor/tensor.hpp>
#include <glisson/cpu/simd/pack.hpp>

namespace glisson::patches {

typedef float Row __attribute__((vector_size(16), may_alias));

GLISSON_INLINE Row load_row(const float* row) { return *reinterpret_cast<const Row*>(row); }
GLISSON_INLINE void store_row(float* row, Row value) { *reinterpret_cast<Row*>(row) = value; }

/// In every group of four lanes: lanes A, B of a, then C, D of b.
template <int A, int B, int C, int D, int W, std::size_t... I>
GLISSON_INLINE Pack<W> shuffle_lanes(Pack<W> a, Pack<W> b, std::index_sequence<I...>) {
  constexpr int picks[4] = {A, B, C + W, D + W};
  return __builtin_shufflevector(a.v, b.v, (static_cast<int>(I / 4 * 4) + picks[I % 4])...);
}
template <int A, int B, int C, int D, int W>
GLISSON_INLINE Pack<W> shuffle_lanes(Pack<W> a, Pack<W> b) {
  return shuffle_lanes<A, B, C, D>(a, b, std::make_index_sequence<W>());
}
/// a0 b0 a1 b1 and a2 b2 a3 b3 of every four lanes.
template <int W, std::size_t... I>
GLISSON_INLINE Pack<W> interleave_low(Pack<W> a, Pack<W> b, std::index_sequence<I...>) {
  return __builtin_shufflevector(a.v, b.v, (static_cast<int>(I / 4 * 4 + I % 4 / 2 + I % 2 * W))...);
}
template <int W, std::size_t... I>
GLISSON_INLINE Pack<W> interleave_high(Pack<W> a, Pack<W> b, std::index_sequence<I...>) {
  return __builtin_shufflevector(a.v, b.v, (static_cast<int>(I / 4 * 4 + 2 + I % 4 / 2 + I % 2 * W))...);
}

/// Rows at offset[0], offset[4], offset[8], ... side by side. Intrinsics, because g++ 12 does not fold the
/// second load into the insertion otherwise.
template <int W>
GLISSON_INLINE Pack<W> load_rows(const float* rows, const std::uint16_t* offset) {
  if constexpr (W == 4) {
    return Pack<4>(load_row(rows + offset[0]));
  } else if constexpr (W == 8) {
    const Row low = load_row(rows + offset[0]), high = load_row(rows + offset[4]);
#if defined(__AVX__)
    return Pack<8>(_mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1));
#else
    return Pack<8>(__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7));
#endif
  } else {
    const Row r0 = load_row(rows + offset[0]), r1 = load_row(rows + offset[4]),
              r2 = load_row(rows + offset[8]), r3 = load_row(rows + offset[12]);
#if defined(__AVX512DQ__)
    const __m256 low = _mm256_insertf128_ps(_mm256_castps128_ps256(r0), r1, 1),
                 high = _mm256_insertf128_ps(_mm256_castps128_ps256(r2), r3, 1);
    return Pack<16>(_mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1));
#else
    const auto low = __builtin_shufflevector(r0, r1, 0, 1, 2, 3, 4, 5, 6, 7);
    const auto high = __builtin_shufflevector(r2, r3, 0, 1, 2, 3, 4, 5, 6, 7);
    return Pack<16>(__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
#endif
  }
}

/// x y z w of the nodes at rows + offset[lane], offset in floats.
template <int W>
GLISSON_INLINE Vec4<Pack<W>> load_nodes(const float* rows, const std::uint16_t* offset) {
  const auto lanes = std::make_index_sequence<W>();
  const Pack<W> r0 = load_rows<W>(rows, offset), r1 = load_rows<W>(rows, offset + 1),
                r2 = load_rows<W>(rows, offset + 2), r3 = load_rows<W>(rows, offset + 3);
  const Pack<W> xy01 = interleave_low(r0, r1, lanes), zw01 = interleave_high(r0, r1, lanes),
                xy23 = interleave_low(r2, r3, lanes), zw23 = interleave_high(r2, r3, lanes);
  return {shuffle_lanes<0, 1, 0, 1>(xy01, xy23), shuffle_lanes<2, 3, 2, 3>(xy01, xy23),
          shuffle_lanes<0, 1, 0, 1>(zw01, zw23), shuffle_lanes<2, 3, 2, 3>(zw01, zw23)};
}

/// W rows x y z 0; lane l becomes row_of_lane(l) of solids/patch.hpp.
template <int W>
GLISSON_INLINE void store_nodes(float* rows, const Vec3<Pack<W>>& a) {
  const auto lanes = std::make_index_sequence<W>();
  const Pack<W> zero(0), xy01 = interleave_low(a.x, a.y, lanes), xy23 = interleave_high(a.x, a.y, lanes),
                         z01 = interleave_low(a.z, zero, lanes), z23 = interleave_high(a.z, zero, lanes);
  shuffle_lanes<0, 1, 0, 1>(xy01, z01).store(rows);
  shuffle_lanes<2, 3, 2, 3>(xy01, z01).store(rows + W);
  shuffle_lanes<0, 1, 0, 1>(xy23, z23).store(rows + 2 * W);
  shuffle_lanes<2, 3, 2, 3>(xy23, z23).store(rows + 3 * W);
}

/// One number per lane in the same order as rows of store_nodes.
template <int W, std::size_t... I>
GLISSON_INLINE void store_scalars(float* values, Pack<W> a, std::index_sequence<I...>) {
  Pack<W>(__builtin_shufflevector(a.v, a.v, static_cast<int>(I % (W / 4) * 4 + I / (W / 4))...))
      .store(values);
}
template <int W>
GLISSON_INLINE void store_scalars(float* values, Pack<W> a) {
  store_scalars(values, a, std::make_index_sequence<W>());
}

}  // namespace glisson::patches
