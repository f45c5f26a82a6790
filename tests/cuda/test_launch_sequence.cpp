// Which launches of several members become one.
#include <gtest/gtest.h>

#include <glisson/cuda/launch_sequence.hpp>
#include <tests/cuda/fake_backend.hpp>

namespace glisson::cuda {
namespace {

constexpr std::size_t plenty = 32764;

struct Add {
  int number;
  int* to;
  void operator()(int) const { *to += number; }
};
struct Double {
  int* to;
  void operator()(int) const { *to *= 2; }
};

/// As DeviceBackend::for_each adds it.
template <class F>
void add(LaunchSequence& sequence, int n, const F& body) {
  sequence.add(FakeKernels<3>::each<F>().pair, (n - 1) / 2 + 1, 2, 0, n, body);
}

/// Members of each launch after a merge, which is then run.
std::vector<int> merged(const std::vector<LaunchSequence>& members, std::size_t parameter_bytes = plenty) {
  std::vector<const LaunchSequence*> pointers;
  for (const auto& member : members) pointers.push_back(&member);
  LaunchSequence all;
  merge(pointers, parameter_bytes, all);
  std::vector<int> counts;
  for (const KernelCall& call : all.calls()) {
    counts.push_back(call.members);
    FakeNode(call).run();
  }
  return counts;
}

TEST(CudaMerge, LaunchesOfTheSameKernelAndSizesBecomeOneUpToWhatFits) {
  int numbers[7] = {};
  std::vector<LaunchSequence> members(7);
  for (int m = 0; m < 7; ++m) {
    auto& sequence = members[static_cast<std::size_t>(m)];
    add(sequence, 1, Add{m, &numbers[m]}), add(sequence, 1, Double{&numbers[m]});
  }
  EXPECT_EQ(merged(members), (std::vector{3, 3, 1, 3, 3, 1}));
  for (int m = 0; m < 7; ++m) EXPECT_EQ(numbers[m], 2 * m);
}

TEST(CudaMerge, OtherCountsAndKernelsStayApart) {
  int numbers[4] = {};
  std::vector<LaunchSequence> members(4);
  add(members[0], 3, Add{1, &numbers[0]});
  add(members[1], 4, Add{1, &numbers[1]});  // the same number of blocks
  add(members[2], 3, Double{&numbers[2]});
  add(members[3], 3, Add{2, &numbers[3]});
  EXPECT_EQ(merged(members), (std::vector{2, 1, 1}));
  EXPECT_EQ(numbers[0], 3);
  EXPECT_EQ(numbers[1], 4);
  EXPECT_EQ(numbers[3], 6);
}

/// A member with a step of its own kind, or with fewer steps, shares all others.
TEST(CudaMerge, StepsAreAligned) {
  int numbers[3] = {1, 1, 1};
  std::vector<LaunchSequence> members(3);
  for (int m = 0; m < 3; ++m) {
    auto& sequence = members[static_cast<std::size_t>(m)];
    for (int step = 0; step < (m == 2 ? 2 : 4); ++step) {
      add(sequence, 1, Add{1, &numbers[m]});
      if (m == 1 && step == 1) add(sequence, 1, Add{100, &numbers[m]});
      add(sequence, 1, Double{&numbers[m]});
      sequence.end_step();
    }
  }
  EXPECT_EQ(merged(members), (std::vector{3, 3, 2, 2, 1, 1, 1, 2, 2, 2, 2}));
  EXPECT_EQ(numbers[0], 46);
  EXPECT_EQ(numbers[1], 846);
  EXPECT_EQ(numbers[2], 10);
}

TEST(CudaMerge, NothingMergesWithoutATwinOrWhereItsParametersDoNotFit) {
  int numbers[2] = {};
  std::vector<LaunchSequence> members(2);
  for (int m = 0; m < 2; ++m) members[static_cast<std::size_t>(m)].add(add_kernel, 1, 1, 0, 1, &numbers[m]);
  EXPECT_EQ(merged(members), (std::vector{1, 1}));
  for (int m = 0; m < 2; ++m) {
    members[static_cast<std::size_t>(m)].clear();
    add(members[static_cast<std::size_t>(m)], 1, Add{1, &numbers[m]});
  }
  EXPECT_EQ(merged(members, 3 * sizeof(Add)), (std::vector{1, 1})) << "no room in front of the bodies";
  EXPECT_EQ(merged(members, 3 * sizeof(Add) + SeveralKernel::room_in_front), (std::vector{2}));
  EXPECT_EQ(numbers[0], 3);
}

}  // namespace
}  // namespace glisson::cuda
