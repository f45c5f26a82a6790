// What each failure of the CUDA runtime means to a user, with a runtime that fails on demand: no GPU needed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include <glisson/core/base/error.hpp>
#include <glisson/cuda/device.hpp>

namespace glisson::cuda {
namespace {

/// A machine with two GPUs of ordinary memory. `code` is what the call named `fails` returns.
struct Fake {
  int devices = 2, code = 0, live_blocks = 0, live_streams = 0, current = -1;
  std::string fails;
};
Fake fake;

int fail_or(const char* call, int code = 0) { return fake.fails == call ? fake.code : code; }

const Runtime fake_runtime{
    [](int* count) {
      *count = fake.devices;
      return fail_or("device_count");
    },
    [](int, DeviceFacts* facts) {
      *facts = {"Fake 1", 8, 6, std::size_t{8} << 30};
      return fail_or("describe");
    },
    [](int device) {
      fake.current = device;
      return fail_or("select");
    },
    [] { return fail_or("check_kernels"); },
    [](void** stream) {
      *stream = &fake;
      ++fake.live_streams;
      return fail_or("create_stream");
    },
    [](void*) {
      --fake.live_streams;
      return 0;
    },
    [](void** memory, std::size_t bytes) {
      if (const int code = fail_or("allocate")) return code;
      *memory = std::malloc(bytes);
      std::memset(*memory, 0xff, bytes);
      ++fake.live_blocks;
      return 0;
    },
    [](void* memory) {
      std::free(memory);
      --fake.live_blocks;
      return 0;
    },
    [](std::size_t* available, std::size_t* total) {
      *available = std::size_t{100} << 20, *total = std::size_t{8} << 30;
      return fail_or("memory_info");
    },
    [](void* memory, std::size_t bytes, void*) {
      std::memset(memory, 0, bytes);
      return fail_or("clear");
    },
    [](const void* from, void* to, std::size_t bytes, void*) {
      std::memcpy(to, from, bytes);
      return fail_or("copy_in");
    },
    [](const void* from, void* to, std::size_t bytes, void*) {
      std::memcpy(to, from, bytes);
      return fail_or("copy_out");
    },
    [](void*) { return fail_or("wait"); },
    [] { return fail_or("launch_status"); },
    [](int) { return "as the runtime calls it"; },
};

class CudaDevice : public testing::Test {
 protected:
  void SetUp() override { fake = {}; }
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
  check("select", [&] { device.before_launch(); });
  check("launch_status", [&] { device.after_launch(); });
  check("allocate", [&] { device.allocate(8); });
  device.release(memory);
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
