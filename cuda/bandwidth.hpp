// How fast the memory of a GPU is: the yardstick for bytes counted per element and step.
#pragma once

#include <cstddef>

namespace glisson::cuda {

/// Bytes read and written per second by a copy between two arrays of `bytes` each on device `number`, best of
/// ten. Below the size of the second-level cache (50 MB on large GPUs) it measures the cache. Only in builds
/// with CUDA.
double measure_copy_bandwidth(int number, std::size_t bytes);

}  // namespace glisson::cuda
