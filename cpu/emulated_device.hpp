// A backend that treats memory as a GPU does, so that mistakes with it are found on any machine. For tests;
// slow.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <new>
#include <typeinfo>
#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/chunk_sums.hpp>

namespace glisson {
namespace detail {

/// Blocks of pages that nobody can touch unless the heap is open; a page that stays closed follows each
/// block, so that reading past the end stops at once. New memory is filled with 0xff bytes: NaN as float or
/// double, -1 as integer.
class GuardedHeap {
 public:
  GuardedHeap();
  ~GuardedHeap();
  GuardedHeap(const GuardedHeap&) = delete;
  GuardedHeap& operator=(const GuardedHeap&) = delete;

  void* allocate(std::size_t count, std::size_t size);
  void release(void* memory);
  /// Nobody may write there any more.
  void make_constant(void* memory);
  void open();
  void close();
  /// What all blocks hold that may be written, one after the other, while the heap is open.
  void get_contents(std::vector<unsigned char>& contents) const;
  void set_contents(const std::vector<unsigned char>& contents);

 private:
  struct Block {
    char* pages;        ///< start of the mapping
    std::size_t bytes;  ///< that open and close [bytes]; a guard page follows
    void* memory;       ///< given out; ends where the guard page starts, up to alignment
    bool constant = false;
  };
  void protect(int access);

  std::vector<Block> blocks_;
  std::size_t page_;
  int open_ = 0;
};

/// The heap is accessible while this lives.
class HeapAccess {
 public:
  explicit HeapAccess(GuardedHeap& heap) : heap_(heap) { heap_.open(); }
  ~HeapAccess() { heap_.close(); }
  HeapAccess(const HeapAccess&) = delete;
  HeapAccess& operator=(const HeapAccess&) = delete;

 private:
  GuardedHeap& heap_;
};

}  // namespace detail

/// Host code that reads device memory stops with SIGSEGV, as do bodies that write constants, memory that
/// nobody wrote reads as NaN, and bodies run in a random order, so that sums that depend on the order differ
/// between seeds. A barrier that is missing inside a kernel is a conflict of two indices where each phase is
/// a loop, see look_for_conflicts().
class EmulatedDevice {
 public:
  static constexpr Space space = Space::device;

  explicit EmulatedDevice(std::uint64_t seed = 1)
      : heap_(std::make_unique<detail::GuardedHeap>()), random_(seed) {}

  template <class T>
  Buffer<T> allocate(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    auto release = [](void* heap, T* memory, std::size_t) {
      static_cast<detail::GuardedHeap*>(heap)->release(memory);
    };
    return Buffer<T>(static_cast<T*>(heap_->allocate(count, sizeof(T))), {release, heap_.get(), count});
  }
  template <class T>
  void copy_in(const T* from, T* to, std::size_t count) {
    if (count == 0) return;  // an empty array may have no address
    const detail::HeapAccess access(*heap_);
    std::memcpy(static_cast<void*>(to), from, count * sizeof(T));
  }
  template <class T>
  void copy_out(const T* from, T* to, std::size_t count) {
    copy_in(from, to, count);
  }
  template <class T>
  Buffer<T> upload_constant(const T* from, std::size_t count) {
    auto buffer = allocate<T>(count);
    copy_in(from, buffer.get(), count);
    heap_->make_constant(buffer.get());
    return buffer;
  }
  template <class F>
  void for_each(int n, F body) {
    static_assert(std::is_trivially_copyable_v<F>, "what travels to a device is plain data");
    const std::vector<int> order = random_order(n);
    const detail::HeapAccess access(*heap_);
    const auto run = [&](int i) {
      if constexpr (SumsChunks<F>)
        run_chunk_in_lanes(body, i);
      else
        body(i);
    };
    if (looks_for_conflicts_) {
      if constexpr (SumsChunks<F>) {
        const auto sums = allocate<typename F::Sum>(static_cast<std::size_t>(body.entry_count()));
        refuse_conflicts(random_order(body.entry_count()), typeid(F).name(),
                         [&](int i) { body.add(i, *::new (&sums[i]) typename F::Sum{}); });
      }
      refuse_conflicts(order, typeid(F).name(), run);
    }
    for (const int i : order) run(i);
  }
  /// From now on loops throw Error(device) in which an index writes what another one reads or writes, in
  /// chunks also an entry. Each loop runs three times for that, with a comparison of all memory: for small
  /// models. Two indices are in different halves of a loop in every second run of it, so that what happens in
  /// each step is found in a few.
  void look_for_conflicts() { looks_for_conflicts_ = true; }
  void* stream() { return nullptr; }

 private:
  std::vector<int> random_order(int n);
  /// Runs both halves of a random order from the same memory, and each after the other. Leaves no trace.
  void refuse_conflicts(const std::vector<int>& order, const char* body, const std::function<void(int)>& run);

  std::unique_ptr<detail::GuardedHeap>
      heap_;  // on the heap: buffers point to it and must survive a move of the device
  std::uint64_t random_;
  bool looks_for_conflicts_ = false;
  std::array<std::vector<unsigned char>, 5> seen_;  ///< scratch of refuse_conflicts
};

static_assert(Backend<EmulatedDevice>);

}  // namespace glisson
