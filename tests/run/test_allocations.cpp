// Steps take no memory, but for the few that close an energy account or estimate the stable step again.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include <tests/run/everything.hpp>
#include <tests/support/cases.hpp>

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they bring their own operator new

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t bytes, std::size_t alignment) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  const std::size_t size = (bytes + alignment - 1) / alignment * alignment;
  if (void* memory = std::aligned_alloc(alignment, size > 0 ? size : alignment)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace glisson::test {
namespace {

TEST(Allocations, OfOrdinaryStepsAreNone) {
  for (const auto formulation : {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_full})
    for (const Case& c : all_cases) {
      if (std::string(c.device) == "emulated") continue;  // draws the order of each loop
      SCOPED_TRACE(std::string(name_of(formulation)) + " " + c.name);
      const Model model = everything(formulation);
      const auto simulation = simulate(model, c);
      simulation->step(3);
      const long before = allocations.load();
      simulation->step(15);
      EXPECT_EQ(allocations.load() - before, 0);
      simulation->velocity();
      EXPECT_GT(allocations.load(), before) << "nothing is counted";
    }
}

}  // namespace
}  // namespace glisson::test

#endif
