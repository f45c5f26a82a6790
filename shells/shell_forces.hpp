// Membranes and shells in plain form on any backend: force per triangle, then a gather per node. Include it
// only where a backend is instantiated.
#pragma once

#include <map>
#include <memory>
#include <numeric>
#include <vector>

#include <glisson/core/numbering.hpp>
#include <glisson/shells/section_forces.hpp>
#include <glisson/shells/shell_kernels.hpp>

namespace glisson::shells {

template <Backend B, class R, class E, class L>
class PlainShellBlock final : public ShellBlock<B, R> {
 public:
  using Constants = typename E::template Constants<double>;
  /// f_element and energy: where the block's own parts begin.
  PlainShellBlock(B& backend, const HostShells& host, const std::vector<Constants>& constants,
                  const Numbering& numbering, Vec4<R>* f_element, double* energy)
      : ShellBlock<B, R>({backend, host.section->prony, section_order(constants.size())}), backend_(backend) {
    std::vector<typename E::template Constants<R>> own;
    for (const auto& c : constants) own.push_back(narrowed<R, E::template Constants>(c));
    std::vector<int> nodes;
    for (const int n : host.nodes) nodes.push_back(numbering.internal_of_user[static_cast<std::size_t>(n)]);
    constants_ = detail::upload(backend, own);
    nodes_ = detail::upload(backend, nodes);
    view_.law = law_of_section<R, L>(*host.section);
    view_.constants = constants_.get(), view_.nodes = nodes_.get();
    view_.f_element = f_element, view_.energy = energy;
    view_.element_count = static_cast<int>(constants.size());
    view_.history = this->history().view();
    view_.wrinkling = host.section->wrinkling;
  }

  void forces(const StepView<R>& step) override {
    backend_.for_each(view_.element_count, ShellForcesBody<R, E, L>{view_, step.u, step.advance});
  }
  void energy(const StepView<R>& step) override {
    backend_.for_each(view_.element_count, ShellEnergyBody<R, E, L>{view_, step.u});
  }

 private:
  static std::vector<int> section_order(std::size_t count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    return order;
  }

  B& backend_;
  ShellView<R, E, L> view_;
  Buffer<typename E::template Constants<R>> constants_;
  Buffer<int> nodes_;
};

/// Where each node finds its parts of the element forces of all blocks.
struct ShellIncidence {
  std::vector<int> nodes, begin{0}, slots;
  ShellIncidence(const std::vector<HostShells>& blocks, const Numbering& numbering) {
    std::map<int, std::vector<int>> slots_of_node;
    int slot = 0;
    for (const HostShells& block : blocks)
      for (std::size_t i = 0; i < block.nodes.size(); ++i, ++slot)
        slots_of_node[numbering.internal_of_user[static_cast<std::size_t>(block.nodes[i])]].push_back(slot);
    for (const auto& [node, its_slots] : slots_of_node) {
      nodes.push_back(node);
      slots.insert(slots.end(), its_slots.begin(), its_slots.end());
      begin.push_back(static_cast<int>(slots.size()));
    }
  }
};

template <Backend B, class R>
class ShellForces final : public SectionForces<B, R> {
 public:
  /// The backend must outlive this; the model need not.
  ShellForces(B& backend, const Model& model, const Numbering& numbering,
              std::unique_ptr<SolidForces<R>> solids)
      : SectionForces<B, R>(backend, element_count(model), std::move(solids)) {
    const auto hosts = make_shell_blocks(model);
    const ShellIncidence incidence(hosts, numbering);
    node_count_ = static_cast<int>(incidence.nodes.size());
    incident_nodes_ = detail::upload(backend, incidence.nodes);
    begin_ = detail::upload(backend, incidence.begin);
    slots_ = detail::upload(backend, incidence.slots);
    const std::size_t slots = incidence.slots.size();
    f_element_ = detail::reserve<Vec4<R>>(backend, slots);
    this->bytes_ += slots * (sizeof(Vec4<R>) + 2 * sizeof(int));
    Vec4<R>* f_element = f_element_.get();
    double* energy = this->energies();
    for (const auto& host : hosts) {
      add(host, numbering, f_element, energy);
      f_element += host.nodes.size(), energy += host.section->elements.size();
    }
  }

 private:
  void add(const HostShells& host, const Numbering& numbering, Vec4<R>* f_element, double* energy) {
    with_types<R>(host, [&]<class E, class L>(const auto& constants) {
      this->add_block(std::make_unique<PlainShellBlock<B, R, E, L>>(this->backend_, host, constants,
                                                                    numbering, f_element, energy));
      this->bytes_ +=
          constants.size() * (sizeof(typename E::template Constants<R>) + E::node_count * sizeof(int));
    });
  }
  void add_shell_forces(const StepView<R>& step) override {
    this->forces_of_blocks(step);
    this->backend_.for_each(node_count_, GatherShells<R>{incident_nodes_.get(), begin_.get(), slots_.get(),
                                                         f_element_.get(), step.f});
  }

  int node_count_ = 0;
  Buffer<int> incident_nodes_, begin_, slots_;
  Buffer<Vec4<R>> f_element_;
};

}  // namespace glisson::shells
