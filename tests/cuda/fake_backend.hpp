// A backend around the fake runtime whose kernels are loops on the host: what a GPU would compute, through
// the same queues, graphs and groups.
#pragma once

#include <glisson/cuda/device_backend.hpp>
#include <tests/cuda/fake_runtime.hpp>

namespace glisson::cuda {

template <class F>
void run_body(const F& body, int i) {
  if constexpr (SumsChunks<F>)
    run_chunk_in_lanes(body, i);
  else
    body(i);
}

template <class F>
inline const FakeKernel each_kernel{[](const KernelCall& call) {
                                      const int n = *static_cast<int*>(call.arguments[0]);
                                      const F body = *static_cast<F*>(call.arguments[1]);
                                      for (int i = 0; i < n; ++i) run_body(body, i);
                                    },
                                    {sizeof(int), sizeof(F)}};

template <class F, int capacity>
inline const FakeKernel several_each_kernel{[](const KernelCall& call) {
                                              const int n = *static_cast<int*>(call.arguments[0]);
                                              const F* bodies = static_cast<F*>(call.arguments[1]);
                                              for (int m = 0; m < call.members; ++m)
                                                for (int i = 0; i < n; ++i) run_body(bodies[m], i);
                                            },
                                            {sizeof(int), capacity * sizeof(F)}};

template <int capacity>
struct FakeKernels {
  template <class F>
  static TypedKernel<int, F> each() {
    static const SeveralKernel twin{&several_each_kernel<F, capacity>, sizeof(F), capacity};
    return {{&each_kernel<F>, &twin}};
  }
  template <class F>
  static TypedKernel<int, F> chunks() {
    return each<F>();
  }
};

/// Three members in one launch, so that more come soon.
using FakeGpu = DeviceBackend<FakeKernels<3>>;
static_assert(Backend<FakeGpu>);

}  // namespace glisson::cuda
