// Kernel files force their helpers inline, so that no function of one instruction set is left for the linker
// to choose.
#pragma once

#define GLISSON_INLINE inline __attribute__((always_inline))
/// Everything that this function calls is compiled into it.
#define GLISSON_FLATTEN __attribute__((flatten))
