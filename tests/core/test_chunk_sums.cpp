// Bodies with one sum per chunk: in lanes, as a device joins them, they leave what the loop leaves.
#include <gtest/gtest.h>

#include <vector>

#include <glisson/core/chunk_sums.hpp>

namespace glisson {
namespace {

/// Counts the visits of each entry and sums integers, which no order can change.
template <int size>
struct Visit {
  static constexpr int chunk = size;
  using Sum = long;
  int* visits;
  long* sums;
  int count;
  int entry_count() const { return count; }
  void add(int i, Sum& sum) const { ++visits[i], sum += 1000 + i; }
  static void join(Sum& a, const Sum& b) { a += b; }
  void leave(int c, const Sum& sum) const { sums[c] = sum; }
};

template <int size>
void expect_lanes_do_what_the_loop_does(int count) {
  const int chunks = (count + size - 1) / size;
  std::vector<int> visits[2];
  std::vector<long> sums[2];
  for (int k = 0; k < 2; ++k) {
    visits[k].resize(static_cast<std::size_t>(count)), sums[k].resize(static_cast<std::size_t>(chunks));
    const Visit<size> body{visits[k].data(), sums[k].data(), count};
    for (int c = 0; c < chunks; ++c)
      if (k == 0)
        run_chunk(body, c);
      else
        run_chunk_in_lanes(body, c);
    for (const int visited : visits[k]) EXPECT_EQ(visited, 1);
  }
  EXPECT_EQ(sums[0], sums[1]);
}

TEST(ChunkSums, LanesVisitEachEntryOnceAndLeaveTheSameSums) {
  for (const int count : {1, 15, 16, 17, 31, 64, 65, 200, 1000}) {
    expect_lanes_do_what_the_loop_does<16>(count);
    expect_lanes_do_what_the_loop_does<64>(count);
    expect_lanes_do_what_the_loop_does<256>(count);
  }
}

TEST(ChunkSums, ChunksAreSharedByAWarpAtMost) {
  EXPECT_EQ(chunk_lanes<Visit<16>>, 16);
  EXPECT_EQ(chunk_lanes<Visit<64>>, 32);
}

}  // namespace
}  // namespace glisson
