// Loop bodies that stand for a chunk of entries each and leave one sum per chunk: energies, work, extents.
// On one core a chunk is a loop; on a device its entries are spread over the lanes of a warp, whose sums are
// joined in a fixed tree, so that a chunk is not one thread's loop through memory.
#pragma once

#include <concepts>

#include <glisson/core/base/host_device.hpp>

namespace glisson {

/// Chunks of `size` that hold `count` entries.
constexpr int chunks_of(int count, int size) { return (count + size - 1) / size; }

/// add(i, sum) does entry i and adds what it leaves to `sum`; join(a, b) adds b to a; leave(c, sum) stores
/// the sum of chunk c. A Sum{} is empty. Entries are independent of each other.
template <class F>
concept SumsChunks = requires(const F& body, int i, typename F::Sum& sum, const typename F::Sum& other) {
  { F::chunk } -> std::convertible_to<int>;
  { body.entry_count() } -> std::convertible_to<int>;
  { body.add(i, sum) } -> std::same_as<void>;
  { F::join(sum, other) } -> std::same_as<void>;
  { body.leave(i, other) } -> std::same_as<void>;
};

/// Lanes that share a chunk, a power of two.
template <class F>
constexpr int chunk_lanes = F::chunk < 32 ? F::chunk : 32;

/// Entries first, first + stride, ... of chunk c.
template <class F>
GLISSON_HD typename F::Sum sum_of_entries(const F& body, int c, int first, int stride) {
  static_assert((chunk_lanes<F> & (chunk_lanes<F> - 1)) == 0);
  const int count = body.entry_count(), end = count < (c + 1) * F::chunk ? count : (c + 1) * F::chunk;
  typename F::Sum sum{};
  for (int i = c * F::chunk + first; i < end; i += stride) body.add(i, sum);
  return sum;
}

/// The whole chunk in order, as bodies do in operator().
template <class F>
GLISSON_HD void run_chunk(const F& body, int c) {
  body.leave(c, sum_of_entries(body, c, 0, 1));
}

/// The chunk as a device does it, for tests: what the kernel with lanes is compared with.
template <SumsChunks F>
void run_chunk_in_lanes(const F& body, int c) {
  constexpr int lanes = chunk_lanes<F>;
  typename F::Sum sums[lanes];
  for (int lane = 0; lane < lanes; ++lane) sums[lane] = sum_of_entries(body, c, lane, lanes);
  for (int step = lanes / 2; step > 0; step /= 2)
    for (int lane = 0; lane < step; ++lane) F::join(sums[lane], sums[lane + step]);
  body.leave(c, sums[0]);
}

}  // namespace glisson
