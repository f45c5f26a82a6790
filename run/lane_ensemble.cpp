#include <algorithm>
#include <atomic>
#include <exception>
#include <map>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/ensemble/lane_group.hpp>
#include <glisson/cpu/team.hpp>
#include <glisson/cpu/threads.hpp>
#include <glisson/run/assemble.hpp>
#include <glisson/run/ensembles.hpp>

namespace glisson::detail {
namespace {

/// One thread each, with the node update in packs.
std::unique_ptr<AnySimulation> make_member(const Model& model, std::unique_ptr<SolidForces<float>> solids) {
  return assemble<Threads, float>(
      model, std::make_unique<Threads>(1), "Ensemble float",
      [&](Threads&, const Model&, const Numbering&) { return std::move(solids); },
      make_plain_shells<Threads, float>);
}

class LaneEnsemble final : public AnyEnsemble {
 public:
  LaneEnsemble(std::vector<Model> models, int threads, const std::string& instruction_set)
      : models_(std::move(models)),
        table_(lanes::choose_lane_table(instruction_set)),
        team_(threads),
        places_(models_.size()) {
    make_groups(make_numbering(models_[0].mesh));
    step(0);
  }

  int member_count() const override { return static_cast<int>(models_.size()); }
  void step(std::int64_t count) override {
    std::atomic<std::size_t> next{0};
    std::vector<std::exception_ptr> failures(groups_.size());
    team_.run([&](int) {
      for (std::size_t g = next++; g < groups_.size(); g = next++) try {
          groups_[g]->step(count);
        } catch (...) {
          failures[g] = std::current_exception();
        }
    });
    for (const auto& failure : failures)
      if (failure) std::rethrow_exception(failure);
  }
  MemberStatus status(int k) const override { return group(k).status(lane(k)); }
  const std::string& error(int k) const override { return group(k).error(lane(k)); }
  AnySimulation& member(int k) override {
    AnySimulation* simulation = group(k).simulation(lane(k));
    if (!simulation) throw Error(ErrorKind::run, error(k));
    return *simulation;
  }
  std::string device() const override {
    return "Ensemble float, " + std::to_string(team_.size()) +
           (team_.size() == 1 ? " thread, " : " threads, ") + table_.name + ": " +
           std::to_string(table_.width) + " members a group";
  }
  std::size_t memory_bytes() const override {
    std::size_t bytes = 0;
    for (const auto& group : groups_) bytes += group->memory_bytes();
    return bytes;
  }

 private:
  struct LanePlace {
    std::size_t group = 0;
    int lane = 0;
  };
  /// Members that fit together fill groups in their order.
  void make_groups(const Numbering& numbering) {
    std::map<std::string, std::vector<std::vector<std::size_t>>> by_key;
    for (std::size_t k = 0; k < models_.size(); ++k) {
      auto& groups = by_key[lanes::group_key(models_[k])];
      if (groups.empty() || groups.back().size() == static_cast<std::size_t>(table_.width))
        groups.emplace_back();
      groups.back().push_back(k);
    }
    for (const auto& [key, groups] : by_key)
      for (const auto& members : groups) {
        std::vector<const Model*> of_group;
        for (const std::size_t k : members) {
          places_[k] = {groups_.size(), static_cast<int>(of_group.size())};
          of_group.push_back(&models_[k]);
        }
        groups_.push_back(std::make_unique<lanes::LaneGroup>(table_, of_group, numbering, make_member));
      }
  }
  lanes::LaneGroup& group(int k) const { return *groups_[places_.at(static_cast<std::size_t>(k)).group]; }
  int lane(int k) const { return places_[static_cast<std::size_t>(k)].lane; }

  std::vector<Model> models_;
  const lanes::LaneTable& table_;
  Team team_;
  std::vector<LanePlace> places_;
  std::vector<std::unique_ptr<lanes::LaneGroup>> groups_;
};

}  // namespace

std::unique_ptr<AnyEnsemble> lane_ensemble(std::vector<Model> members, int threads,
                                           const std::string& instruction_set) {
  return std::make_unique<LaneEnsemble>(std::move(members), threads, instruction_set);
}

}  // namespace glisson::detail
