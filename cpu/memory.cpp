#include <glisson/cpu/memory.hpp>

#include <cstdlib>
#include <limits>
#include <string>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <glisson/core/base/error.hpp>

namespace glisson::detail {
namespace {

// Below a few huge pages the saved table walks do not matter, and rounding would cost memory.
constexpr std::size_t huge_page = std::size_t{2} << 20, huge_from = 4 * huge_page;

[[noreturn]] void fail(std::size_t count, std::size_t size) {
  throw Error(ErrorKind::run, "No memory for " + std::to_string(count) + " values of " +
                                  std::to_string(size) +
                                  " bytes: the model is too large for this machine. Use a coarser mesh.");
}

}  // namespace

void* allocate_untouched(std::size_t count, std::size_t size) {
  if (count > (std::numeric_limits<std::size_t>::max() - huge_page) / size) fail(count, size);
  const std::size_t bytes = (count * size + cache_line) / cache_line * cache_line;
  void* memory = nullptr;
  if (posix_memalign(&memory, bytes >= huge_from ? huge_page : cache_line, bytes) != 0) fail(count, size);
#if defined(__linux__)
  if (bytes >= huge_from) madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: failure only costs speed
#endif
  return memory;
}

void release_untouched(void* memory) noexcept { std::free(memory); }

}  // namespace glisson::detail
