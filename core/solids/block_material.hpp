// The material of one block on a backend: parameters, Prony terms and history.
#pragma once

#include <utility>
#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/kernels/element_forces.hpp>
#include <glisson/core/solids/host_blocks.hpp>

namespace glisson {

template <Backend B, class R>
class BlockMaterial {
 public:
  /// Takes over the small parts of a block; its arrays are released.
  BlockMaterial(B& backend, HostBlock<R> host)
      : backend_(&backend),
        parameters_(upload_constant(backend, host.parameters.data(), host.parameters.size())),
        history_(backend.template allocate<R>(host.history_size())),
        terms_(backend.template allocate<PronyCoefficients<R>>(host.prony.size())),
        bytes_((host.parameters.size() + host.history_size()) * sizeof(R)) {
    if (host.viscous()) {
      const std::vector<R> zero(host.history_size(), R(0));
      backend.copy_in(zero.data(), history_.get(), zero.size());
    }
    host.constants = {}, host.nodes = {}, host.parameters = {};
    host_ = std::move(host);
  }

  const HostBlock<R>& host() const { return host_; }
  std::size_t memory_bytes() const { return bytes_; }
  void connect(BlockView<R>& view) const {
    view.parameters = parameters_.get();
    view.terms = terms_.get();
    view.history = history_.get();
    view.element_count = host_.element_count;
    view.isochoric_count = host_.isochoric_count;
    view.volumetric_count = static_cast<int>(host_.prony.size()) - host_.isochoric_count;
    view.per_element = host_.per_element;
  }
  /// Coefficients of the terms for steps of dt [s].
  void set_step(double dt) {
    if (!host_.viscous() || dt == dt_) return;
    std::vector<PronyCoefficients<R>> terms;
    for (const PronyTerm& term : host_.prony) {
      const auto exact = prony_coefficients(term.alpha, term.tau, dt);
      terms.push_back({R(exact.alpha), R(exact.rate)});
    }
    backend_->copy_in(terms.data(), terms_.get(), terms.size());
    dt_ = dt;
  }
  std::vector<R> history() const {
    std::vector<R> values(host_.history_size());
    backend_->copy_out(history_.get(), values.data(), values.size());
    return values;
  }
  void set_history(const std::vector<R>& values) {
    backend_->copy_in(values.data(), history_.get(), values.size());
  }

 private:
  B* backend_;
  HostBlock<R> host_;
  Buffer<R> parameters_, history_;
  Buffer<PronyCoefficients<R>> terms_;
  std::size_t bytes_;
  double dt_ = -1;  ///< step that the coefficients belong to [s]
};

/// Blocks: a range of what has a member `material`. The history of all in the canonical order.
template <class R, class Blocks>
std::vector<double> history_of(const Blocks& blocks) {
  std::vector<std::vector<R>> arrays;
  std::vector<const HostBlock<R>*> hosts;
  for (const auto& block : blocks) {
    arrays.push_back(block.material.history());
    hosts.push_back(&block.material.host());
  }
  return canonical_history(hosts, arrays);
}

template <class R, class Blocks>
void set_history_of(Blocks& blocks, const std::vector<double>& history) {
  std::vector<const HostBlock<R>*> hosts;
  for (const auto& block : blocks) hosts.push_back(&block.material.host());
  const auto arrays = block_history<R>(hosts, history);
  for (std::size_t k = 0; k < arrays.size(); ++k) blocks[k].material.set_history(arrays[k]);
}

/// Whether some block has elements with hourglass control.
template <class Blocks>
bool any_hourglass(const Blocks& blocks) {
  for (const auto& block : blocks) {
    const Formulation f = block.material.host().formulation;
    if (f == Formulation::h8 || f == Formulation::h8_fixed) return true;
  }
  return false;
}

}  // namespace glisson
