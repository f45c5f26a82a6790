#include <glisson/cpu/ensemble/lane_group.hpp>

namespace glisson::lanes {

/// The solids as one member sees them.
class LaneGroup::Solids final : public SolidForces<float> {
 public:
  Solids(LaneGroup& group, int lane) : group_(group), lane_(lane) {}

  void add_forces(const StepView<float>& step) override { ask(Request::Kind::forces, step); }
  PendingSum strain_energy(const StepView<float>& step) override {
    return ask(Request::Kind::strain_energy, step);
  }
  PendingSum hourglass_energy(const StepView<float>& step) override {
    return ask(Request::Kind::hourglass_energy, step);
  }
  std::vector<double> history() const override { return group_.solids_.history(lane_); }
  void set_history(const std::vector<double>& history) override {
    group_.solids_.set_history(lane_, history);
  }
  std::size_t memory_bytes() const override {
    return group_.solids_.memory_bytes() / group_.requests_.size();
  }

 private:
  double ask(Request::Kind kind, const StepView<float>& view);
  LaneGroup& group_;
  int lane_;
};

double LaneGroup::Solids::ask(Request::Kind kind, const StepView<float>& view) {
  const auto lane = static_cast<std::size_t>(lane_);
  Request& request = group_.requests_[lane];
  request.kind = kind;
  request.view = view;
  Fiber& fiber = group_.members_[lane]->fiber();
  if (fiber.inside())
    fiber.pause();
  else
    group_.answer(kind);  // a result is asked for between two steps
  return request.energy;
}

LaneGroup::LaneGroup(const LaneTable& table, const std::vector<const Model*>& models,
                     const Numbering& numbering, MakeMember make)
    : solids_(table, models, numbering), make_(std::move(make)), requests_(models.size()) {
  for (std::size_t lane = 0; lane < models.size(); ++lane)
    members_.push_back(std::make_unique<MemberLoop>([this, lane, model = models[lane]] {
      return make_(*model, std::make_unique<Solids>(*this, static_cast<int>(lane)));
    }));
}

LaneGroup::~LaneGroup() = default;

void LaneGroup::answer(Request::Kind kind) { solids_.answer(kind, requests_); }

bool LaneGroup::waiting(Request::Kind kind) const {
  for (const Request& request : requests_)
    if (request.kind == kind) return true;
  return false;
}

/// Energies first: who asked for them will ask for forces next, together with the others.
void LaneGroup::step(std::int64_t count) {
  for (auto& member : members_) {
    member->set_wish(count);
    if (!member->fiber().done()) member->resume();
  }
  while (true) {
    for (std::size_t lane = 0; lane < members_.size(); ++lane)
      while (requests_[lane].kind == Request::Kind::none && !members_[lane]->idle()) members_[lane]->resume();
    if (waiting(Request::Kind::strain_energy))
      answer(Request::Kind::strain_energy);
    else if (waiting(Request::Kind::hourglass_energy))
      answer(Request::Kind::hourglass_energy);
    else if (waiting(Request::Kind::forces))
      answer(Request::Kind::forces);
    else
      return;
  }
}

MemberStatus LaneGroup::status(int lane) const { return members_[static_cast<std::size_t>(lane)]->status(); }
const std::string& LaneGroup::error(int lane) const {
  return members_[static_cast<std::size_t>(lane)]->error();
}
AnySimulation* LaneGroup::simulation(int lane) const {
  return members_[static_cast<std::size_t>(lane)]->simulation();
}

std::size_t LaneGroup::memory_bytes() const {
  std::size_t bytes = 0;
  for (const auto& member : members_)
    if (member->simulation()) bytes += member->simulation()->memory_bytes();
  return bytes;
}

}  // namespace glisson::lanes
