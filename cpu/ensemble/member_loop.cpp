#include <glisson/cpu/ensemble/member_loop.hpp>

#include <exception>
#include <utility>

namespace glisson {

/// Leaves nothing on the fiber's stack.
MemberLoop::~MemberLoop() {
  closing_ = true;
  while (!fiber_.done()) fiber_.resume();
}

void MemberLoop::resume() {
  idle_ = false;
  fiber_.resume();
}

MemberStatus MemberLoop::status() const {
  if (!error_.empty()) return MemberStatus::failed;
  return simulation_ && simulation_->finished() ? MemberStatus::finished : MemberStatus::running;
}

void MemberLoop::run() {
  if (closing_) return;
  try {
    simulation_ = make_();
    while (!closing_ && !simulation_->finished()) {
      if (left_ > 0) {
        simulation_->step(std::exchange(left_, 0));
      } else {
        idle_ = true;
        fiber_.pause();
      }
    }
  } catch (const std::exception& failure) {
    error_ = failure.what();
  }
  idle_ = true;
}

}  // namespace glisson
