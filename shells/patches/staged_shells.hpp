// Membranes and shells in patches, for backends with memory that a group of threads shares; see
// core/solids/staged_solids.hpp. Include it only where a backend is instantiated.
#pragma once

#include <memory>
#include <vector>

#include <glisson/core/solids/patch_arrays.hpp>
#include <glisson/core/solids/run_phases.hpp>
#include <glisson/shells/patches/bodies.hpp>
#include <glisson/shells/patches/host_patches.hpp>
#include <glisson/shells/patches/make_staged_shells.hpp>
#include <glisson/shells/section_forces.hpp>

namespace glisson::shells {

/// Nodes that several patches have, with their slots.
template <Backend B, class R>
class SharedArrays {
 public:
  SharedArrays(B& backend, const SharedNodes& shared)
      : count_(shared.count()),
        nodes_(detail::upload(backend, shared.nodes)),
        begin_(detail::upload(backend, shared.begin)),
        force_(detail::zeros<Vec4<R>>(backend, static_cast<std::size_t>(shared.slot_count()))) {}

  void connect(PatchView<R>& view) const {
    view.slot_force = force_.get();
    view.shared_begin = begin_.get();
  }
  void add(B& backend, Vec4<R>* f) const {
    backend.for_each(count_, AddSharedForces<R>{nodes_.get(), begin_.get(), force_.get(), f});
  }

 private:
  int count_;
  Buffer<int> nodes_, begin_;
  Buffer<Vec4<R>> force_;
};

/// One section with its element and law as types.
template <Backend B, class R, class E, class L>
class PatchShellBlock final : public ShellBlock<B, R> {
 public:
  /// order: of the elements of host, see locality_order(); memory: see PhaseRunner.
  PatchShellBlock(B& backend, const ShellSection& section, std::vector<int> order, const HostBlock<R>& host,
                  const HostPatches& patches, const Buffer<R>& memory)
      : ShellBlock<B, R>({backend, section.prony, std::move(order)}),
        backend_(backend),
        memory_(memory),
        arrays_(backend, patches, view_),
        constants_(detail::upload(backend, interleaved(host))),
        law_(law_of_section<R, L>(section)),
        wrinkling_(section.wrinkling) {
    view_.block.constants = constants_.get();
    view_.block.element_count = host.element_count;
  }

  void forces(const StepView<R>& step) override {
    run(ShellPatchForces<R, E, L>{body({step.u, step.f, step.advance})});
  }
  void energy(const StepView<R>& step) override {
    run(ShellPatchEnergy<R, E, L>{body({step.u, step.f, false})});
  }
  PatchView<R>& view() { return view_; }
  std::size_t bytes() const { return arrays_.bytes(); }

 private:
  ShellPatchBody<R, E, L> body(const PatchStep<R>& step) const {
    return {{view_, step}, this->history().view(), law_, wrinkling_};
  }
  template <class Body>
  void run(const Body& body) {
    PhaseRunner<B>::run(backend_, body, memory_.get());
  }

  B& backend_;
  const Buffer<R>& memory_;
  PatchView<R> view_;
  PatchArrays arrays_;
  Buffer<std::byte> constants_;
  L law_;
  bool wrinkling_;
};

template <Backend B, class R>
class StagedShells final : public SectionForces<B, R> {
 public:
  /// The backend must outlive this; the model need not.
  StagedShells(B& backend, const Model& model, const Numbering& numbering,
               std::unique_ptr<SolidForces<R>> solids)
      : StagedShells(backend, model, numbering, std::move(solids), make_shell_blocks(model)) {}

 private:
  /// Sections in the order of their patches.
  struct Cut {
    std::vector<std::vector<int>> orders;
    std::vector<HostBlock<R>> blocks;
    PatchCut patches;
    Cut(const std::vector<HostShells>& hosts, const Numbering& numbering) {
      for (const HostShells& host : hosts) {
        orders.push_back(locality_order(*host.section, numbering));
        blocks.push_back(patch_block<R>(host, orders.back(), numbering));
      }
      patches = cut_into_patches(blocks, static_cast<int>(numbering.internal_of_user.size()));
    }
  };
  StagedShells(B& backend, const Model& model, const Numbering& numbering,
               std::unique_ptr<SolidForces<R>> solids, const std::vector<HostShells>& hosts)
      : StagedShells(backend, model, std::move(solids), hosts, Cut(hosts, numbering)) {}
  StagedShells(B& backend, const Model& model, std::unique_ptr<SolidForces<R>> solids,
               const std::vector<HostShells>& hosts, Cut cut)
      : SectionForces<B, R>(backend, element_count(model), std::move(solids)),
        shared_(backend, cut.patches.shared) {
    std::size_t memory = 0;
    double* energy = this->energies();
    for (std::size_t b = 0; b < hosts.size(); ++b) {
      with_types<R>(hosts[b], [&]<class E, class L>(const auto&) {
        auto block = std::make_unique<PatchShellBlock<B, R, E, L>>(backend, *hosts[b].section,
                                                                   std::move(cut.orders[b]), cut.blocks[b],
                                                                   cut.patches.blocks[b], memory_);
        PatchView<R>& view = block->view();
        shared_.connect(view);
        view.block.energy = energy;
        memory = std::max(memory, PhaseRunner<B>::memory_size(view));
        this->bytes_ += block->bytes() + cut.blocks[b].constants.size();
        this->add_block(std::move(block));
      });
      energy += hosts[b].section->elements.size();
    }
    memory_ = detail::reserve<R>(backend, memory);
  }

  void add_shell_forces(const StepView<R>& step) override {
    this->forces_of_blocks(step);
    shared_.add(this->backend_, step.f);
  }

  SharedArrays<B, R> shared_;
  Buffer<R> memory_;
};

}  // namespace glisson::shells

namespace glisson {

template <Backend B, class R>
std::unique_ptr<SolidForces<R>> make_staged_shells(B& backend, const Model& model, const Numbering& numbering,
                                                   std::unique_ptr<SolidForces<R>> solids) {
  return std::make_unique<shells::StagedShells<B, R>>(backend, model, numbering, std::move(solids));
}

}  // namespace glisson
