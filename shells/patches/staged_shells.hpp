// Membranes and shells in patches, for backends with memory that a group of threads shares; see
// core/solids/staged_solids.hpp. Include it only where a backend is instantiated.
#pragma once

#include <memory>
#include <vector>

#include <glisson/core/solids/patch_arrays.hpp>
#include <glisson/core/solids/run_phases.hpp>
#include <glisson/core/solids/shared_arrays.hpp>
#include <glisson/shells/patches/bodies.hpp>
#include <glisson/shells/patches/host_patches.hpp>
#include <glisson/shells/patches/make_staged_shells.hpp>
#include <glisson/shells/section_forces.hpp>

namespace glisson::shells {

/// What a section keeps of the rest state.
template <Backend B, class R>
class RestArrays {
 public:
  RestArrays(B& backend, const ShellSection& section, const HostRest<R>& rest)
      : X_(detail::upload(backend, rest.X)),
        thickness_(detail::upload(backend, rest.thickness)),
        gradients_(detail::upload(backend, rest.gradients)),
        images_(detail::upload(backend, rest.images)),
        along_(detail::upload(backend, rest.along)) {
    const double nu = section.bending_nu;
    view_ = {thickness_.get(), along_.get(), gradients_.get(), images_.get()};
    positions_.X = X_.get(), positions_.place_count = static_cast<int>(rest.X.size() / 3);
    view_.element_count = static_cast<int>(section.elements.size());
    view_.thickness_stride = rest.thickness.size() > 1, view_.along_stride = rest.along.size() > 1;
    view_.plate = R(section.bending_E / (12 * (1 - nu * nu))), view_.nu = R(nu);
    bytes_ =
        (rest.X.size() + rest.thickness.size() + rest.gradients.size() + rest.images.size()) * sizeof(R) +
        rest.along.size() * sizeof(Vec3<R>);
  }
  const RestView<R>& positions() const { return positions_; }
  const SectionRest<R>& view() const { return view_; }
  std::size_t bytes() const { return bytes_; }

 private:
  Buffer<R> X_, thickness_, gradients_, images_;
  Buffer<Vec3<R>> along_;
  RestView<R> positions_;
  SectionRest<R> view_;
  std::size_t bytes_;
};

/// One section with its element and law as types.
template <Backend B, class R, class E, class L>
class PatchShellBlock final : public ShellBlock<B, R> {
 public:
  using Forces = ShellPatchForces<R, E, L>;
  /// order: of the elements in the patches, see locality_order(); memory: see PhaseRunner.
  PatchShellBlock(B& backend, const ShellSection& section, std::vector<int> order, const HostPatches& patches,
                  const HostRest<R>& rest, const Buffer<R>& memory)
      : ShellBlock<B, R>({backend, section.prony, std::move(order)}),
        backend_(backend),
        memory_(memory),
        arrays_(backend, patches, view_),
        rest_(backend, section, rest),
        law_(law_of_section<R, L>(section)),
        wrinkling_(section.wrinkling) {
    view_.block.element_count = static_cast<int>(section.elements.size());
    view_.rest = rest_.positions();
  }

  void forces(const StepView<R>& step) override { run(Forces{body({step.u, step.f, step.advance})}); }
  void energy(const StepView<R>& step) override {
    run(ShellPatchEnergy<R, E, L>{body({step.u, step.f, false})});
  }
  PatchView<R>& view() { return view_; }
  std::size_t bytes() const { return arrays_.bytes() + rest_.bytes(); }

 private:
  ShellPatchBody<R, E, L> body(const PatchStep<R>& step) const {
    return {{view_, step}, rest_.view(), this->history().view(), law_, wrinkling_};
  }
  template <class Body>
  void run(const Body& body) {
    PhaseRunner<B>::run(backend_, body, memory_.get());
  }

  B& backend_;
  const Buffer<R>& memory_;
  PatchView<R> view_;
  PatchArrays arrays_;
  RestArrays<B, R> rest_;
  L law_;
  bool wrinkling_;
};

/// All sections on the host: the order of their triangles, and their patches.
template <class R>
struct ShellCut {
  std::vector<HostShells> hosts;
  std::vector<std::vector<int>> orders;
  PatchCut patches;

  ShellCut(const Model& model, const Numbering& numbering) : hosts(make_shell_blocks(model)) {
    std::vector<HostBlock<R>> blocks;
    for (const HostShells& host : hosts) {
      orders.push_back(locality_order(*host.section, numbering));
      blocks.push_back(patch_block<R>(host, orders.back(), numbering));
    }
    patches = cut_into_patches(blocks, model.mesh.node_count());
  }
};

template <Backend B, class R>
class StagedShells final : public SectionForces<B, R> {
 public:
  /// The backend must outlive this; the model need not.
  StagedShells(B& backend, const Model& model, const Numbering& numbering,
               std::unique_ptr<SolidForces<R>> solids)
      : StagedShells(backend, model, numbering, std::move(solids), ShellCut<R>(model, numbering)) {}

 private:
  StagedShells(B& backend, const Model& model, const Numbering& numbering,
               std::unique_ptr<SolidForces<R>> solids, const ShellCut<R>& cut)
      : SectionForces<B, R>(backend, element_count(model), std::move(solids)),
        shared_(backend, cut.patches.shared) {
    double* energy = this->energies();
    for (std::size_t b = 0; b < cut.hosts.size(); ++b) {
      const HostShells& host = cut.hosts[b];
      const auto rest = make_rest<R>(host, cut.orders[b], cut.patches.blocks[b], model.mesh, numbering);
      with_types<R>(host, [&]<class E, class L>(const auto&) {
        add(std::make_unique<PatchShellBlock<B, R, E, L>>(backend, *host.section, cut.orders[b],
                                                          cut.patches.blocks[b], rest, memory_),
            energy);
      });
      energy += host.section->elements.size();
    }
    memory_ = detail::reserve<R>(backend, memory_size_);
  }
  template <class Block>
  void add(std::unique_ptr<Block> block, double* energy) {
    shared_.connect(block->view());
    block->view().block.energy = energy;
    using Forces = typename Block::Forces;
    memory_size_ = std::max(memory_size_, PhaseRunner<B>::template memory_size<Forces>(block->view()));
    this->bytes_ += block->bytes();
    this->add_block(std::move(block));
  }

  void add_shell_forces(const StepView<R>& step) override {
    this->forces_of_blocks(step);
    shared_.add(this->backend_, step.f);
  }
  SharedForces<R> add_shells_but_shared(const StepView<R>& step) override {
    this->forces_of_blocks(step);
    return shared_.left();
  }

  SharedArrays<B, R> shared_;
  std::size_t memory_size_ = 0;
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
