// Members of an ensemble that share a device, a stream and one queue. Each runs its ordinary time loop until
// it would send its launches; when all stand there, launches of the same kernels and sizes become one launch
// with the members in blockIdx.y. Plain C++.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glisson/cuda/constant_arrays.hpp>
#include <glisson/cuda/device.hpp>

namespace glisson::cuda {

/// The time loop of a member as its group sees it: something that can stop in its middle and go on later.
class GroupLoop {
 public:
  virtual ~GroupLoop() = default;
  /// Runs until the loop stands or is idle.
  virtual void resume() = 0;
  /// Called by what runs inside: back to who called resume().
  virtual void stand() = 0;
  virtual bool inside() const = 0;
  /// Has nothing to do for now.
  virtual bool idle() const = 0;
};

struct GroupMember {
  GroupLoop& loop;
  LaunchSequence* waiting = nullptr;  ///< of its device, while there is one
  enum class State { free, stands, stands_to_wait, awaits } state = State::free;
  std::string failure{};  ///< of what the group did for it last
};

/// One caller at a time. It must outlive the devices of its members.
class DeviceGroup {
 public:
  /// Groups on one device may share their constant arrays.
  DeviceGroup(const Runtime& runtime, int number,
              std::shared_ptr<ConstantArrays> constants = std::make_shared<ConstantArrays>())
      : device_(runtime, number), constants_(std::move(constants)) {}

  /// The loop must outlive the group's last run().
  GroupMember& add(GroupLoop& loop);
  std::unique_ptr<Device> device_of(GroupMember& member) { return std::make_unique<Device>(*this, member); }
  /// Until all loops are idle. What fails is thrown in the loops of those whose launches it concerns.
  void run();

  const DeviceFacts& facts() const { return device_.facts(); }
  /// Launches at the end of a step that are enough to send: a member alone collects more (Device), but here
  /// each is that of many members, and their bytes should stay in the host's caches.
  static constexpr std::size_t enough_waiting = 16;

 private:
  friend class Device;
  /// Called by a member's device: returns when what waits has been sent and, with `to_wait`, is done.
  void stand(GroupMember& member, bool to_wait);
  void resume_free();
  void await();
  void send();
  template <class Act>
  void for_members(GroupMember::State state, Act&& act);

  Device device_;
  std::shared_ptr<ConstantArrays> constants_;
  std::vector<std::unique_ptr<GroupMember>> members_;
  std::vector<const LaunchSequence*> standing_;
};

}  // namespace glisson::cuda
