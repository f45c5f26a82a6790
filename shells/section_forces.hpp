// The sections of a model, each with its element and law as types: what the plain and the patch form share.
#pragma once

#include <memory>
#include <vector>

#include <glisson/core/array_sum.hpp>
#include <glisson/core/loads/upload.hpp>
#include <glisson/shells/internal_forces.hpp>
#include <glisson/shells/laws/laws.hpp>
#include <glisson/shells/section_history.hpp>
#include <glisson/shells/shell_blocks.hpp>

namespace glisson::shells {

/// visit.template operator()<E, L>(constants of the section in double [elements]) with its element and law.
template <class R, class Visit>
void with_types(const HostShells& host, Visit&& visit) {
  if (host.bends())
    for_each_type(ShellLaws<R>{}, [&]<class L>() {
      if (host.section->law == L::name) visit.template operator()<RotationFree, L>(host.shells);
    });
  else
    for_each_type(MembraneLaws<R>{}, [&]<class L>() {
      if (host.section->law == L::name) visit.template operator()<Membrane, L>(host.membranes);
    });
}

template <class R, class L>
L law_of_section(const ShellSection& section) {
  const std::vector<R> parameters(section.parameters.begin(), section.parameters.end());
  return L::load(parameters.data());
}

/// One section.
template <Backend B, class R>
class ShellBlock {
 public:
  explicit ShellBlock(SectionHistory<B, R> history) : history_(std::move(history)) {}
  virtual ~ShellBlock() = default;
  virtual void forces(const StepView<R>& step) = 0;
  /// W of each element, where the block's part of the energies begins.
  virtual void energy(const StepView<R>& step) = 0;
  SectionHistory<B, R>& history() { return history_; }
  const SectionHistory<B, R>& history() const { return history_; }

 private:
  SectionHistory<B, R> history_;
};

inline std::size_t element_count(const Model& model) {
  std::size_t count = 0;
  for (const ShellSection& section : model.shells) count += section.elements.size();
  return count;
}

/// Energy and history of all; forces are left to the forms.
template <Backend B, class R>
class SectionForces : public InternalForces<R> {
 public:
  SectionForces(B& backend, std::size_t element_count, std::unique_ptr<SolidForces<R>> solids)
      : InternalForces<R>(std::move(solids)),
        backend_(backend),
        element_count_(static_cast<int>(element_count)),
        energy_(detail::reserve<double>(backend, element_count)),
        sum_(backend) {
    bytes_ = element_count * sizeof(double);
  }

  Space space() const override { return B::space; }

 protected:
  using Block = ShellBlock<B, R>;
  double* energies() { return energy_.get(); }  ///< [element_count]

  void add_block(std::unique_ptr<Block> block) { blocks_.push_back(std::move(block)); }
  void forces_of_blocks(const StepView<R>& step) {
    for (auto& block : blocks_) {
      block->history().set_step(step.dt);
      block->forces(step);
    }
  }

  B& backend_;
  std::size_t bytes_ = 0;

 private:
  PendingSum energy_of_shells(const StepView<R>& step) override {
    for (auto& block : blocks_) block->energy(step);
    return sum_(energy_.get(), element_count_);
  }
  std::size_t shell_history_size() const override {
    std::size_t size = 0;
    for (const auto& block : blocks_) size += block->history().size();
    return size;
  }
  void get_shell_history(double* values) const override {
    for (const auto& block : blocks_) {
      block->history().get(values);
      values += block->history().size();
    }
  }
  void set_shell_history(const double* values) override {
    for (auto& block : blocks_) {
      block->history().set(values);
      values += block->history().size();
    }
  }
  std::size_t shell_bytes() const override { return bytes_; }

  std::vector<std::unique_ptr<Block>> blocks_;
  int element_count_;
  Buffer<double> energy_;
  ArraySum<B> sum_;
};

}  // namespace glisson::shells
