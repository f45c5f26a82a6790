// What each failure of the CUDA runtime means to a user, with a runtime that fails on demand: no GPU needed.
#include <gtest/gtest.h>

#include <string>

#include <glisson/core/base/error.hpp>
#include <glisson/cuda/device.hpp>
#include <tests/cuda/fake_runtime.hpp>

namespace glisson::cuda {
namespace {

class CudaDevice : public FakeMachine {
 protected:
  static void let_fail(const char* call, int code) { fake.fails = call, fake.code = code; }
};

/// The text of the Error(device) that `act` throws.
template <class F>
std::string message(F&& act, ErrorKind kind = ErrorKind::device) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

void expect_words(const std::string& text, std::initializer_list<const char*> words) {
  for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

void open() { Device device(fake_runtime, 0); }

TEST_F(CudaDevice, MemoryIsZeroedCopiedAndFreed) {
  {
    Device device(fake_runtime, 1);
    EXPECT_EQ(fake.current, 1);
    auto* memory = static_cast<int*>(device.allocate(3 * sizeof(int)));
    EXPECT_EQ(memory[0] | memory[1] | memory[2], 0);
    const int from[3] = {1, 2, 3};
    int to[3] = {};
    device.copy_in(from, memory, sizeof from);
    device.copy_out(memory, to, sizeof to);
    EXPECT_EQ(to[2], 3);
    device.release(memory);
    EXPECT_EQ(device.allocate(0), nullptr);
    device.release(nullptr);
  }
  EXPECT_EQ(fake.live_blocks, 0);
  EXPECT_EQ(fake.live_streams, 0);
}

TEST_F(CudaDevice, SaysWhatIsMissing) {
  fake.devices = 0;
  expect_words(message(open), {"no CUDA device", "--device cpu"});
  fake.devices = 2;
  let_fail("device_count", status::old_driver);
  expect_words(message(open), {"no NVIDIA driver", "--device cpu", "35"});
  fake.fails = "";
  expect_words(message([] { Device device(fake_runtime, 2); }), {"cuda:2", "has 2", "cuda:0 to cuda:1"});
}

TEST_F(CudaDevice, SaysHowToBuildForAnotherArchitecture) {
  for (const int code : {status::no_kernel_image, status::unsupported_ptx}) {
    let_fail("check_kernels", code);
    expect_words(message(open), {"Fake 1", "8.6", "-DGLISSON_CUDA_ARCHITECTURES=86"});
  }
}

TEST_F(CudaDevice, NamesSizeAskedAndAvailable) {
  Device device(fake_runtime, 0);
  let_fail("allocate", status::out_of_memory);
  expect_words(message([&] { device.allocate(std::size_t{200} << 20); }),
               {"cuda:0 (Fake 1)", "200 MiB", "100 MiB of 8192 MiB", "--precision single"});
  let_fail("clear", status::launch_failure);
  message([&] { device.allocate(8); });
  EXPECT_EQ(fake.live_blocks, 0) << "memory that could not be cleared stays allocated";
}

TEST_F(CudaDevice, EveryCallReportsALostDevice) {
  Device device(fake_runtime, 0);
  int value = 0;
  auto* memory = device.allocate(sizeof value);
  const auto check = [&](const char* call, auto&& act) {
    let_fail(call, status::illegal_address);
    expect_words(message(act), {"cuda:0", "lost", "--resume", "700"});
    fake.fails = "";
  };
  check("copy_in", [&] { device.copy_in(&value, memory, sizeof value); });
  check("copy_out", [&] { device.copy_out(memory, &value, sizeof value); });
  check("wait", [&] { device.wait(); });
  check("select", [&] { device.wait(); });
  check("allocate", [&] { device.allocate(8); });
  const auto launch = [&] { device.launch(add_kernel, 1, 1, 0, 1, static_cast<int*>(memory)); };
  check("launch", [&] { launch(), device.wait(); });
  launch();
  let_fail("launch", status::illegal_address);
  device.release(memory);
  fake.fails = "";
  expect_words(message([&] { device.wait(); }), {"launching a kernel", "lost"});
}

TEST_F(CudaDevice, UncorrectableMemoryIsNotAResult) {
  Device device(fake_runtime, 0);
  let_fail("wait", status::ecc_error);
  expect_words(message([&] { device.wait(); }), {"could not be corrected"});
}

TEST_F(CudaDevice, FindsNoneWithoutADriver) {
  EXPECT_EQ(find_devices(fake_runtime).size(), 2u);
  let_fail("device_count", status::old_driver);
  EXPECT_TRUE(find_devices(fake_runtime).empty());
}

TEST_F(CudaDevice, Names) {
  EXPECT_EQ(device_number("cuda"), 0);
  EXPECT_EQ(device_number("cuda:0"), 0);
  EXPECT_EQ(device_number("cuda:13"), 13);
  for (const char* name : {"cuda:", "cuda:-1", "cuda:1x", "cuda:99999999999", "cuda1", "gpu", ""})
    message([&] { device_number(name); }, ErrorKind::usage);
}

}  // namespace
}  // namespace glisson::cuda
