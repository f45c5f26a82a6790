// What AddressSanitizer and ThreadSanitizer must be told when a thread goes on on another stack; empty in
// ordinary builds. Only for fiber.cpp.
#pragma once

#include <cstddef>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define GLISSON_FIBERS_ASAN
#endif
#if __has_feature(thread_sanitizer)
#define GLISSON_FIBERS_TSAN
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define GLISSON_FIBERS_ASAN
#endif
#if defined(__SANITIZE_THREAD__)
#define GLISSON_FIBERS_TSAN
#endif

#if defined(GLISSON_FIBERS_ASAN)
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#endif
#if defined(GLISSON_FIBERS_TSAN)
#include <sanitizer/tsan_interface.h>
#endif

namespace glisson::detail {

/// One per fiber. Its functions are called directly before and after the switch. They must be inlined:
/// ThreadSanitizer keeps a call stack per fiber, and a function entered on one must not be left on the other.
class StackSwitch {
 public:
  StackSwitch([[maybe_unused]] void* stack, [[maybe_unused]] std::size_t bytes) {
#if defined(GLISSON_FIBERS_ASAN)
    stack_ = stack, bytes_ = bytes;
#endif
#if defined(GLISSON_FIBERS_TSAN)
    own_ = __tsan_create_fiber(0);
#endif
  }
  ~StackSwitch() {
#if defined(GLISSON_FIBERS_ASAN)
    __asan_unpoison_memory_region(stack_, bytes_);  // the pages may become anything
#endif
#if defined(GLISSON_FIBERS_TSAN)
    __tsan_destroy_fiber(own_);
#endif
  }
  StackSwitch(const StackSwitch&) = delete;
  StackSwitch& operator=(const StackSwitch&) = delete;

  /// On the caller's stack.
  [[gnu::always_inline]] void leave_caller() {
#if defined(GLISSON_FIBERS_ASAN)
    __sanitizer_start_switch_fiber(&caller_frames_, stack_, bytes_);
#endif
#if defined(GLISSON_FIBERS_TSAN)
    caller_ = __tsan_get_current_fiber();
    __tsan_switch_to_fiber(own_, 0);
#endif
  }
  [[gnu::always_inline]] void return_to_caller() {
#if defined(GLISSON_FIBERS_ASAN)
    __sanitizer_finish_switch_fiber(caller_frames_, nullptr, nullptr);
#endif
  }
  /// On the fiber's stack. The caller's may be that of another thread than last time.
  [[gnu::always_inline]] void enter() {
#if defined(GLISSON_FIBERS_ASAN)
    __sanitizer_finish_switch_fiber(own_frames_, &caller_stack_, &caller_bytes_);
#endif
  }
  [[gnu::always_inline]] void leave([[maybe_unused]] bool for_ever) {
#if defined(GLISSON_FIBERS_ASAN)
    __sanitizer_start_switch_fiber(for_ever ? nullptr : &own_frames_, caller_stack_, caller_bytes_);
#endif
#if defined(GLISSON_FIBERS_TSAN)
    __tsan_switch_to_fiber(caller_, 0);
#endif
  }

 private:
#if defined(GLISSON_FIBERS_ASAN)
  void *stack_ = nullptr, *own_frames_ = nullptr, *caller_frames_ = nullptr;
  const void* caller_stack_ = nullptr;
  std::size_t bytes_ = 0, caller_bytes_ = 0;
#endif
#if defined(GLISSON_FIBERS_TSAN)
  void *own_ = nullptr, *caller_ = nullptr;
#endif
};

}  // namespace glisson::detail
