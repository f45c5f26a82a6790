// Kernel files force their helpers inline, so that no function of one instruction set is left for the linker
// to choose.
#pragma once

#ifdef GLISSON_ONE_INSTRUCTION_SET
// Nothing to choose, and what sanitizers check compiles three times faster in small functions.
#define GLISSON_INLINE inline
#define GLISSON_FLATTEN
#else
#define GLISSON_INLINE inline __attribute__((always_inline))
/// Everything that this function calls is compiled into it.
#define GLISSON_FLATTEN __attribute__((flatten))
#endif
