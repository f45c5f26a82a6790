// The solids of a model in patches, for backends with on-chip memory that a group of threads shares: nodes
// are read once per patch, forces summed there in a fixed order, and only nodes that several patches have go
// through memory. Include it only where a backend is instantiated.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glisson/core/array_sum.hpp>
#include <glisson/core/solids/block_material.hpp>
#include <glisson/core/solids/patch_arrays.hpp>
#include <glisson/core/solids/patch_kernels.hpp>
#include <glisson/core/solids/shared_arrays.hpp>
#include <glisson/core/solids/solid_forces.hpp>

namespace glisson {

template <Backend B, class R>
class StagedSolids final : public SolidForces<R> {
 public:
  StagedSolids(B& backend, const Model& model, const Numbering& numbering);

  Space space() const override { return B::space; }
  void add_forces(const StepView<R>& step) override {
    add_all_but_shared(step);
    shared_->add(backend_, step.f);
  }
  SharedForces<R> add_all_but_shared(const StepView<R>& step) override;
  PendingSum strain_energy(const StepView<R>& step) override {
    average_pressure(step);
    for (const Block& block : blocks_) run(block, block.kernels->energy, step, false);
    return sum_(energy_.get(), element_count_);
  }
  PendingSum hourglass_energy(const StepView<R>& step) override {
    if (!any_hourglass(blocks_)) return 0;
    for (const Block& block : blocks_) run(block, block.kernels->hourglass, step, false);
    return sum_(energy_.get(), element_count_, 1);
  }
  std::vector<double> history() const override { return history_of<R>(blocks_); }
  void set_history(const std::vector<double>& history) override { set_history_of<R>(blocks_, history); }
  std::size_t memory_bytes() const override { return bytes_; }

 private:
  using Dispatch = PatchDispatch<B, R>;
  using Function = typename Dispatch::Function;
  /// What the constants of the elements of a block are or follow from.
  struct Rest {
    Buffer<std::byte> constants{};
    Buffer<R> X{}, hourglass{};  ///< of RestView
  };
  /// One block with its arrays.
  struct Block {
    BlockMaterial<B, R> material;
    const KernelSet<Function>* kernels = nullptr;
    int threads = 0;  ///< per patch
    PatchView<R> view{};
    PatchArrays arrays;
    Rest rest;
  };

  template <class T>
  Buffer<T> upload(const std::vector<T>& from) {
    bytes_ += from.size() * sizeof(T);
    return upload_constant(backend_, from.data(), from.size());
  }
  void add_block(HostBlock<R> host, const HostPatches& patches, const Model& model,
                 const Numbering& numbering, int first_element);
  /// Lets the view point to it.
  Rest upload_rest(const HostBlock<R>& host, const HostPatches& patches, const Model& model,
                   const Numbering& numbering, PatchView<R>& view);
  void run(const Block& block, Function function, const StepView<R>& step, bool store) {
    Dispatch::run(backend_, function, block.view, PatchStep<R>{step.u, step.f, store}, block.threads,
                  memory_.get());
  }
  void average_pressure(const StepView<R>& step) {
    for (const Block& block : blocks_)
      if (block.kernels->pressure) run(block, block.kernels->pressure, step, false);
  }

  B& backend_;
  int element_count_ = 0;
  std::vector<Block> blocks_;
  std::optional<SharedArrays<B, R>> shared_;                   ///< always there once constructed
  Buffer<R> slot_pressure_, nodal_pressure_, inverse_volume_;  ///< T4ANP only
  Buffer<double> energy_;
  Buffer<R> memory_;  ///< of all patches of a block, where the backend has none on chip
  ArraySum<B> sum_;
  std::size_t bytes_ = 0;
};

template <Backend B, class R>
std::unique_ptr<SolidForces<R>> make_staged_solids(B& backend, const Model& model,
                                                   const Numbering& numbering) {
  return std::make_unique<StagedSolids<B, R>>(backend, model, numbering);
}

template <Backend B, class R>
StagedSolids<B, R>::StagedSolids(B& backend, const Model& model, const Numbering& numbering)
    : backend_(backend), sum_(backend, 2) {
  const int node_count = model.mesh.node_count();
  auto hosts = make_host_blocks<R>(model, numbering, StoredConstants::not_formed_anew);
  const PatchCut cut = cut_into_patches(hosts, node_count);
  shared_.emplace(backend_, cut.shared);
  bytes_ += shared_->bytes();
  const auto inverse_volume = inverse_volumes(hosts, node_count);
  if (!inverse_volume.empty()) {
    inverse_volume_ = upload(inverse_volume);
    // patches of other formulations leave their slots at zero
    const auto slots = static_cast<std::size_t>(cut.shared.slot_count());
    slot_pressure_ = detail::zeros<R>(backend_, slots);
    nodal_pressure_ = detail::zeros<R>(backend_, inverse_volume.size());
    bytes_ += (slots + inverse_volume.size()) * sizeof(R);
  }
  for (const auto& host : hosts) element_count_ += host.element_count;
  energy_ = backend_.template allocate<double>(static_cast<std::size_t>(element_count_));
  blocks_.reserve(hosts.size());
  int element = 0;
  for (std::size_t b = 0; b < hosts.size(); ++b) {
    const int elements = hosts[b].element_count;
    add_block(std::move(hosts[b]), cut.blocks[b], model, numbering, element);
    element += elements;
  }
  std::size_t memory = 0;
  for (const Block& block : blocks_) memory = std::max(memory, Dispatch::memory_size(block.view));
  memory_ = backend_.template allocate<R>(memory);
}

template <Backend B, class R>
auto StagedSolids<B, R>::upload_rest(const HostBlock<R>& host, const HostPatches& patches, const Model& model,
                                     const Numbering& numbering, PatchView<R>& view) -> Rest {
  Rest rest;
  if (host.formulation == Formulation::h8_full) {
    rest.constants = upload(host.constants);
    view.block.constants = rest.constants.get();
    return rest;
  }
  rest.X = upload(rest_positions<R>(patches, model.mesh, numbering));
  rest.hourglass = upload(host.hourglass);
  view.rest = {rest.X.get(), rest.hourglass.get(), static_cast<int>(patches.node.size()),
               host.hourglass.size() > 1, host.formulation == Formulation::h8_fixed};
  return rest;
}

template <Backend B, class R>
void StagedSolids<B, R>::add_block(HostBlock<R> host, const HostPatches& patches, const Model& model,
                                   const Numbering& numbering, int first_element) {
  const auto* kernels = Dispatch::find(host.law, host.formulation, host.viscous());
  const int threads = patch_threads(host.nodes_per_element);
  PatchView<R> view{};
  PatchArrays arrays(backend_, patches, view);
  bytes_ += arrays.bytes();
  shared_->connect(view);
  view.slot_pressure = slot_pressure_.get();
  view.nodal_pressure = nodal_pressure_.get();
  view.inverse_volume = inverse_volume_.get();
  Rest rest = upload_rest(host, patches, model, numbering, view);
  Block block{{backend_, std::move(host)}, kernels, threads, view, std::move(arrays), std::move(rest)};
  block.material.connect(block.view.block);
  bytes_ += block.material.memory_bytes();
  block.view.block.energy = energy_.get() + first_element;
  blocks_.push_back(std::move(block));
}

template <Backend B, class R>
SharedForces<R> StagedSolids<B, R>::add_all_but_shared(const StepView<R>& step) {
  average_pressure(step);
  for (Block& block : blocks_) {
    block.material.set_step(step.dt);
    run(block, block.kernels->forces, step, step.advance);
  }
  return shared_->left();
}

}  // namespace glisson
