#include <glisson/cpu/emulated_device.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/memory.hpp>

namespace glisson {
namespace detail {

GuardedHeap::GuardedHeap() : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {}

GuardedHeap::~GuardedHeap() {
  for (const Block& block : blocks_) munmap(block.pages, block.bytes + page_);
}

void* GuardedHeap::allocate(std::size_t count, std::size_t size) {
  if (count > (std::numeric_limits<std::size_t>::max() - 4 * page_) / size)
    throw Error(ErrorKind::device, "The emulated device has no memory for " + std::to_string(count) +
                                       " values of " + std::to_string(size) + " bytes. Use a coarser mesh.");
  const std::size_t used =
      std::max<std::size_t>((count * size + cache_line - 1) / cache_line * cache_line, cache_line);
  const std::size_t bytes = (used + page_ - 1) / page_ * page_;
  void* pages = mmap(nullptr, bytes + page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED)
    throw Error(ErrorKind::device, "The emulated device has no memory for " + std::to_string(bytes) +
                                       " bytes. Use a coarser mesh.");
  char* start = static_cast<char*>(pages);
  mprotect(start, bytes, PROT_READ | PROT_WRITE);
  std::memset(start, 0xff, bytes);
  if (open_ == 0) mprotect(start, bytes, PROT_NONE);
  blocks_.push_back({start, bytes, start + (bytes - used)});
  return blocks_.back().memory;
}

void GuardedHeap::release(void* memory) {
  const auto block =
      std::find_if(blocks_.begin(), blocks_.end(), [=](const Block& b) { return b.memory == memory; });
  if (block == blocks_.end()) return;
  munmap(block->pages, block->bytes + page_);
  blocks_.erase(block);
}

void GuardedHeap::make_constant(void* memory) {
  for (Block& block : blocks_)
    if (block.memory == memory) block.constant = true;
}

void GuardedHeap::protect(int access) {
  for (const Block& block : blocks_)
    mprotect(block.pages, block.bytes, block.constant ? access & ~PROT_WRITE : access);
}
void GuardedHeap::open() {
  if (open_++ == 0) protect(PROT_READ | PROT_WRITE);
}
void GuardedHeap::close() {
  if (--open_ == 0) protect(PROT_NONE);
}

void GuardedHeap::get_contents(std::vector<unsigned char>& contents) const {
  contents.clear();
  for (const Block& block : blocks_)
    if (!block.constant) contents.insert(contents.end(), block.pages, block.pages + block.bytes);
}
void GuardedHeap::set_contents(const std::vector<unsigned char>& contents) {
  const unsigned char* from = contents.data();
  for (const Block& block : blocks_)
    if (!block.constant) from += (std::memcpy(block.pages, from, block.bytes), block.bytes);
}

}  // namespace detail

std::vector<int> EmulatedDevice::random_order(int n) {
  std::vector<int> order(static_cast<std::size_t>(std::max(n, 0)));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    random_ = random_ * 6364136223846793005u +
              1442695040888963407u;  // Knuth's MMIX generator; the high bits are good
    std::swap(order[i - 1], order[(random_ >> 32) % i]);
  }
  return order;
}

void EmulatedDevice::refuse_conflicts(const std::vector<int>& order, const char* body,
                                      const std::function<void(int)>& run) {
  const auto half = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  const auto first = [&] { std::for_each(order.begin(), half, run); };
  const auto second = [&] { std::for_each(half, order.end(), run); };
  auto& [before, after_first, first_then_second, after_second, second_then_first] = seen_;
  heap_->get_contents(before);
  first();
  heap_->get_contents(after_first);
  second();
  heap_->get_contents(first_then_second);
  heap_->set_contents(before);
  second();
  heap_->get_contents(after_second);
  first();
  heap_->get_contents(second_then_first);
  bool independent = second_then_first == first_then_second;
  for (std::size_t k = 0; k < before.size() && independent; ++k)
    independent = after_first[k] == before[k] || after_second[k] == before[k];
  heap_->set_contents(before);
  if (!independent)
    throw Error(ErrorKind::device, "Two indices of the loop " + std::string(body) +
                                       " touch what one of them writes: on a device this is a race.");
}

}  // namespace glisson
