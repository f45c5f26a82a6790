#include <glisson/run/ensembles.hpp>

#include <atomic>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/team.hpp>

namespace glisson::detail {
namespace {

class PlainEnsemble final : public AnyEnsemble {
 public:
  PlainEnsemble(std::vector<Model> models, int threads, MakeAlone make)
      : models_(std::move(models)),
        make_(std::move(make)),
        team_(threads),
        simulations_(models_.size()),
        errors_(models_.size()) {
    for_each([this](std::size_t k) { simulations_[k] = make_(models_[k]); });
  }

  int member_count() const override { return static_cast<int>(models_.size()); }
  void step(std::int64_t count) override {
    for_each([=, this](std::size_t k) {
      if (simulations_[k] && errors_[k].empty()) simulations_[k]->step(count);
    });
  }
  MemberStatus status(int k) const override {
    const auto i = static_cast<std::size_t>(k);
    if (!errors_.at(i).empty()) return MemberStatus::failed;
    return simulations_[i]->finished() ? MemberStatus::finished : MemberStatus::running;
  }
  const std::string& error(int k) const override { return errors_.at(static_cast<std::size_t>(k)); }
  AnySimulation& member(int k) override {
    const auto i = static_cast<std::size_t>(k);
    if (!simulations_.at(i)) throw Error(ErrorKind::run, errors_[i]);
    return *simulations_[i];
  }
  std::string device() const override {
    const auto any =
        std::find_if(simulations_.begin(), simulations_.end(), [](const auto& s) { return !!s; });
    return "Ensemble of single runs, " + std::to_string(team_.size()) + " at a time, each on " +
           (any == simulations_.end() ? "nothing" : (*any)->device());
  }
  std::size_t memory_bytes() const override {
    std::size_t bytes = 0;
    for (const auto& simulation : simulations_) bytes += simulation ? simulation->memory_bytes() : 0;
    return bytes;
  }

 private:
  /// An exception belongs to its member.
  template <class F>
  void for_each(F body) {
    std::atomic<std::size_t> next{0};
    team_.run([&](int) {
      for (std::size_t k = next++; k < models_.size(); k = next++) try {
          body(k);
        } catch (const std::exception& failure) {
          errors_[k] = failure.what();
        }
    });
  }

  std::vector<Model> models_;
  MakeAlone make_;
  Team team_;
  std::vector<std::unique_ptr<AnySimulation>> simulations_;
  std::vector<std::string> errors_;
};

}  // namespace

std::unique_ptr<AnyEnsemble> plain_ensemble(std::vector<Model> members, int threads, MakeAlone make) {
  return std::make_unique<PlainEnsemble>(std::move(members), threads, std::move(make));
}

}  // namespace glisson::detail
