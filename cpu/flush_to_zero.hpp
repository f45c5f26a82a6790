// Subnormal numbers as zeros. The front of a wave that enters a body at rest decays to them, and one
// operation with a subnormal number takes more than a hundred cycles: first steps took three to fifty times
// as long.
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace glisson::detail {

/// For this thread, until the end of the scope: subnormal operands and results count as zero.
class FlushToZero {
 public:
#if defined(__SSE__)
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }  // FTZ and DAZ
  ~FlushToZero() { _mm_setcsr(before_); }
#elif defined(__aarch64__)
  FlushToZero() {
    asm volatile("mrs %0, fpcr" : "=r"(before_));
    asm volatile("msr fpcr, %0" : : "r"(before_ | (1ull << 24)));  // FZ
  }
  ~FlushToZero() { asm volatile("msr fpcr, %0" : : "r"(before_)); }
#else
  FlushToZero() {}
#endif
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
#if defined(__aarch64__)
  unsigned long long before_ = 0;
#else
  unsigned before_ = 0;
#endif
};

}  // namespace glisson::detail
