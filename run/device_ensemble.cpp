#include <algorithm>
#include <exception>
#include <numeric>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/ensemble/lane_solids.hpp>
#include <glisson/cpu/ensemble/member_loop.hpp>
#include <glisson/cpu/team.hpp>
#include <glisson/run/ensembles.hpp>

namespace glisson::detail {
namespace {

/// A time loop on a fiber, as the group on the device wants it.
class Member final : public cuda::GroupLoop {
 public:
  Member(cuda::DeviceGroup& group, const Model& model, const GroupDevice& device)
      : loop_([&group, &model, &device, &place = group.add(*this)] {
          return device.make(model, group.device_of(place));
        }) {}

  MemberLoop& loop() { return loop_; }
  const MemberLoop& loop() const { return loop_; }
  void resume() override { loop_.resume(); }
  void stand() override { loop_.fiber().pause(); }
  bool inside() const override { return loop_.fiber().inside(); }
  bool idle() const override { return loop_.idle(); }

 private:
  MemberLoop loop_;
};

class DeviceEnsemble final : public AnyEnsemble {
 public:
  DeviceEnsemble(std::vector<Model> models, int threads, GroupDevice device)
      : models_(std::move(models)), device_(std::move(device)), team_(group_count(models_.size(), threads)) {
    make_groups();
    step(0);
  }

  int member_count() const override { return static_cast<int>(models_.size()); }
  /// A thread for every group.
  void step(std::int64_t count) override {
    for (auto& member : members_) member->loop().set_wish(count);
    std::vector<std::exception_ptr> failures(groups_.size());
    team_.run([&](int g) {
      const auto i = static_cast<std::size_t>(g);
      try {
        groups_[i]->run();
      } catch (...) {
        failures[i] = std::current_exception();
      }
    });
    for (const auto& failure : failures)
      if (failure) std::rethrow_exception(failure);
  }
  MemberStatus status(int k) const override { return loop(k).status(); }
  const std::string& error(int k) const override { return loop(k).error(); }
  AnySimulation& member(int k) override {
    AnySimulation* simulation = loop(k).simulation();
    if (!simulation) throw Error(ErrorKind::run, error(k));
    return *simulation;
  }
  std::string device() const override {
    const auto any = std::find_if(members_.begin(), members_.end(),
                                  [](const auto& member) { return member->loop().simulation() != nullptr; });
    const std::size_t most = (models_.size() + groups_.size() - 1) / groups_.size();
    return "Ensemble, up to " + std::to_string(most) + " members share launches on " +
           (any == members_.end() ? "nothing" : (*any)->loop().simulation()->device());
  }
  std::size_t memory_bytes() const override {
    std::size_t bytes = 0;
    for (const auto& member : members_)
      if (const auto* simulation = member->loop().simulation()) bytes += simulation->memory_bytes();
    return bytes;
  }

 private:
  /// A group costs a stream and a thread that sends; one with few members cannot fill a launch.
  static int group_count(std::size_t members, int threads) {
    constexpr std::size_t fewest = 32;
    return static_cast<int>(
        std::clamp<std::size_t>(members / fewest, 1, static_cast<std::size_t>(std::max(1, threads))));
  }
  /// Members whose kernels are the same stand side by side.
  void make_groups() {
    std::vector<std::string> keys;
    for (const Model& model : models_) keys.push_back(lanes::group_key(model));
    std::vector<std::size_t> order(models_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    members_.resize(models_.size());
    for (int g = 0; g < team_.size(); ++g) {
      groups_.push_back(device_.open());
      const auto [first, last] = share_of(member_count(), g, team_.size(), 1);
      for (int i = first; i < last; ++i) {
        const std::size_t k = order[static_cast<std::size_t>(i)];
        members_[k] = std::make_unique<Member>(*groups_.back(), models_[k], device_);
      }
    }
  }
  const MemberLoop& loop(int k) const { return members_.at(static_cast<std::size_t>(k))->loop(); }

  std::vector<Model> models_;
  GroupDevice device_;
  Team team_;
  std::vector<std::unique_ptr<cuda::DeviceGroup>> groups_;
  std::vector<std::unique_ptr<Member>> members_;  // after the groups: their devices are those of a group
};

}  // namespace

std::unique_ptr<AnyEnsemble> device_ensemble(std::vector<Model> members, int threads, GroupDevice device) {
  return std::make_unique<DeviceEnsemble>(std::move(members), threads, std::move(device));
}

}  // namespace glisson::detail
