#include <glisson/cpu/ensemble/fiber.hpp>

#include <bit>
#include <cstdint>

#include <sys/mman.h>
#include <ucontext.h>
#include <unistd.h>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/ensemble/stack_switch.hpp>

namespace glisson {
namespace {

/// Only touched pages cost memory; the lowest page is never accessible, so an overflow stops the process.
constexpr std::size_t stack_bytes = 1 << 20;

void* make_stack() {
  void* stack = mmap(nullptr, stack_bytes, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
  if (stack == MAP_FAILED)
    throw Error(ErrorKind::run, "There is no memory for one more member. Use fewer members in one ensemble.");
  mprotect(stack, static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), PROT_NONE);
  return stack;
}

}  // namespace

struct Fiber::State {
  std::function<void()> body;
  void* stack = make_stack();
  detail::StackSwitch stacks{stack, stack_bytes};
  ucontext_t own{}, caller{};
  bool done = false, inside = false;
};

void Fiber::start(unsigned high, unsigned low) {
  auto* state = std::bit_cast<State*>((static_cast<std::uintptr_t>(high) << 32) | low);
  state->stacks.enter();
  state->body();
  state->done = true;
  state->inside = false;
  state->stacks.leave(true);
  swapcontext(&state->own, &state->caller);
}

Fiber::Fiber(std::function<void()> body) : state_(std::make_unique<State>()) {
  state_->body = std::move(body);
  getcontext(&state_->own);
  state_->own.uc_stack.ss_sp = state_->stack;
  state_->own.uc_stack.ss_size = stack_bytes;
  const auto address = reinterpret_cast<std::uintptr_t>(state_.get());
  makecontext(&state_->own, reinterpret_cast<void (*)()>(&Fiber::start), 2,
              static_cast<unsigned>(address >> 32), static_cast<unsigned>(address));
}

Fiber::~Fiber() {
  void* stack = state_->stack;
  state_.reset();
  munmap(stack, stack_bytes);
}

void Fiber::resume() {
  if (state_->done) return;
  state_->inside = true;
  state_->stacks.leave_caller();
  swapcontext(&state_->caller, &state_->own);
  state_->stacks.return_to_caller();
}

void Fiber::pause() {
  state_->inside = false;
  state_->stacks.leave(false);
  swapcontext(&state_->own, &state_->caller);
  state_->stacks.enter();
}

bool Fiber::done() const { return state_->done; }
bool Fiber::inside() const { return state_->inside; }

}  // namespace glisson
