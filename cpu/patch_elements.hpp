// Elements of another folder (membranes, shells) for the Threads backend in single precision: that folder's
// kernels, in patches and packs as solids have them.
#pragma once

#include <string>
#include <vector>

#include <glisson/core/force_provider.hpp>
#include <glisson/core/model.hpp>
#include <glisson/cpu/solids/arena.hpp>
#include <glisson/cpu/solids/kernel_table.hpp>
#include <glisson/cpu/solids/patch_lists.hpp>
#include <glisson/cpu/solids/shared_nodes.hpp>
#include <glisson/cpu/threads.hpp>

namespace glisson::patches {

/// Elements that share kernels, law and Prony terms.
struct ElementBlock {
  PatchKernel forces = nullptr;
  EnergyKernel energy = nullptr;
  LawFunction stress = nullptr, energy_of_law = nullptr;  ///< Pass::law of either kernel
  Layout layout{};
  std::vector<Item> items;        ///< in an order of locality; `element` is a place in this block
  std::vector<float> constants;   ///< [elements][layout.constants]
  std::vector<float> idle;        ///< constants of a lane without element; empty: zeros
  std::vector<float> parameters;  ///< one value for all lanes each
  std::vector<PronyTerm> prony;   ///< Pass::isochoric
  int history_components = 0;     ///< per term
  /// Place of an element's history among all: elements x terms x components follow one another.
  std::vector<int> history_place;  ///< [elements]; empty without Prony terms

  std::size_t history_per_element() const {
    return prony.size() * static_cast<std::size_t>(history_components);
  }
};

class PatchElements {
 public:
  /// What the blocks point to and the threads must outlive this.
  PatchElements(Threads& threads, std::vector<ElementBlock> blocks, int node_count,
                const std::string& instruction_set);

  void add_forces(const StepView<float>& step);
  double energy(const StepView<float>& step);  ///< summed over patches in their order [J]
  std::size_t history_size() const { return history_size_; }
  /// [history_place][term][component]
  void get_history(double* values) const;
  void set_history(const double* values);
  std::size_t memory_bytes() const;

 private:
  /// What is left of a block once its patches are made.
  struct Kernels {
    PatchKernel forces;
    EnergyKernel energy;
    LawFunction stress, energy_of_law;
    Layout layout;
    std::vector<PronyTerm> prony;
    std::vector<PronyCoefficients<float>> terms;
    int history_components;
    std::vector<int> history_place;
    double dt = -1;  ///< step that the coefficients belong to [s]
  };
  void add_patches(const ElementBlock& block, PatchLists& lists);
  Patch make_patch(const ElementBlock& block, std::span<const Item> items, PatchLists& lists);
  void share_out();
  Pass pass_of(const StepView<float>& step, int thread) const;
  template <class Visit>
  void visit_history(Visit&& visit) const;

  Threads& threads_;
  const FormulationTable& kernels_;
  Arena arena_;
  std::vector<Kernels> blocks_;
  std::vector<Patch> patches_;
  std::vector<int> block_of_patch_;
  std::vector<int> cut_;  ///< first patch of each thread           [threads + 1]
  SharedNodes shared_;
  bool streams_ = false;  ///< patches do not fit into the caches of the cores
  int scratch_floats_ = 0, local_floats_ = 0;
  Buffer<float> scratch_;     ///< local rows and force rows        [threads][scratch_floats]
  Buffer<float> slot_force_;  ///< [slots][4]
  std::vector<double> patch_energy_;
  std::size_t history_size_ = 0;
};

}  // namespace glisson::patches
