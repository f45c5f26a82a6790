#include "tests/core/loaded_nodes.hpp"

#include <glisson/core/loads/make_loads.hpp>

#include "tests/core/nodes_on_backend.hpp"

namespace glisson {
namespace {

template <class B, class R>
class BenchLoadOn final : public BenchLoad {
 public:
  BenchLoadOn(const NodesOnBackend<B, R>& nodes, std::unique_ptr<ForceProvider<R>> load)
      : nodes_(nodes), load_(std::move(load)) {}
  std::string_view name() const override { return load_->name(); }
  double stable_step() const override { return load_->stable_step(); }
  void add_forces(const StepView<double>& step) override {
    const StepView<R> arrays = nodes_.arrays();
    auto view = without_arrays<R>(step);
    view.u = arrays.u;
    view.v = arrays.v;
    view.f = arrays.f;
    view.node_count = arrays.node_count;
    load_->add_forces(view);
  }
  double work() const override { return load_->work(); }
  std::vector<std::byte> save() const override { return load_->save(); }
  void load(std::span<const std::byte> bytes) override { load_->load(bytes); }
  double stiffness_amplitude() const override {
    return dynamic_cast<const SpringLoad<B, R>&>(*load_).stiffness_amplitude();
  }

 private:
  const NodesOnBackend<B, R>& nodes_;
  std::unique_ptr<ForceProvider<R>> load_;
};

template <class B, class R>
class LoadedNodesOn final : public LoadedNodes {
 public:
  LoadedNodesOn(BenchCase its_row, int count, double mass) : LoadedNodes(its_row, count, mass) {}
  BenchLoads loads(const Model& model, std::span<const double> mass) override {
    BenchLoads result;
    for (auto& load : make_loads<B, R>(mirror_.backend, model, numbering, mass))
      result.push_back(std::make_unique<BenchLoadOn<B, R>>(mirror_, std::move(load)));
    return result;
  }
  StepView<double> view(double t, double dt) override { return without_arrays<double>(mirror_.view(t, dt)); }
  const std::vector<Vec3<double>>& forces(BenchLoad& load, const StepView<double>& step) override {
    load.add_forces(step);
    mirror_.get_f();
    return f;
  }

 private:
  NodesOnBackend<B, R> mirror_{*this};
};

}  // namespace

std::unique_ptr<BenchLoad> LoadedNodes::load(const NodalForce& force) {
  Model model;
  model.forces = {force};
  return std::move(loads(model)[0]);
}
std::unique_ptr<BenchLoad> LoadedNodes::load(const Gravity& gravity, std::span<const double> mass) {
  Model model;
  model.gravity = {gravity};
  return std::move(loads(model, mass)[0]);
}
std::unique_ptr<BenchLoad> LoadedNodes::load(const Springs& springs) {
  Model model;
  model.springs = {springs};
  return std::move(loads(model)[0]);
}
std::unique_ptr<BenchLoad> LoadedNodes::load(const Pressure& pressure, const Mesh& mesh) {
  Model model;
  model.mesh = mesh;
  model.pressures = {pressure};
  return std::move(loads(model)[0]);
}
std::unique_ptr<BenchLoad> LoadedNodes::load(const Traction& traction, const Mesh& mesh) {
  Model model;
  model.mesh = mesh;
  model.tractions = {traction};
  return std::move(loads(model)[0]);
}

std::unique_ptr<LoadedNodes> loaded_nodes(BenchCase row, int count, double mass) {
  return make_for<LoadedNodes, LoadedNodesOn>(row, row, count, mass);
}

}  // namespace glisson
