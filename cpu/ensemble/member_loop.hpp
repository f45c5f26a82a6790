// The ordinary time loop of one member of an ensemble on a fiber: it is set up there and advanced there, and
// can pause anywhere in between.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <glisson/core/ensemble/any_ensemble.hpp>
#include <glisson/cpu/ensemble/fiber.hpp>

namespace glisson {

class MemberLoop {
 public:
  using Make = std::function<std::unique_ptr<AnySimulation>()>;
  /// `make` is called on the fiber, at the first resume().
  explicit MemberLoop(Make make) : make_(std::move(make)), fiber_([this] { run(); }) {}
  ~MemberLoop();

  void set_wish(std::int64_t steps) {
    left_ = steps;
    if (steps > 0) idle_ = false;
  }
  /// Runs until the member pauses or has done what was wished.
  void resume();
  bool idle() const { return idle_ || fiber_.done(); }
  Fiber& fiber() { return fiber_; }
  const Fiber& fiber() const { return fiber_; }
  AnySimulation* simulation() const { return simulation_.get(); }  ///< nullptr if it could not be set up
  const std::string& error() const { return error_; }
  MemberStatus status() const;

 private:
  void run();

  Make make_;
  std::unique_ptr<AnySimulation> simulation_;
  std::string error_;
  std::int64_t left_ = 0;
  bool idle_ = false, closing_ = false;
  Fiber fiber_;  // last: its body uses the others
};

}  // namespace glisson
