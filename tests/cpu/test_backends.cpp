// What every backend of the CPU promises.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/bandwidth.hpp>
#include <glisson/cpu/emulated_device.hpp>
#include <glisson/cpu/serial.hpp>
#include <glisson/cpu/threads.hpp>

namespace glisson {
namespace {

struct Twice {
  const int* from;
  int* to;
  void operator()(int i) const { to[i] = 2 * from[i]; }
};

template <class B>
class Backends : public testing::Test {
 public:
  B backend;
};
using AllBackends = testing::Types<Threads, EmulatedDevice>;
TYPED_TEST_SUITE(Backends, AllBackends);

TYPED_TEST(Backends, RunEveryBodyOnceAndCopyBothWays) {
  for (const int n : {0, 1, 63, 2047, 2048, 2049, 100000}) {
    const auto count = static_cast<std::size_t>(n);
    std::vector<int> numbers(count), result(count);
    std::iota(numbers.begin(), numbers.end(), 5);
    auto from = this->backend.template allocate<int>(count);
    auto to = this->backend.template allocate<int>(count);
    this->backend.copy_in(numbers.data(), from.get(), count);
    this->backend.for_each(n, Twice{from.get(), to.get()});
    this->backend.copy_out(to.get(), result.data(), count);
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(result[i], 2 * numbers[i]);
  }
}

TYPED_TEST(Backends, GiveAlignedMemory) {
  for (const std::size_t count : {1, 7, 1000, 3'000'000}) {
    const auto buffer = this->backend.template allocate<float>(count);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.get()) % 64, 0u);
  }
}

TYPED_TEST(Backends, RefuseMoreMemoryThanThereCanBe) {
  EXPECT_THROW(this->backend.template allocate<double>(~std::size_t{0} / 4), Error);
}

TEST(Threads, MemoryIsZero) {
  Threads threads(3);
  const auto buffer = threads.allocate<int>(1'000'003);
  for (std::size_t i = 0; i < 1'000'003; ++i) ASSERT_EQ(buffer[i], 0);
}

TEST(Threads, SharesCoverEverythingOnce) {
  for (const int n : {0, 1, 64, 65, 1000, 2'000'000'000})
    for (const int count : {1, 2, 3, 7}) {
      EXPECT_EQ(share_of(n, 0, count).first, 0);
      EXPECT_EQ(share_of(n, count - 1, count).last, n);
      for (int t = 1; t < count; ++t) EXPECT_EQ(share_of(n, t, count).first, share_of(n, t - 1, count).last);
    }
}

/// Lists of nodes are cut where the loops over all nodes are.
TEST(Threads, ListsAreCutAtTheNodesOfAThread) {
  const std::vector<int> nodes{0, 5, 63, 64, 64, 65, 200, 201, 500};
  for (const int threads : {1, 2, 3, 9}) {
    int next = 0;
    for (int t = 0; t < threads; ++t) {
      const Share own = share_of(501, t, threads);
      const Share share = listed_share(static_cast<int>(nodes.size()), t, threads, 501,
                                       [&](int i) { return nodes[static_cast<std::size_t>(i)]; });
      EXPECT_EQ(share.first, next);
      for (int i = share.first; i < share.last; ++i) {
        EXPECT_GE(nodes[static_cast<std::size_t>(i)], own.first);
        EXPECT_LT(nodes[static_cast<std::size_t>(i)], own.last);
      }
      next = share.last;
    }
    EXPECT_EQ(next, 9);
  }
}

/// Each call costs as much as its number says; the work before a cut is that of the threads before it.
TEST(Threads, WeighedSharesCoverEverythingOnceAndWeighTheSame) {
  for (const int n : {0, 1, 10, 1000}) {
    const auto work_before = [](int i) { return i * (i - 1) / 2; };
    for (const int count : {1, 2, 3, 7}) {
      int next = 0;
      for (int t = 0; t < count; ++t) {
        const Share share = weighed_share(n, t, count, work_before);
        EXPECT_EQ(share.first, next);
        EXPECT_NEAR(work_before(share.last) - work_before(share.first), double(work_before(n)) / count, n);
        next = share.last;
      }
      EXPECT_EQ(next, n);
    }
  }
}

/// x of the left and the right neighbour, as they were before the loop.
struct AddNeighbours {
  static constexpr int cost = 4;
  const unsigned* from;
  unsigned* to;
  int count;
  void operator()(int i) const {
    to[i] = 3 * from[i] + from[(i + 1) % count] + from[(i + count - 1) % count];
  }
};
struct WeighedNeighbours : AddNeighbours {
  int work_before(int i) const { return i < 100 ? 0 : i - 100; }
};

template <class B>
std::vector<unsigned> neighbours_added(B& backend, int count, bool at_once) {
  std::vector<unsigned> a(static_cast<std::size_t>(count)), b(a.size());
  std::iota(a.begin(), a.end(), 1u);
  const auto script = [&](auto&& loop) {
    for (int round = 0; round < 100; ++round) {
      loop(count, AddNeighbours{a.data(), b.data(), count});
      loop(count, WeighedNeighbours{{b.data(), a.data(), count}});
    }
  };
  if (at_once)
    run_loops(backend, 4LL * count, script);
  else
    script(LoopsOneByOne<B>{backend});
  return a;
}

/// Every loop sees all of the one before it, with the team in the loops and without.
TEST(Threads, LoopsAtOnceDoWhatTheyDoOneByOne) {
  Serial serial;
  for (const int count : {3, 700, 5000}) {
    const auto expected = neighbours_added(serial, count, true);
    for (const int size : {1, 2, 3, 5}) {
      Threads threads(size);
      EXPECT_EQ(neighbours_added(threads, count, true), expected) << size;
      EXPECT_EQ(neighbours_added(threads, count, false), expected) << size;
    }
  }
}

TEST(Threads, AScriptKnowsHowManyCallsRunAtATime) {
  for (const int size : {1, 3}) {
    Threads threads(size);
    std::atomic<int> wrong{0};
    run_loops(threads, 1'000'000, [&](auto&& loop) { wrong += loop.team_size != size; });
    EXPECT_EQ(wrong, 0);
  }
}

struct Half {
  const float* from;
  float* to;
  void operator()(int i) const { to[i] = 0.5f * from[i]; }
};

/// On every thread, in short and long loops, and the caller gets its own way of rounding back.
TEST(Threads, SubnormalNumbersCountAsZero) {
  constexpr float smallest = std::numeric_limits<float>::min();
  for (const int threads : {1, 2})
    for (const int n : {10, 5000}) {
      Threads backend(threads);
      const std::vector<float> from(static_cast<std::size_t>(n), smallest);
      std::vector<float> to(from.size(), 1.0f);
      backend.for_each(n, Half{from.data(), to.data()});
      EXPECT_EQ(std::count(to.begin(), to.end(), 0.0f), n);
      volatile float x = smallest;
      EXPECT_GT(0.5f * x, 0.0f);
    }
}

TEST(Threads, BandwidthIsMeasured) {
  Threads threads(2);
  const Bandwidth bandwidth = measure_bandwidth(threads, 1 << 20);
  EXPECT_GT(bandwidth.read, 1e8);  // any machine of this century
  EXPECT_GT(bandwidth.triad, 1e8);
}

TEST(Team, RefusesImpossibleSizes) {
  EXPECT_THROW(Team(-1), Error);
  EXPECT_THROW(Team(Team::max_size + 1), Error);
  EXPECT_GE(Team(0).size(), 1);
}

TEST(Team, BarrierSeparatesPhases) {
  for (const int size : {1, 2, 3, 5}) {
    Team team(size);
    std::vector<int> value(static_cast<std::size_t>(size));
    int wrong = 0;
    constexpr int rounds = 2000;
    team.run([&](int thread) {
      for (int round = 0; round < rounds; ++round) {
        value[static_cast<std::size_t>(thread)] = round;
        team.barrier();
        const int other = value[static_cast<std::size_t>((thread + 1) % size)];
        team.barrier();
        if (other != round && thread == 0) ++wrong;
      }
    });
    EXPECT_EQ(wrong, 0);
  }
}

TEST(Team, WakesAfterSleeping) {
  Team team(3);
  std::vector<int> runs(3, 0);
  for (int i = 0; i < 20; ++i) {
    team.run([&](int thread) { ++runs[static_cast<std::size_t>(thread)]; });
    const timespec while_they_fall_asleep{0, 1'000'000};
    nanosleep(&while_they_fall_asleep, nullptr);
  }
  for (int i = 0; i < 20000; ++i) team.run([&](int thread) { ++runs[static_cast<std::size_t>(thread)]; });
  for (const int r : runs) EXPECT_EQ(r, 20020);
}

TEST(EmulatedDevice, UnwrittenMemoryIsNaN) {
  EmulatedDevice device;
  const auto buffer = device.allocate<float>(10);
  float value = 0;
  device.copy_out(buffer.get() + 9, &value, 1);
  EXPECT_TRUE(std::isnan(value));
}

TEST(EmulatedDevice, OrderDependsOnTheSeed) {
  struct Append {
    int* next;
    int* order;
    void operator()(int i) const { order[(*next)++] = i; }
  };
  auto order_of = [](std::uint64_t seed) {
    EmulatedDevice device(seed);
    const auto next = device.allocate<int>(1), order = device.allocate<int>(100);
    const int zero = 0;
    device.copy_in(&zero, next.get(), 1);
    device.for_each(100, Append{next.get(), order.get()});
    std::vector<int> result(100);
    device.copy_out(order.get(), result.data(), 100);
    return result;
  };
  EXPECT_EQ(order_of(1), order_of(1));
  EXPECT_NE(order_of(1), order_of(2));
  auto sorted = order_of(1);
  std::sort(sorted.begin(), sorted.end());
  for (int i = 0; i < 100; ++i) EXPECT_EQ(sorted[static_cast<std::size_t>(i)], i);
}

/// Bodies of two indices that go wrong on a device, and one that does not.
struct WriteBoth {
  int* to;
  void operator()(int i) const { to[i / 2] = i; }
};
struct Count {
  int* to;
  void operator()(int) const { ++*to; }
};
struct ReadNext {
  int* to;
  void operator()(int i) const { to[i] = i == 7 ? i : to[i + 1] + i; }
};
/// Chunks of four entries, which keep to themselves if the number is 0.
struct SumChunks {
  static constexpr int chunk = 4;
  using Sum = int;
  int* to;
  int shift;
  int entry_count() const { return 8; }
  void add(int i, Sum& sum) const { to[i] = i, sum += to[i ^ shift]; }
  static void join(Sum& a, const Sum& b) { a += b; }
  void leave(int c, const Sum& sum) const { to[8 + c] = sum + 1; }
};

TEST(EmulatedDevice, RefusesConflictsOfIndicesAndEntries) {
  const auto conflicts_in = [](int n, auto body, bool look = true) {
    EmulatedDevice device;
    if (look) device.look_for_conflicts();
    const auto memory = device.allocate<int>(16);
    const std::vector<int> zero(16);
    device.copy_in(zero.data(), memory.get(), zero.size());
    body.to = memory.get();
    try {  // in every second loop both are in different halves
      for (int k = 0; k < 20; ++k) device.for_each(n, body);
    } catch (const Error&) {
      return true;
    }
    return false;
  };
  EXPECT_TRUE(conflicts_in(8, WriteBoth{}));
  EXPECT_TRUE(conflicts_in(8, Count{}));
  EXPECT_TRUE(conflicts_in(8, ReadNext{}));
  EXPECT_FALSE(conflicts_in(8, ReadNext{}, false));
  EXPECT_FALSE(conflicts_in(2, SumChunks{nullptr, 0}));
  EXPECT_TRUE(conflicts_in(2, SumChunks{nullptr, 1})) << "neighbours in a chunk";
  EXPECT_TRUE(conflicts_in(2, SumChunks{nullptr, 9})) << "what another chunk leaves";
}

TEST(EmulatedDevice, LookingForConflictsLeavesNoTrace) {
  EmulatedDevice device;
  device.look_for_conflicts();
  const auto memory = device.allocate<int>(2);
  const int start[2] = {1, 2};
  int result[2];
  device.copy_in(start, memory.get(), 2);
  device.for_each(2, Twice{memory.get(), memory.get()});
  device.copy_out(memory.get(), result, 2);
  EXPECT_EQ(result[0], 2);
  EXPECT_EQ(result[1], 4);
}

TEST(EmulatedDeviceDeathTest, StopsHostReadsAndReadsPastTheEnd) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EmulatedDevice device;
  const auto buffer = device.allocate<int>(16);
  const auto sum = device.allocate<int>(1);
  device.for_each(16, Twice{buffer.get(), buffer.get()});
  EXPECT_DEATH(
      {
        volatile int value = buffer[0];
        static_cast<void>(value);
      },
      "");
  EXPECT_DEATH(device.for_each(1, Twice{buffer.get() + 16, sum.get()}), "");
}

TEST(EmulatedDeviceDeathTest, StopsBodiesThatWriteConstants) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EmulatedDevice device;
  const int from[2] = {1, 2};
  const auto constant = upload_constant(device, from, 2);
  const auto to = device.allocate<int>(2);
  device.for_each(2, Twice{constant.get(), to.get()});
  int got[2] = {};
  device.copy_out(to.get(), got, 2);
  EXPECT_EQ(got[1], 4);
  EXPECT_DEATH(device.for_each(2, Twice{to.get(), constant.get()}), "");
}

}  // namespace
}  // namespace glisson
