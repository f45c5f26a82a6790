// A CUDA runtime without a GPU, which fails on demand and whose kernels are functions of the host.
#pragma once

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <glisson/cuda/runtime.hpp>

namespace glisson::cuda {

/// A machine with two GPUs of ordinary memory. `code` is what the call named `fails` returns.
struct Fake {
  int devices = 2, code = 0, live_blocks = 0, live_streams = 0, current = -1;
  int live_graphs = 0, launches = 0, graph_launches = 0, replaced = 0;
  std::string fails;
};
inline Fake fake;

inline int fail_or(const char* call, int code = 0) { return fake.fails == call ? fake.code : code; }

/// A kernel of the fake machine gets its arguments as the runtime gets them. This one adds to a number.
using FakeKernel = void (*)(void** arguments);
inline void add_to(void** arguments) {
  **static_cast<int**>(arguments[1]) += *static_cast<int*>(arguments[0]);
}
inline void multiply_by(void** arguments) {
  int& number = **static_cast<int**>(arguments[1]);
  number = static_cast<int>(static_cast<unsigned>(number) * *static_cast<unsigned*>(arguments[0]));
}
inline const void* const add_kernel = reinterpret_cast<const void*>(add_to);
inline const void* const multiply_kernel = reinterpret_cast<const void*>(multiply_by);

/// A call with copies of its two arguments.
struct FakeNode {
  const void* kernel = nullptr;
  int number = 0;
  int* target = nullptr;

  explicit FakeNode(const KernelCall& call)
      : kernel(call.kernel),
        number(*static_cast<int*>(call.arguments[0])),
        target(*static_cast<int**>(call.arguments[1])) {}
  void run() {
    void* arguments[2] = {&number, &target};
    reinterpret_cast<FakeKernel>(const_cast<void*>(kernel))(arguments);
  }
};
using FakeGraph = std::vector<FakeNode>;

inline const Runtime fake_runtime{
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

}  // namespace glisson::cuda
