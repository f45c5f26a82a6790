// The provider behind make_patch_solids.
#pragma once

#include <vector>

#include <glisson/core/solids/solid_forces.hpp>
#include <glisson/cpu/solids/patch_builder.hpp>
#include <glisson/cpu/solids/shared_nodes.hpp>
#include <glisson/cpu/threads.hpp>

namespace glisson::patches {

class PatchSolids final : public SolidForces<float> {
 public:
  PatchSolids(Threads& threads, const Model& model, const Numbering& numbering, const InstructionSet& set);

  void add_forces(const StepView<float>& step) override;
  PendingSum strain_energy(const StepView<float>& step) override;
  PendingSum hourglass_energy(const StepView<float>& step) override;
  std::vector<double> history() const override;
  void set_history(const std::vector<double>& history) override;
  std::size_t memory_bytes() const override;

 private:
  /// What a block needs in a step of size dt.
  struct BlockPass {
    PatchKernel forces;
    std::vector<PronyCoefficients<float>> prony;
    double dt = -1;
  };
  void make_blocks(const Model& model, const Numbering& numbering, const ElementParameters& parameters,
                   PatchBuilder& builder);
  void find_volumes(const Model& model, const Numbering& numbering);
  void keep_history_order(const Model& model);
  const LawTable& law_named(const std::string& name) const;

  Pass pass_of(const StepView<float>& step, int thread) const;
  void for_block(Pass& pass, const Block& block, const BlockPass& block_pass) const;
  void load(const Block& block, const Patch& patch, const Pass& pass) const;
  void average_pressures(Pass pass, int thread);
  /// The value of `energy` summed over patches in their order.
  template <class Energy>
  double sum_energy(const StepView<float>& step, Energy&& energy);
  template <class Visit>
  void visit_history(Visit&& visit) const;

  Threads& threads_;
  const InstructionSet& set_;
  const FormulationTable& kernels_;
  Arena arena_;
  std::vector<Block> blocks_;
  std::vector<BlockPass> block_passes_;
  std::vector<Patch> patches_;
  std::vector<int> block_of_patch_;
  std::vector<int> cut_;  ///< first patch of each thread           [threads + 1]
  SharedNodes shared_;
  bool averages_pressure_ = false;
  bool streams_ = false;  ///< patches do not fit into the caches of the cores
  int scratch_floats_ = 0, local_floats_ = 0;
  Buffer<float> scratch_;     ///< local rows and force rows            [threads][scratch_floats]
  Buffer<float> slot_force_;  ///< [slots][4]
  Buffer<float> slot_pressure_, pressure_, pressure_weight_;
  std::vector<double> patch_energy_;
  std::vector<std::size_t>
      history_begin_;  ///< first value of an element in the canonical order [element_count]
  std::size_t history_size_ = 0;
};

}  // namespace glisson::patches
