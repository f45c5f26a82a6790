// Membranes and shells in plain form on any backend: force per triangle, then a gather per node. Include it
// only where a backend is instantiated.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include <glisson/core/array_sum.hpp>
#include <glisson/core/backend.hpp>
#include <glisson/core/loads/upload.hpp>
#include <glisson/core/numbering.hpp>
#include <glisson/shells/internal_forces.hpp>
#include <glisson/shells/laws/laws.hpp>
#include <glisson/shells/shell_kernels.hpp>

namespace glisson::shells {

/// One section with its element and law as types.
template <class R>
class ShellBlock {
 public:
  virtual ~ShellBlock() = default;
  virtual void forces(const StepView<R>& step) = 0;
  virtual void energy(const StepView<R>& step) = 0;
  virtual std::size_t history_size() const = 0;          ///< [-]
  virtual void get_history(double* values) const = 0;  ///< [element][term][3]
  virtual void set_history(const double* values) = 0;
};

template <Backend B, class R, class E, class L>
class TypedShellBlock final : public ShellBlock<R> {
 public:
  /// f_element and energy: where the block's own parts begin.
  TypedShellBlock(B& backend, const HostShells& host,
                  const std::vector<typename E::template Constants<double>>& constants,
                  const Numbering& numbering, Vec4<R>* f_element, double* energy)
      : backend_(backend), prony_(host.section->prony) {
    std::vector<typename E::template Constants<R>> own;
    for (const auto& c : constants) own.push_back(narrowed<R, E::template Constants>(c));
    std::vector<int> nodes;
    for (const int n : host.nodes) nodes.push_back(numbering.internal_of_user[static_cast<std::size_t>(n)]);
    constants_ = detail::upload(backend, own);
    nodes_ = detail::upload(backend, nodes);
    history_ = detail::zeros<R>(backend, 3 * prony_.size() * constants.size());
    terms_ = detail::reserve<PronyCoefficients<R>>(backend, prony_.size());
    std::vector<R> parameters;
    for (const double p : host.section->parameters) parameters.push_back(R(p));
    view_.law = L::load(parameters.data());
    view_.constants = constants_.get(), view_.nodes = nodes_.get();
    view_.f_element = f_element, view_.energy = energy;
    view_.element_count = static_cast<int>(constants.size());
    view_.history = {history_.get(), terms_.get(), static_cast<int>(prony_.size()), view_.element_count};
    view_.wrinkling = host.section->wrinkling;
  }

  void forces(const StepView<R>& step) override {
    set_terms(step.dt);
    backend_.for_each(view_.element_count, ShellForcesBody<R, E, L>{view_, step.u, step.advance});
  }
  void energy(const StepView<R>& step) override {
    backend_.for_each(view_.element_count, ShellEnergyBody<R, E, L>{view_, step.u});
  }
  std::size_t history_size() const override {
    return 3 * prony_.size() * static_cast<std::size_t>(view_.element_count);
  }
  void get_history(double* values) const override {
    std::vector<R> own(history_size());
    if (own.empty()) return;
    backend_.copy_out(history_.get(), own.data(), own.size());
    const std::size_t rows = 3 * prony_.size(), count = own.size() / rows;
    for (std::size_t e = 0; e < count; ++e)
      for (std::size_t k = 0; k < rows; ++k) values[e * rows + k] = double(own[k * count + e]);
  }
  void set_history(const double* values) override {
    std::vector<R> own(history_size());
    if (own.empty()) return;
    const std::size_t rows = 3 * prony_.size(), count = own.size() / rows;
    for (std::size_t e = 0; e < count; ++e)
      for (std::size_t k = 0; k < rows; ++k) own[k * count + e] = R(values[e * rows + k]);
    backend_.copy_in(own.data(), history_.get(), own.size());
  }

 private:
  void set_terms(double dt) {
    if (prony_.empty() || dt == dt_) return;
    std::vector<PronyCoefficients<R>> terms;
    for (const PronyTerm& term : prony_) {
      const auto exact = prony_coefficients(term.alpha, term.tau, dt);
      terms.push_back({R(exact.alpha), R(exact.rate)});
    }
    backend_.copy_in(terms.data(), terms_.get(), terms.size());
    dt_ = dt;
  }

  B& backend_;
  std::vector<PronyTerm> prony_;
  ShellView<R, E, L> view_;
  Buffer<typename E::template Constants<R>> constants_;
  Buffer<int> nodes_;
  Buffer<R> history_;
  Buffer<PronyCoefficients<R>> terms_;
  double dt_ = -1;  ///< step that the coefficients belong to [s]
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
class ShellForces final : public InternalForces<R> {
 public:
  /// The backend must outlive this; the model need not.
  ShellForces(B& backend, const Model& model, const Numbering& numbering,
              std::unique_ptr<SolidForces<R>> solids)
      : InternalForces<R>(std::move(solids)), backend_(backend), sum_(backend) {
    const auto hosts = make_shell_blocks(model);
    const ShellIncidence incidence(hosts, numbering);
    node_count_ = static_cast<int>(incidence.nodes.size());
    incident_nodes_ = detail::upload(backend, incidence.nodes);
    begin_ = detail::upload(backend, incidence.begin);
    slots_ = detail::upload(backend, incidence.slots);
    std::size_t slots = 0, elements = 0;
    for (const auto& host : hosts) slots += host.nodes.size(), elements += host.section->elements.size();
    f_element_ = detail::reserve<Vec4<R>>(backend, slots);
    energy_ = detail::reserve<double>(backend, elements);
    element_count_ = elements;
    bytes_ = slots * (sizeof(Vec4<R>) + 2 * sizeof(int)) + elements * sizeof(double);
    slots = 0, elements = 0;
    for (const auto& host : hosts) {
      add_block(host, numbering, f_element_.get() + slots, energy_.get() + elements);
      slots += host.nodes.size(), elements += host.section->elements.size();
    }
  }

  Space space() const override { return B::space; }

 private:
  void add_shell_forces(const StepView<R>& step) override {
    for (auto& block : blocks_) block->forces(step);
    backend_.for_each(node_count_, GatherShells<R>{incident_nodes_.get(), begin_.get(), slots_.get(),
                                                   f_element_.get(), step.f});
  }
  double energy_of_shells(const StepView<R>& step) override {
    for (auto& block : blocks_) block->energy(step);
    return sum_(energy_.get(), static_cast<int>(element_count_));
  }
  std::size_t shell_history_size() const override {
    std::size_t size = 0;
    for (const auto& block : blocks_) size += block->history_size();
    return size;
  }
  void get_shell_history(double* values) const override {
    for (const auto& block : blocks_) {
      block->get_history(values);
      values += block->history_size();
    }
  }
  void set_shell_history(const double* values) override {
    for (auto& block : blocks_) {
      block->set_history(values);
      values += block->history_size();
    }
  }
  std::size_t shell_bytes() const override { return bytes_; }

  void add_block(const HostShells& host, const Numbering& numbering, Vec4<R>* f_element, double* energy) {
    const auto make = [&]<class E, class L>(const auto& constants) {
      if (host.section->law != L::name) return;
      blocks_.push_back(std::make_unique<TypedShellBlock<B, R, E, L>>(backend_, host, constants, numbering,
                                                                      f_element, energy));
      bytes_ += constants.size() * (sizeof(typename E::template Constants<R>) + E::node_count * sizeof(int));
    };
    if (host.bends())
      for_each_type(ShellLaws<R>{},
                    [&]<class L>() { make.template operator()<RotationFree, L>(host.shells); });
    else
      for_each_type(MembraneLaws<R>{},
                    [&]<class L>() { make.template operator()<Membrane, L>(host.membranes); });
  }

  B& backend_;
  std::vector<std::unique_ptr<ShellBlock<R>>> blocks_;
  int node_count_ = 0;
  std::size_t element_count_ = 0, bytes_ = 0;
  Buffer<int> incident_nodes_, begin_, slots_;
  Buffer<Vec4<R>> f_element_;
  Buffer<double> energy_;
  ArraySum<B> sum_;
};

}  // namespace glisson::shells
