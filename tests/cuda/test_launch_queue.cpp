// What is sent together does the same as what is sent one by one: with a runtime whose kernels are functions
// of the host.
#include <gtest/gtest.h>

#include <random>

#include <glisson/core/base/error.hpp>
#include <glisson/cuda/device.hpp>
#include <tests/cuda/fake_runtime.hpp>

namespace glisson::cuda {
namespace {

using CudaLaunchQueue = FakeMachine;

/// Adds and multiplies, so that the order matters, and keeps the number that must come out.
struct Work {
  Device& device;
  int* number;
  unsigned expected = 0;

  void add(int k) { device.launch(add_kernel, 1, 1, 0, k, number), expected += static_cast<unsigned>(k); }
  void multiply(int k, int blocks = 1) {
    device.launch(multiply_kernel, blocks, 1, 0, k, number), expected *= static_cast<unsigned>(k);
  }
  /// Like a step: one launch that changes with k and some that do not.
  void step(int k, int same = 4) {
    add(k);
    for (int i = 0; i < same; ++i) multiply(3);
    device.step_done();
  }
  void check() {
    device.wait();
    EXPECT_EQ(static_cast<unsigned>(*number), expected);
  }
};

TEST_F(CudaLaunchQueue, StepsBecomeOneGraphWhereOnlyWhatChangesIsReplaced) {
  int number = 0;
  Device device(fake_runtime, 0);
  Work work{device, &number};
  for (int k = 0; k < 100; ++k) work.step(k);  // 10 steps are 50 launches
  EXPECT_EQ(fake.launches, 50) << "the first ten steps go one by one";
  EXPECT_EQ(fake.live_graphs, 1);
  EXPECT_EQ(fake.graph_launches, 9);
  EXPECT_EQ(fake.replaced, 80) << "one launch of each step in eight graphs of ten steps";
  work.check();
}

TEST_F(CudaLaunchQueue, ShortSequencesAreSentOneByOne) {
  int number = 0;
  Device device(fake_runtime, 0);
  Work work{device, &number};
  for (int k = 0; k < 10; ++k) work.step(k, 2), work.check();
  EXPECT_EQ(fake.launches, 30);
  EXPECT_EQ(fake.graph_launches, 0);
}

TEST_F(CudaLaunchQueue, NothingIsLostWithoutStepsOrBeforeACopy) {
  int number = 0, copy = 0;
  Device device(fake_runtime, 0);
  Work work{device, &number};
  for (int k = 0; k < 600; ++k) work.add(1);
  EXPECT_EQ(number, 512);
  device.copy_out(&number, &copy, sizeof copy);
  EXPECT_EQ(copy, 600);
  work.multiply(2);
  device.copy_in(&copy, &number, sizeof copy);
  EXPECT_EQ(number, 600) << "the launch came before the copy";
  auto* memory = static_cast<int*>(device.allocate(sizeof(int)));
  device.launch(add_kernel, 1, 1, 0, 1, memory);
  device.release(memory);
}

/// Sequences of random lengths that come again and again with other numbers, more kinds than are kept.
TEST_F(CudaLaunchQueue, RandomSequencesInAnyOrderGiveTheSame) {
  int number = 0;
  {
    Device device(fake_runtime, 0);
    Work work{device, &number};
    std::mt19937 random(5);
    for (int round = 0; round < 5000; ++round) {
      const int kind = round % 3 == 0 ? static_cast<int>(random() % 60) : static_cast<int>(random() % 5);
      std::mt19937 shape(static_cast<unsigned>(kind));
      for (int i = 0, n = 5 + static_cast<int>(shape() % 20); i < n; ++i) {
        const int k = random() % 4 == 0 ? static_cast<int>(random() % 7) : 3;
        if (shape() % 2)
          work.add(k);
        else
          work.multiply(k, 1 + static_cast<int>(shape() % 2));
      }
      work.check();
    }
    EXPECT_LE(fake.live_graphs, static_cast<int>(LaunchQueue::most_graphs));
    EXPECT_GT(fake.graph_launches, 3000);
  }
}

TEST_F(CudaLaunchQueue, WorksWithoutGraphsWhereTheRuntimeCannotMakeOrChangeThem) {
  for (const auto& [call, launches] : {std::pair{"make_graph", 500}, std::pair{"replace_in_graph", 450}}) {
    fake.reset();
    int number = 0;
    Device device(fake_runtime, 0);
    fake.fails = call, fake.code = status::out_of_memory;
    Work work{device, &number};
    for (int k = 0; k < 100; ++k) work.step(k);
    work.check();
    EXPECT_EQ(fake.launches, launches) << call;
  }
}

TEST_F(CudaLaunchQueue, FailuresOfGraphsAreReported) {
  int number = 0;
  Device device(fake_runtime, 0);
  Work work{device, &number};
  for (int k = 0; k < 20; ++k) work.step(k);
  fake.fails = "launch_graph", fake.code = status::launch_failure;
  EXPECT_THROW(
      {
        for (int k = 0; k < 20; ++k) work.step(k);
        device.wait();
      },
      Error);
}

}  // namespace
}  // namespace glisson::cuda
