// The kernel around the phases of core/kernels/patch_bodies.hpp: it adds shared memory and barriers, nothing
// else.
#pragma once

#include <type_traits>

#include <glisson/core/solids/law_kernels.hpp>
#include <glisson/cuda/solids/dispatch.cuh>

namespace glisson::detail {

/// Grid: patches. Block: Body::threads. Shared memory: PatchMemory<R>::size(stride) values.
template <class R, class Body>
__device__ void run_patch(const Body& body) {
  extern __shared__ double shared_memory[];
  R* memory = reinterpret_cast<R*>(shared_memory);
  const int p = static_cast<int>(blockIdx.x), t = static_cast<int>(threadIdx.x);
  body.load(p, t, memory);
  __syncthreads();
  body.evaluate(p, t, memory);
  __syncthreads();
  body.sum(p, t, memory);
}

template <class R, class Body>
__global__ void __launch_bounds__(Body::threads, 1) patch_kernel(Body body) {
  run_patch<R>(body);
}

/// Of several members, which are the second extent of the grid.
template <class R, class Body>
__global__ void __launch_bounds__(Body::threads, 1)
    several_patch_kernel(const __grid_constant__ cuda::Several<Body> bodies) {
  run_patch<R>(bodies.body[blockIdx.y]);
}

/// In double each member has launches of its own: twins double what there is to compile and to load.
template <class R, class Body>
cuda::TypedKernel<Body> patch_kernels() {
  if constexpr (std::is_same_v<R, float>)
    return cuda::with_twin<Body>(patch_kernel<R, Body>, several_patch_kernel<R, Body>);
  else
    return {reinterpret_cast<const void*>(patch_kernel<R, Body>)};
}

/// The phases of a patch as a function that launches them over all patches of a block.
struct LaunchPhases : PatchBodies {
  template <class R>
  using Function = PatchLaunch<R>;
  template <class R, class Body>
  static void of(Cuda& backend, const PatchView<R>& patches, const PatchStep<R>& step) {
    const std::size_t bytes = PatchMemory<R>::size(patches.stride) * sizeof(R);
    backend.launch(patches.patch_count, Body::threads, bytes, patch_kernels<R, Body>(),
                   Body{{patches, step}});
  }
};

}  // namespace glisson::detail
