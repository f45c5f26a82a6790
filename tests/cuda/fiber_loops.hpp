// Members of a group of the fake machine whose loops are functions on fibers.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <glisson/cpu/ensemble/fiber.hpp>
#include <glisson/cuda/device_group.hpp>
#include <tests/cuda/fake_backend.hpp>

namespace glisson::cuda {

class FiberLoop final : public GroupLoop {
 public:
  FiberLoop(DeviceGroup& group, std::function<void(FakeGpu&)> body)
      : fiber_([this, &group, &member = group.add(*this), body = std::move(body)] {
          try {
            FakeGpu gpu(group.device_of(member));
            body(gpu);
          } catch (const std::exception& failure) {
            error = failure.what();
          }
        }) {}
  void resume() override { fiber_.resume(); }
  void stand() override { fiber_.pause(); }
  bool inside() const override { return fiber_.inside(); }
  bool idle() const override { return fiber_.done(); }

  std::string error;

 private:
  Fiber fiber_;
};

/// One group with a loop per member.
struct FakeGroup {
  explicit FakeGroup(std::shared_ptr<ConstantArrays> constants = std::make_shared<ConstantArrays>())
      : group(fake_runtime, 0, std::move(constants)) {}
  DeviceGroup group;
  std::vector<std::unique_ptr<FiberLoop>> loops;

  void add(std::function<void(FakeGpu&)> body) {
    loops.push_back(std::make_unique<FiberLoop>(group, std::move(body)));
  }
};

}  // namespace glisson::cuda
