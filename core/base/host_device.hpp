// The only file that knows what a host-device function is.
#pragma once

#if defined(__CUDACC__)
#define GLISSON_HD __host__ __device__
#else
#define GLISSON_HD
#endif

/// The same, compiled into its callers: for what kernels of packs call, where a call costs more than the
/// work.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define GLISSON_HD_INLINE inline __attribute__((always_inline))
#else
#define GLISSON_HD_INLINE inline GLISSON_HD
#endif

/// Before a loop of few turns over arrays that must stay in registers: compilers leave it a loop otherwise
/// when its body is long.
#if defined(__CUDACC__) || defined(__clang__)
#define GLISSON_UNROLL _Pragma("unroll")
#elif defined(__GNUC__)
#define GLISSON_UNROLL _Pragma("GCC unroll 8")
#else
#define GLISSON_UNROLL
#endif
