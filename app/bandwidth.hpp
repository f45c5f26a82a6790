// How fast this machine moves memory, measured: the yardstick of bench.
#pragma once

namespace glisson::app {

/// Best of several sweeps a = b + s c over arrays far larger than the caches, read and written bytes
/// [bytes/s].
double measured_bandwidth(int threads);

}  // namespace glisson::app
