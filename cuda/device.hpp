// One GPU: its memory, one stream, and what each failure of the runtime means to a user. Plain C++.
// A member of a group (cuda/device_group.hpp) has a Device too, which shares the stream of the group.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glisson/cuda/launch_queue.hpp>

namespace glisson::cuda {

/// The GPUs of this machine; empty without a driver or a device. Never throws for that.
std::vector<DeviceFacts> find_devices(const Runtime& runtime);

/// "cuda" or "cuda:N" to N. Throws Error(usage) for anything else.
int device_number(std::string_view name);

struct GroupMember;
class DeviceGroup;

/// Every call throws Error(device) that says what failed, why, and what to do. A device that was lost stays
/// lost: all later calls fail the same way. Usable from any thread, one at a time.
class Device {
 public:
  Device(const Runtime& runtime, int number);
  /// What a member of a group has for its device. Where it would send its queue or wait, it lets its loop
  /// stand until the group has done that for all.
  Device(DeviceGroup& group, GroupMember& member);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const DeviceFacts& facts() const { return facts_; }
  std::string named() const;  ///< "cuda:0 (NVIDIA H100)"
  void* stream() const { return stream_; }

  /// Zeroed; nullptr for 0 bytes.
  void* allocate(std::size_t bytes);
  void release(void* memory) noexcept;
  /// Memory with these bytes for reading only, which other members may have too; nullptr where there are
  /// none.
  void* share(const void* from, std::size_t bytes);
  void copy_in(const void* from, void* to, std::size_t bytes);
  void copy_out(const void* from, void* to, std::size_t bytes);
  /// Until everything that was launched is done.
  void wait();
  /// Puts a launch into the queue. It is sent with others, at the latest before a copy, a wait or a change of
  /// memory.
  template <class... Arguments>
  void launch(const KernelPair& kernel, int blocks, int threads, std::size_t shared_bytes,
              const Arguments&... arguments) {
    queue_.waiting().add(kernel, blocks, threads, shared_bytes, arguments...);
    if (queue_.size() >= most_waiting) send();
  }
  /// After each step of a simulation, so that what is sent together begins with a step: sends the queue if it
  /// is long enough to keep the device busy while the host fills it again.
  void step_done();

  /// Memory of the host that kernels reach, for a copy by a launch: members that copy at the same time share
  /// that launch and the wait for it. nullptr where an ordinary copy is better: no member, no whole words,
  /// or much to copy in. A place is good until the next wait(), which may come here.
  unsigned* place_to_copy_in(std::size_t bytes);
  unsigned* place_to_copy_out(std::size_t bytes);
  /// For any device, not only for members.
  unsigned* place_for_joint_copies(std::size_t bytes);

 private:
  friend class DeviceGroup;
  static constexpr std::size_t most_to_copy_in = 16 << 10, most_to_copy_out = 4 << 20;  ///< by launches
  static constexpr std::size_t enough_waiting = 48, most_waiting = 512;

  bool in_loop() const;
  unsigned* place_of(std::size_t bytes);
  void select();
  /// Makes this device the current one of the thread and sends what waits.
  void send();
  void check(int code, const char* doing) const {
    if (code != status::done) fail(code, doing);
  }
  [[noreturn]] void fail(int code, const char* doing) const;
  [[noreturn]] void fail_allocation(std::size_t bytes) const;

  const Runtime& runtime_;
  int number_;
  DeviceFacts facts_;
  void* stream_ = nullptr;
  LaunchQueue queue_;
  int late_ = status::done;  ///< of a failure where nothing could be thrown
  DeviceGroup* group_ = nullptr;
  GroupMember* member_ = nullptr;  ///< of the group
  std::byte* pinned_ = nullptr;    ///< for copies by launches
  std::size_t pinned_bytes_ = 0, pinned_used_ = 0;
};

}  // namespace glisson::cuda
