// Carries a user's ForceProvider<double> through a run of any device and precision: mirrors u and v in the
// user's numbering, calls it, adds its f. The one place where the engine copies state because of a provider,
// and it counts what that costs.
#pragma once

#include <chrono>
#include <memory>

#include <glisson/core/simulation/node_state.hpp>

namespace glisson {

template <class R>
struct AddNodes {
  const Vec4<R>* g;
  Vec4<R>* f;
  GLISSON_HD void operator()(int n) const {
    f[n] = {f[n].x + g[n].x, f[n].y + g[n].y, f[n].z + g[n].z, f[n].w};
  }
};

template <class B, class R>
class UserForces {
 public:
  UserForces(B& backend, NodeState<B, R>& nodes, const Numbering& numbering,
             std::unique_ptr<ForceProvider<double>> provider)
      : backend_(backend),
        nodes_(nodes),
        numbering_(numbering),
        provider_(std::move(provider)),
        sum_(nodes.zeros()),
        u_(nodes.size()),
        v_(nodes.size()),
        f_(nodes.size()) {}

  ForceProvider<double>& provider() { return *provider_; }
  const ForceProvider<double>& provider() const { return *provider_; }
  double seconds() const { return seconds_; }

  void add_forces(const StepView<R>& view) {
    const auto start = std::chrono::steady_clock::now();
    fetch(view.u, u_);
    fetch(view.v, v_);
    std::fill(f_.begin(), f_.end(), Vec4<double>{});
    auto own = without_arrays<double>(view);
    own.u = u_.data();
    own.v = v_.data();
    own.f = f_.data();
    own.node_count = view.node_count;
    provider_->add_forces(own);
    add(view.f);
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

 private:
  void fetch(const Vec4<R>* from, std::vector<Vec4<double>>& to) {
    const auto host = nodes_.get(from);
    for (std::size_t n = 0; n < host.size(); ++n) {
      const auto& a = host[n];
      to[static_cast<std::size_t>(numbering_.user_of_internal[n])] = {double(a.x), double(a.y), double(a.z),
                                                                      double(a.w)};
    }
  }
  void add(Vec4<R>* f) {
    std::vector<Vec4<R>> host(f_.size());
    for (std::size_t n = 0; n < host.size(); ++n) {
      const auto& a = f_[static_cast<std::size_t>(numbering_.user_of_internal[n])];
      host[n] = {R(a.x), R(a.y), R(a.z), R(0)};
    }
    nodes_.put(host, sum_.get());
    backend_.for_each(nodes_.count(), AddNodes<R>{sum_.get(), f});
  }

  B& backend_;
  NodeState<B, R>& nodes_;
  const Numbering& numbering_;
  std::unique_ptr<ForceProvider<double>> provider_;
  Buffer<Vec4<R>> sum_;
  std::vector<Vec4<double>> u_, v_, f_;
  double seconds_ = 0;
};

}  // namespace glisson
