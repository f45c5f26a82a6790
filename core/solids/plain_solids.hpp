// The solids of a model in plain form on any backend: force per element, then a gather per node. Include it
// only where a backend is instantiated.
#pragma once

#include <memory>
#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/solids/energy_sum.hpp>
#include <glisson/core/solids/host_blocks.hpp>
#include <glisson/core/solids/solid_forces.hpp>
#include <glisson/core/solids/solid_kernels.hpp>

namespace glisson {

template <Backend B, class R>
class PlainSolids final : public SolidForces<R> {
 public:
  PlainSolids(B& backend, const Model& model, const Numbering& numbering);

  Space space() const override { return B::space; }
  void add_forces(const StepView<R>& step) override;
  double strain_energy(const StepView<R>& step) override;
  double hourglass_energy(const StepView<R>& step) override;
  std::vector<double> history() const override;
  void set_history(const std::vector<double>& history) override;
  std::size_t memory_bytes() const override { return bytes_; }

 private:
  using Dispatch = SolidDispatch<B, R>;
  using Function = typename Dispatch::Function;
  /// One block with its arrays.
  struct Block {
    HostBlock<R> host;  ///< small parts only; arrays are released after the upload
    BlockView<R> view;
    const KernelSet<Function>* kernels = nullptr;
    Buffer<std::byte> constants;
    Buffer<int> nodes;
    Buffer<R> parameters, history;
    Buffer<PronyCoefficients<R>> terms;
    double dt = -1;  ///< step that the coefficients belong to [s]
  };

  template <class T>
  Buffer<T> upload(const std::vector<T>& from) {
    auto buffer = backend_.template allocate<T>(from.size());
    backend_.copy_in(from.data(), buffer.get(), from.size());
    bytes_ += from.size() * sizeof(T);
    return buffer;
  }
  void add_block(HostBlock<R> host, int first_slot, int first_element);
  void set_terms(Block& block, double dt);
  void run(Function function, const Block& block, const EvaluationView<R>& now) {
    Dispatch::run(backend_, function, block.view, now);
  }
  void average_pressure(const EvaluationView<R>& now);
  double sum_energy();

  B& backend_;
  int node_count_ = 0, element_count_ = 0;
  std::vector<Block> blocks_;
  Buffer<Vec4<R>> f_element_;
  Buffer<int> begin_, slot_;
  Buffer<double> energy_;
  EnergySum<B> sum_;
  std::vector<double> energy_on_host_;           ///< its copy, once it was asked for; of devices only
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
    : backend_(backend), node_count_(model.mesh.node_count()) {
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
  Block block;
  block.kernels = Dispatch::find(host.law, host.formulation, host.viscous());
  block.constants = upload(host.constants);
  block.nodes = upload(host.nodes);
  block.parameters = upload(host.parameters);
  block.history = backend_.template allocate<R>(host.history_size());
  if (host.viscous()) {
    const std::vector<R> zero(host.history_size(), R(0));
    backend_.copy_in(zero.data(), block.history.get(), zero.size());
  }
  block.terms = backend_.template allocate<PronyCoefficients<R>>(host.prony.size());
  bytes_ += host.history_size() * sizeof(R);
  BlockView<R>& view = block.view;
  view.constants = block.constants.get();
  view.nodes = block.nodes.get();
  view.parameters = block.parameters.get();
  view.terms = block.terms.get();
  view.history = block.history.get();
  view.f_element = f_element_.get() + first_slot;
  view.volume_change = averaged_ ? element_pressure_.get() + first_element : nullptr;
  view.nodal_pressure = nodal_pressure_.get();
  view.energy = energy_.get() + first_element;
  view.element_count = host.element_count;
  view.isochoric_count = host.isochoric_count;
  view.volumetric_count = static_cast<int>(host.prony.size()) - host.isochoric_count;
  view.per_element = host.per_element;
  host.constants = {}, host.nodes = {}, host.parameters = {};
  block.host = std::move(host);
  blocks_.push_back(std::move(block));
}

template <Backend B, class R>
void PlainSolids<B, R>::set_terms(Block& block, double dt) {
  if (!block.host.viscous() || dt == block.dt) return;
  std::vector<PronyCoefficients<R>> terms;
  for (const PronyTerm& term : block.host.prony) {
    const auto exact = prony_coefficients(term.alpha, term.tau, dt);
    terms.push_back({R(exact.alpha), R(exact.rate)});
  }
  backend_.copy_in(terms.data(), block.terms.get(), terms.size());
  block.dt = dt;
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
    set_terms(block, step.dt);
    run(block.kernels->forces, block, now);
  }
  backend_.for_each(node_count_, GatherForces<R>{begin_.get(), slot_.get(), f_element_.get(), step.f});
}

template <Backend B, class R>
double PlainSolids<B, R>::sum_energy() {
  return sum_(backend_, energy_, static_cast<std::size_t>(element_count_));
}

template <Backend B, class R>
double PlainSolids<B, R>::strain_energy(const StepView<R>& step) {
  const EvaluationView<R> now{step.u, false};
  average_pressure(now);
  for (const Block& block : blocks_) run(block.kernels->energy, block, now);
  return sum_energy();
}

template <Backend B, class R>
double PlainSolids<B, R>::hourglass_energy(const StepView<R>& step) {
  bool any = false;
  for (const Block& block : blocks_)
    any = any || block.host.formulation == Formulation::h8 || block.host.formulation == Formulation::h8_fixed;
  if (!any) return 0;
  for (const Block& block : blocks_) run(block.kernels->hourglass, block, {step.u, false});
  return sum_energy();
}

template <Backend B, class R>
std::vector<double> PlainSolids<B, R>::history() const {
  std::vector<std::vector<R>> arrays;
  for (const Block& block : blocks_) {
    arrays.emplace_back(block.host.history_size());
    backend_.copy_out(block.history.get(), arrays.back().data(), arrays.back().size());
  }
  std::vector<const HostBlock<R>*> hosts;
  for (const Block& block : blocks_) hosts.push_back(&block.host);
  return canonical_history(hosts, arrays);
}

template <Backend B, class R>
void PlainSolids<B, R>::set_history(const std::vector<double>& history) {
  std::vector<const HostBlock<R>*> hosts;
  for (const Block& block : blocks_) hosts.push_back(&block.host);
  const auto arrays = block_history<R>(hosts, history);
  for (std::size_t k = 0; k < blocks_.size(); ++k)
    backend_.copy_in(arrays[k].data(), blocks_[k].history.get(), arrays[k].size());
}

}  // namespace glisson
