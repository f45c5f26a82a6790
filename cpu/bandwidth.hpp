// How fast this machine's memory is with a team of threads: the yardstick for bytes counted per element and
// step.
#pragma once

#include <cstddef>

#include <glisson/cpu/threads.hpp>

namespace glisson {

struct Bandwidth {
  double read = 0;   ///< sum of an array [bytes/s]
  double triad = 0;  ///< a = b + s c, 12 bytes per number, without the read of a that caches add [bytes/s]
};

/// Best of a few passes over arrays of `bytes` each. Below the size of the caches it measures the caches.
/// Takes about 12 passes: 64 MiB and 40 GB/s are 50 ms.
Bandwidth measure_bandwidth(Threads& threads, std::size_t bytes);

}  // namespace glisson
