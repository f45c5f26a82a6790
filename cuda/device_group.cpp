#include <glisson/cuda/device_group.hpp>

#include <utility>

#include <glisson/core/base/error.hpp>

namespace glisson::cuda {

using State = GroupMember::State;

GroupMember& DeviceGroup::add(GroupLoop& loop) {
  members_.push_back(std::make_unique<GroupMember>(loop));
  return *members_.back();
}

void DeviceGroup::stand(GroupMember& member, bool to_wait) {
  member.state = to_wait ? State::stands_to_wait : State::stands;
  member.loop.stand();
  if (!member.failure.empty()) throw Error(ErrorKind::device, std::exchange(member.failure, {}));
}

template <class Act>
void DeviceGroup::for_members(State state, Act&& act) {
  for (const auto& member : members_)
    if (member->state == state) act(*member);
}

/// Who waits for nothing goes on while the device works, only then the others are waited for.
void DeviceGroup::run() {
  while (true) {
    resume_free();
    await();
    bool any = false;
    for (const auto& member : members_) any = any || member->state != State::free;
    if (!any) return;
    send();
  }
}

void DeviceGroup::resume_free() {
  for_members(State::free, [](GroupMember& member) {
    if (!member.loop.idle()) member.loop.resume();
  });
}

void DeviceGroup::await() {
  bool any = false;
  for_members(State::awaits, [&](GroupMember&) { any = true; });
  if (!any) return;
  std::string failure;
  try {
    device_.wait();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  for_members(State::awaits, [&](GroupMember& member) {
    member.state = State::free;
    member.failure = failure;
    member.loop.resume();
  });
}

void DeviceGroup::send() {
  standing_.clear();
  std::string failure;
  for (const auto& member : members_)
    if (member->state == State::stands || member->state == State::stands_to_wait)
      standing_.push_back(member->waiting);
  try {
    merge(standing_, device_.facts().parameter_bytes, device_.queue_.waiting());
    device_.send();
  } catch (const std::exception& error) {
    failure = error.what();
    device_.queue_.waiting().clear();
  }
  for (const auto& member : members_) {
    if (member->state != State::stands && member->state != State::stands_to_wait) continue;
    const bool goes_on = member->state == State::stands || !failure.empty();
    member->state = goes_on ? State::free : State::awaits;
    member->failure = failure;
    member->waiting->clear();
  }
}

}  // namespace glisson::cuda
