// A function with a stack of its own that can stop in the middle and go on later: what lets the unchanged
// time loop of each member wait until the forces of its whole group are computed at once.
#pragma once

#include <functional>
#include <memory>

namespace glisson {

class Fiber {
 public:
  /// Throws Error(run) when there is no memory for the stack. `body` must not throw.
  explicit Fiber(std::function<void()> body);
  /// The body must have returned, or nothing on its stack may need a destructor.
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  /// Runs the body until its next pause() or its end.
  void resume();
  /// Called by the body: back to who called resume().
  void pause();
  bool done() const;
  /// True while the body runs.
  bool inside() const;

 private:
  struct State;
  static void start(unsigned high, unsigned low);
  std::unique_ptr<State> state_;
};

}  // namespace glisson
