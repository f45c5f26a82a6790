// Members of a group: launches are shared, results, failures and copies are their own.
#include <gtest/gtest.h>

#include <random>

#include <glisson/core/base/error.hpp>
#include <tests/cuda/fiber_loops.hpp>

namespace glisson::cuda {
namespace {

using CudaDeviceGroup = FakeMachine;

struct MultiplyAdd {
  unsigned factor, number;
  unsigned* to;
  void operator()(int i) const { to[i] = to[i] * factor + number; }
};

/// A loop with a buffer whose content depends on the order of everything that was done to it; the same is
/// done to numbers of the host.
class Numbers {
 public:
  Numbers(FakeGpu& gpu, int count)
      : gpu_(gpu), buffer_(gpu.allocate<unsigned>(static_cast<std::size_t>(count))) {
    expected_.resize(static_cast<std::size_t>(count));
  }
  void step(unsigned factor, unsigned number) {
    gpu_.for_each(count(), MultiplyAdd{factor, number, buffer_.get()});
    gpu_.for_each(count(), MultiplyAdd{3, 1, buffer_.get()});
    for (unsigned& e : expected_) e = (e * factor + number) * 3 + 1;
    gpu_.step_done();
  }
  void put(unsigned number) {
    expected_.assign(expected_.size(), number);
    gpu_.copy_in(expected_.data(), buffer_.get(), expected_.size());
  }
  bool right() {
    std::vector<unsigned> got(expected_.size());
    gpu_.copy_out(buffer_.get(), got.data(), got.size());
    return got == expected_;
  }

 private:
  int count() const { return static_cast<int>(expected_.size()); }
  FakeGpu& gpu_;
  Buffer<unsigned> buffer_;
  std::vector<unsigned> expected_;
};

TEST_F(CudaDeviceGroup, StepsOfAllMembersAreSentTogetherAsGraphs) {
  FakeGroup members;
  std::vector<int> right(7);
  for (unsigned m = 0; m < 7; ++m)
    members.add([m, &right](FakeGpu& gpu) {
      Numbers numbers(gpu, 5);
      for (unsigned step = 0; step < 200; ++step) numbers.step(m, step);
      right[m] = numbers.right();
    });
  members.group.run();
  EXPECT_EQ(right, std::vector<int>(7, 1));
  EXPECT_EQ(fake.members, 7 * 401) << "each launch of each member, and its copy, once";
  EXPECT_EQ(fake.launches, 3 * 16 + 3) << "members 3 + 3 + 1; the first eight steps, and the copies";
  EXPECT_EQ(fake.graph_launches, 24);
  EXPECT_EQ(fake.waits, 1) << "for the copies of all";
}

/// Loops that share little: steps, copies of both kinds and memory at random times.
TEST_F(CudaDeviceGroup, MembersThatDoOtherThingsGetTheirOwnResults) {
  for (const bool pinned : {true, false}) {
    if (!pinned) fake.fails = "allocate_pinned", fake.code = status::out_of_memory;
    FakeGroup members;
    int wrong = 0, done = 0;
    for (unsigned m = 0; m < 11; ++m)
      members.add([m, &wrong, &done](FakeGpu& gpu) {
        std::mt19937 random(m / 2);  // pairs do the same
        for (int buffer = 0; buffer < 3; ++buffer) {
          Numbers numbers(gpu, buffer == 2 ? 20000 : 3 + static_cast<int>(random() % 3));
          for (int round = 0; round < 60; ++round) {
            const unsigned steps = random() % 12;
            for (unsigned step = 0; step < steps; ++step) numbers.step(m, random());
            if (random() % 3 == 0) numbers.put(random());
            if (random() % 2 == 0) wrong += !numbers.right();
            if (random() % 9 == 0) gpu.wait();
          }
          wrong += !numbers.right();
        }
        ++done;
      });
    members.group.run();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(done, 11);
    for (const auto& loop : members.loops) EXPECT_EQ(loop->error, "");
  }
}

TEST_F(CudaDeviceGroup, CopiesInTheLoopShareOneWait) {
  FakeGroup members;
  for (unsigned m = 0; m < 9; ++m)
    members.add([](FakeGpu& gpu) {
      Numbers numbers(gpu, 64);
      for (unsigned round = 0; round < 10; ++round) {
        numbers.put(round);
        numbers.step(2, round);
        EXPECT_TRUE(numbers.right());
      }
    });
  members.group.run();
  EXPECT_EQ(fake.waits, 10) << "one for each round of all members; copies to the device need none";
}

TEST_F(CudaDeviceGroup, AFailingMemberStopsAlone) {
  FakeGroup members;
  std::vector<int> right(5);
  for (unsigned m = 0; m < 5; ++m)
    members.add([m, &right](FakeGpu& gpu) {
      Numbers numbers(gpu, 8);
      for (unsigned step = 0; step < 50; ++step) {
        numbers.step(m, step);
        if (m == 2 && step == 20) throw Error(ErrorKind::run, "member 2 diverged");
      }
      right[m] = numbers.right();
    });
  members.group.run();
  EXPECT_EQ(right, (std::vector{1, 1, 0, 1, 1}));
  EXPECT_EQ(members.loops[2]->error, "member 2 diverged");
}

TEST_F(CudaDeviceGroup, ALostDeviceFailsAllMembersEachWithTheMessage) {
  for (const char* call : {"launch", "launch_graph", "wait"}) {
    fake.reset();
    {
      FakeGroup members;
      for (unsigned m = 0; m < 4; ++m)
        members.add([m, call](FakeGpu& gpu) {
          Numbers numbers(gpu, 8);
          for (unsigned step = 0; step < 100; ++step) {
            numbers.step(m, step);
            if (m == 1 && step == 60) fake.fails = call, fake.code = status::illegal_address;
          }
          numbers.right();
          ADD_FAILURE() << "went on after " << call;
        });
      members.group.run();
      for (const auto& loop : members.loops)
        EXPECT_NE(loop->error.find("lost to this process"), std::string::npos) << call << ": " << loop->error;
      fake.fails = "";
    }
  }
}

TEST_F(CudaDeviceGroup, ConstantsWithTheSameBytesAreOncePerDevice) {
  auto constants = std::make_shared<ConstantArrays>();
  std::vector<const int*> places;
  for (int g = 0; g < 2; ++g) {  // two groups of a device
    FakeGroup members(constants);
    for (int m = 0; m < 5; ++m)
      members.add([m, &places](FakeGpu& gpu) {
        std::vector<int> same(100, 7), own(100, m);
        const auto a = gpu.upload_constant(same.data(), 100), b = gpu.upload_constant(same.data(), 99),
                   c = gpu.upload_constant(own.data(), 100);
        places.push_back(a.get());
        EXPECT_NE(a.get(), b.get());
        EXPECT_EQ(c[99], m);
        EXPECT_EQ(b[98], 7);
        gpu.wait();
      });
    members.group.run();
    EXPECT_EQ(constants->bytes(), 0u) << "the last user frees";
  }
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(places[i], places[i / 5 * 5]);
}

/// After the run, what reads a member's memory does not stand, because nobody else runs.
TEST_F(CudaDeviceGroup, ADeviceWorksOutsideItsLoop) {
  FakeGroup members;
  struct Idle final : GroupLoop {
    void resume() override {}
    void stand() override { ADD_FAILURE(); }
    bool inside() const override { return false; }
    bool idle() const override { return true; }
  } loop;
  FakeGpu gpu(members.group.device_of(members.group.add(loop)));
  Numbers numbers(gpu, 8);
  for (unsigned step = 0; step < 30; ++step) numbers.step(3, step);
  EXPECT_TRUE(numbers.right());
}

}  // namespace
}  // namespace glisson::cuda
