// The solids of a model in plain form on any backend: force per element, then a gather per node. Include it
// only where a backend is instantiated.
#pragma once

#include <memory>
#include <vector>

#include <glisson/core/array_sum.hpp>
#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/solids/block_material.hpp>
#include <glisson/core/solids/solid_forces.hpp>
#include <glisson/core/solids/solid_kernels.hpp>

namespace glisson {

template <Backend B, class R>
class PlainSolids final : public SolidForces<R> {
 public:
  PlainSolids(B& backend, const Model& model, const Numbering& numbering);

  Space space() const override { return B::space; }
  void add_forces(const StepView<R>& step) override;
  PendingSum strain_energy(const StepView<R>& step) override;
  PendingSum hourglass_energy(const StepView<R>& step) override;
  std::vector<double> history() const override { return history_of<R>(blocks_); }
  void set_history(const std::vector<double>& history) override { set_history_of<R>(blocks_, history); }
  std::size_t memory_bytes() const override { return bytes_; }

 private:
  using Dispatch = SolidDispatch<B, R>;
  using Function = typename Dispatch::Function;
  /// One block with its arrays.
  struct Block {
    BlockMaterial<B, R> material;
    const KernelSet<Function>* kernels = nullptr;
    Buffer<std::byte> constants;
    Buffer<int> nodes;
    BlockView<R> view{};
  };

  template <class T>
  Buffer<T> upload(const std::vector<T>& from) {
    auto buffer = backend_.template allocate<T>(from.size());
    backend_.copy_in(from.data(), buffer.get(), from.size());
    bytes_ += from.size() * sizeof(T);
    return buffer;
  }
  void add_block(HostBlock<R> host, int first_slot, int first_element);
  void run(Function function, const Block& block, const EvaluationView<R>& now) {
    Dispatch::run(backend_, function, block.view, now);
  }
  void average_pressure(const EvaluationView<R>& now);

  B& backend_;
  int node_count_ = 0, element_count_ = 0;
  std::vector<Block> blocks_;
  Buffer<Vec4<R>> f_element_;
  Buffer<int> begin_, slot_;
  Buffer<double> energy_;
  ArraySum<B> sum_;
  Buffer<int> average_begin_, average_element_;  ///< T4ANP only
  Buffer<R> average_weight_, element_pressure_, nodal_pressure_;
  bool averaged_ = false;
  std::size_t bytes_ = 0;
};

template <Backend B, class R>
std::unique_ptr<SolidForces<R>> make_plain_solids(B& backend, const Model& model,
                                                  const Numbering& numbering) {
  return std::make_unique<PlainSolids<B, R>>(backend, model, numbering);
}

template <Backend B, class R>
PlainSolids<B, R>::PlainSolids(B& backend, const Model& model, const Numbering& numbering)
    : backend_(backend), node_count_(model.mesh.node_count()), sum_(backend, 2) {
  auto hosts = make_host_blocks<R>(model, numbering);
  const Incidence incidence = make_incidence(hosts, node_count_);
  begin_ = upload(incidence.begin);
  slot_ = upload(incidence.slot);
  f_element_ = backend_.template allocate<Vec4<R>>(incidence.slot.size());
  bytes_ += incidence.slot.size() * sizeof(Vec4<R>);
  const AverageLists<R> average = make_average_lists(hosts, node_count_);
  averaged_ = !average.element.empty();
  if (averaged_) {
    average_begin_ = upload(average.begin);
    average_element_ = upload(average.element);
    average_weight_ = upload(average.weight);
    nodal_pressure_ = backend_.template allocate<R>(static_cast<std::size_t>(node_count_));
  }
  for (const auto& host : hosts) element_count_ += host.element_count;
  element_pressure_ = backend_.template allocate<R>(static_cast<std::size_t>(averaged_ ? element_count_ : 0));
  energy_ = backend_.template allocate<double>(static_cast<std::size_t>(element_count_));
  int slot = 0, element = 0;
  blocks_.reserve(hosts.size());
  for (auto& host : hosts) {
    const int slots = host.element_count * host.nodes_per_element, elements = host.element_count;
    add_block(std::move(host), slot, element);
    slot += slots, element += elements;
  }
}

template <Backend B, class R>
void PlainSolids<B, R>::add_block(HostBlock<R> host, int first_slot, int first_element) {
  const auto* kernels = Dispatch::find(host.law, host.formulation, host.viscous());
  auto constants = upload(host.constants);
  auto nodes = upload(host.nodes);
  Block block{{backend_, std::move(host)}, kernels, std::move(constants), std::move(nodes)};
  bytes_ += block.material.memory_bytes();
  BlockView<R>& view = block.view;
  block.material.connect(view);
  view.constants = block.constants.get();
  view.nodes = block.nodes.get();
  view.f_element = f_element_.get() + first_slot;
  view.volume_change = averaged_ ? element_pressure_.get() + first_element : nullptr;
  view.nodal_pressure = nodal_pressure_.get();
  view.energy = energy_.get() + first_element;
  blocks_.push_back(std::move(block));
}

template <Backend B, class R>
void PlainSolids<B, R>::average_pressure(const EvaluationView<R>& now) {
  if (!averaged_) return;
  for (const Block& block : blocks_)
    if (block.kernels->pressure) run(block.kernels->pressure, block, now);
  backend_.for_each(node_count_,
                    NodalPressure<R>{average_begin_.get(), average_element_.get(), average_weight_.get(),
                                     element_pressure_.get(), nodal_pressure_.get()});
}

template <Backend B, class R>
void PlainSolids<B, R>::add_forces(const StepView<R>& step) {
  const EvaluationView<R> now{step.u, step.advance};
  average_pressure(now);
  for (Block& block : blocks_) {
    block.material.set_step(step.dt);
    run(block.kernels->forces, block, now);
  }
  backend_.for_each(node_count_, GatherForces<R>{begin_.get(), slot_.get(), f_element_.get(), step.f});
}

template <Backend B, class R>
PendingSum PlainSolids<B, R>::strain_energy(const StepView<R>& step) {
  const EvaluationView<R> now{step.u, false};
  average_pressure(now);
  for (const Block& block : blocks_) run(block.kernels->energy, block, now);
  return sum_(energy_.get(), element_count_);
}

template <Backend B, class R>
PendingSum PlainSolids<B, R>::hourglass_energy(const StepView<R>& step) {
  if (!any_hourglass(blocks_)) return 0;
  for (const Block& block : blocks_) run(block.kernels->hourglass, block, {step.u, false});
  return sum_(energy_.get(), element_count_, 1);
}

}  // namespace glisson
