// The only file that knows what a host-device function is.
#pragma once

#if defined(__CUDACC__)
#define GLISSON_HD __host__ __device__
#else
#define GLISSON_HD
#endif
