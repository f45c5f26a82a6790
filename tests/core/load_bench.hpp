// A bench for providers: nodes with u and v on any backend, forces back on the host.
#pragma once

#include <vector>

#include <glisson/core/loads/upload.hpp>
#include <glisson/cpu/emulated_device.hpp>
#include <glisson/cpu/serial.hpp>
#include <glisson/cpu/threads.hpp>

#include "tests/core/bench_nodes.hpp"

namespace glisson {

template <class Backend_, class R_>
struct Case {
  using Backend = Backend_;
  using R = R_;
};
template <class C>
using BackendOf = typename C::Backend;
template <class C>
using RealOf = typename C::R;
using BenchCases = ::testing::Types<Case<Serial, double>, Case<Serial, float>, Case<Threads, double>,
                                    Case<Threads, float>, Case<EmulatedDevice, float>>;

/// Nodes in the user's numbering on the outside, internal numbering and a backend inside.
template <class C>
class Bench : public BenchNodes {
  using B = BackendOf<C>;
  using R = RealOf<C>;

 public:
  explicit Bench(int count, double mass = 1)
      : BenchNodes(count, mass),
        u_(detail::zeros<Vec4<R>>(backend, u.size())),
        v_(detail::zeros<Vec4<R>>(backend, u.size())),
        f_(detail::zeros<Vec4<R>>(backend, u.size())),
        predicted_(detail::zeros<Vec4<R>>(backend, u.size())) {}

  /// The step that the device would see for the host's u and v; f starts at 0.
  StepView<R> view(double t, double dt) {
    put(u, u_.get(), false);
    put(v, v_.get(), true);
    backend.copy_in(std::vector<Vec4<R>>(u.size()).data(), f_.get(), u.size());
    StepView<R> step;
    step.u = u_.get();
    step.v = v_.get();
    step.f = f_.get();
    step.node_count = static_cast<int>(u.size());
    step.t = t;
    step.dt = dt;
    step.step = step_count;
    step.advance_per_force = R(dt * dt);
    step.monitor = true;
    return step;
  }
  /// Forces of a provider at the host's u and v.
  const std::vector<Vec3<double>>& forces(ForceProvider<R>& provider, const StepView<R>& step) {
    provider.add_forces(step);
    get(f_.get(), f);
    return f;
  }
  const std::vector<Vec3<double>>& forces(ForceProvider<R>& provider, double t = 1) {
    return forces(provider, view(t, 1));
  }
  void put(const std::vector<Vec3<double>>& from, Vec4<R>* to, bool inverse_mass) {
    std::vector<Vec4<R>> host(from.size());
    for (std::size_t n = 0; n < from.size(); ++n) {
      auto& a = host[std::size_t(numbering.internal_of_user[n])];
      a = detail::narrow<R>(from[n]);
      if (inverse_mass) a.w = masses[n] > 0 ? R(1 / masses[n]) : R(0);
    }
    backend.copy_in(host.data(), to, host.size());
  }
  void get(const Vec4<R>* from, std::vector<Vec3<double>>& to) {
    std::vector<Vec4<R>> host(to.size());
    backend.copy_out(from, host.data(), host.size());
    for (std::size_t n = 0; n < to.size(); ++n) {
      const auto& a = host[std::size_t(numbering.internal_of_user[n])];
      to[n] = {double(a.x), double(a.y), double(a.z)};
    }
  }
  Vec4<R>* predicted() { return predicted_.get(); }
  Vec4<R>* device_u() { return u_.get(); }
  Vec4<R>* device_v() { return v_.get(); }
  Vec4<R>* device_f() { return f_.get(); }
  static double tolerance() { return sizeof(R) == 4 ? 2e-6 : 1e-13; }

  B backend;

 private:
  Buffer<Vec4<R>> u_, v_, f_, predicted_;
};

}  // namespace glisson
