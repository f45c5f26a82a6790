// A CUDA runtime without a GPU, which fails on demand and whose kernels are functions of the host.
#pragma once

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glisson/cuda/runtime.hpp>

namespace glisson::cuda {

/// A machine with two GPUs of ordinary memory. `code` is what the call named `fails` returns.
struct Fake {
  using Count = std::atomic<int>;  // groups run on threads of their own
  int devices = 2, code = 0;
  std::size_t parameter_bytes = 32764;
  bool computes = true;  ///< else launches do nothing
  Count live_blocks = 0, live_streams = 0, live_pinned = 0, live_graphs = 0, current = -1;
  Count launches = 0, graph_launches = 0, replaced = 0, members = 0;  ///< members: of all launches
  Count waits = 0;  ///< of the host for the stream, as copies from and to ordinary memory do too
  std::string fails;

  void reset() {
    devices = 2, code = 0, parameter_bytes = 32764, computes = true;
    for (Count* count : {&live_blocks, &live_streams, &live_pinned, &live_graphs, &launches, &graph_launches,
                         &replaced, &waits, &members})
      *count = 0;
    current = -1;
    fails = "";
  }
};
inline Fake fake;

inline int fail_or(const char* call, int code = 0) { return fake.fails == call ? fake.code : code; }

/// A kernel of the fake machine: what KernelCall::kernel points to.
struct FakeKernel {
  void (*run)(const KernelCall& call);
  std::vector<std::size_t> argument_bytes;
};
inline const FakeKernel add_to{[](const KernelCall& call) {
                                 **static_cast<int**>(call.arguments[1]) +=
                                     *static_cast<int*>(call.arguments[0]);
                               },
                               {sizeof(int), sizeof(int*)}};
inline const FakeKernel multiply_by{
    [](const KernelCall& call) {
      int& number = **static_cast<int**>(call.arguments[1]);
      number = static_cast<int>(static_cast<unsigned>(number) * *static_cast<unsigned*>(call.arguments[0]));
    },
    {sizeof(int), sizeof(int*)}};
inline const void* const add_kernel = &add_to;
inline const void* const multiply_kernel = &multiply_by;

/// A call with copies of its arguments, as a graph keeps it.
class FakeNode {
 public:
  explicit FakeNode(const KernelCall& call) : call_(call) {
    const auto& bytes = static_cast<const FakeKernel*>(call.kernel)->argument_bytes;
    for (std::size_t a = 0; a < bytes.size(); ++a) {
      arguments_.emplace_back(bytes[a] / sizeof(Unit) + 1);
      std::memcpy(arguments_.back().data(), call.arguments[a], bytes[a]);
    }
  }
  void run() {
    std::vector<void*> pointers;
    for (auto& argument : arguments_) pointers.push_back(argument.data());
    call_.arguments = pointers.data();
    fake.members += call_.members;
    if (fake.computes) static_cast<const FakeKernel*>(call_.kernel)->run(call_);
  }

 private:
  struct alignas(32) Unit {
    std::byte bytes[32];
  };
  KernelCall call_;
  std::vector<std::vector<Unit>> arguments_;
};
using FakeGraph = std::vector<FakeNode>;

inline const Runtime fake_runtime{
    [](int* count) {
      *count = fake.devices;
      return fail_or("device_count");
    },
    [](int, DeviceFacts* facts) {
      *facts = {"Fake 1", 8, 6, std::size_t{8} << 30, fake.parameter_bytes};
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
    [](void** memory, std::size_t bytes) {
      if (const int code = fail_or("allocate_pinned")) return code;
      *memory = std::calloc(1, bytes);
      ++fake.live_pinned;
      return 0;
    },
    [](void* memory) {
      std::free(memory);
      --fake.live_pinned;
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
      ++fake.waits;
      return fail_or("copy_in");
    },
    [](const void* from, void* to, std::size_t bytes, void*) {
      std::memcpy(to, from, bytes);
      ++fake.waits;
      return fail_or("copy_out");
    },
    [](void*) {
      ++fake.waits;
      return fail_or("wait");
    },
    [](const KernelCall& call, void*) {
      ++fake.launches;
      if (const int code = fail_or("launch")) return code;
      FakeNode(call).run();
      return 0;
    },
    [] { return fail_or("launch_status"); },
    [](void** graph, const KernelCall* calls, int count) {
      if (const int code = fail_or("make_graph")) return code;
      ++fake.live_graphs;
      *graph = new FakeGraph(calls, calls + count);
      return 0;
    },
    [](void* graph, int k, const KernelCall& call) {
      if (const int code = fail_or("replace_in_graph")) return code;
      ++fake.replaced;
      static_cast<FakeGraph*>(graph)->at(static_cast<std::size_t>(k)) = FakeNode(call);
      return 0;
    },
    [](void* graph, void*) {
      ++fake.graph_launches;
      if (const int code = fail_or("launch_graph")) return code;
      for (FakeNode& node : *static_cast<FakeGraph*>(graph)) node.run();
      return 0;
    },
    [](void* graph) {
      --fake.live_graphs;
      delete static_cast<FakeGraph*>(graph);
    },
    [](int) { return "as the runtime calls it"; },
};

/// A test that starts with a machine like new and must leave nothing on it.
class FakeMachine : public testing::Test {
 protected:
  void SetUp() override { fake.reset(); }
  void TearDown() override {
    EXPECT_EQ(fake.live_graphs, 0);
    EXPECT_EQ(fake.live_streams, 0);
    EXPECT_EQ(fake.live_blocks, 0);
    EXPECT_EQ(fake.live_pinned, 0);
  }
};

}  // namespace glisson::cuda
