#include "tests/core/constrained_nodes.hpp"

#include <glisson/core/constraints/constraints.hpp>

#include "tests/core/nodes_on_backend.hpp"

namespace glisson {
namespace {

template <class B, class R>
class ConstrainedNodesOn final : public ConstrainedNodes {
 public:
  ConstrainedNodesOn(BenchCase its_row, int count, double mass) : ConstrainedNodes(its_row, count, mass) {}
  void constrain(const Model& model) override {
    constraints_ = std::make_unique<Constraints<B, R>>(mirror_.backend, model, numbering);
  }
  void apply(double t_next, double dt) override {
    mirror_.view(t_next, dt);
    constraints_->apply(mirror_.u(), mirror_.v(), t_next, dt);
    mirror_.get_u();
    mirror_.get_v();
  }
  void project() override {
    mirror_.view(0, 1);
    constraints_->project(mirror_.v());
    mirror_.get_v();
  }
  void react(const std::vector<Vec3<double>>& forces, double t, double t_next, double dt) override {
    const StepView<R> step = mirror_.view(t, dt);
    mirror_.put_f(forces);
    constraints_->add_reactions(step, t_next, PlainStepper<R>{R(kick(dt)), R(dt)});
    mirror_.get_f();
  }
  double work() const override { return constraints_->work(); }
  std::vector<std::byte> save() const override { return constraints_->save(); }
  void load(std::span<const std::byte> bytes) override { constraints_->load(bytes); }

 private:
  NodesOnBackend<B, R> mirror_{*this};
  std::unique_ptr<Constraints<B, R>> constraints_;
};

}  // namespace

std::unique_ptr<ConstrainedNodes> constrained_nodes(BenchCase row, int count, double mass) {
  return make_for<ConstrainedNodes, ConstrainedNodesOn>(row, row, count, mass);
}

}  // namespace glisson
