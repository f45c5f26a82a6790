// Bench nodes mirrored on a backend. Include it only where benches are instantiated.
#pragma once

#include <memory>
#include <vector>

#include <glisson/core/loads/upload.hpp>
#include <glisson/cpu/emulated_device.hpp>
#include <glisson/cpu/serial.hpp>
#include <glisson/cpu/threads.hpp>

#include "tests/core/bench_nodes.hpp"

namespace glisson {

/// T<B, R> of a row, as an Interface.
template <class Interface, template <class, class> class T, class... Arguments>
std::unique_ptr<Interface> make_for(BenchCase row, const Arguments&... arguments) {
  switch (row) {
    case BenchCase::serial_double:
      return std::make_unique<T<Serial, double>>(arguments...);
    case BenchCase::serial_float:
      return std::make_unique<T<Serial, float>>(arguments...);
    case BenchCase::threads_double:
      return std::make_unique<T<Threads, double>>(arguments...);
    case BenchCase::threads_float:
      return std::make_unique<T<Threads, float>>(arguments...);
    case BenchCase::emulated_float:
      return std::make_unique<T<EmulatedDevice, float>>(arguments...);
  }
  return nullptr;
}

/// The user's numbering on the host, internal numbering on the backend.
template <class B, class R>
class NodesOnBackend {
 public:
  explicit NodesOnBackend(BenchNodes& nodes)
      : nodes_(nodes),
        u_(detail::zeros<Vec4<R>>(backend, nodes.u.size())),
        v_(detail::zeros<Vec4<R>>(backend, nodes.u.size())),
        f_(detail::zeros<Vec4<R>>(backend, nodes.u.size())),
        predicted_(detail::zeros<Vec4<R>>(backend, nodes.u.size())) {}

  /// The step that the device would see for the host's u and v; f starts at 0.
  StepView<R> view(double t, double dt) {
    put(nodes_.u, u_.get(), false);
    put(nodes_.v, v_.get(), true);
    backend.copy_in(std::vector<Vec4<R>>(nodes_.u.size()).data(), f_.get(), nodes_.u.size());
    StepView<R> step = arrays();
    step.t = t;
    step.dt = dt;
    step.step = nodes_.step_count;
    step.advance_per_force = R(dt * dt);
    step.monitor = true;
    return step;
  }
  StepView<R> arrays() const {
    StepView<R> step;
    step.u = u_.get();
    step.v = v_.get();
    step.f = f_.get();
    step.node_count = static_cast<int>(nodes_.u.size());
    return step;
  }
  void get_u() { get(u_.get(), nodes_.u); }
  void get_v() { get(v_.get(), nodes_.v); }
  void get_f() { get(f_.get(), nodes_.f); }
  void put_f(const std::vector<Vec3<double>>& f) { put(f, f_.get(), false); }
  const Vec4<R>* put_predicted(const std::vector<Vec3<double>>& u) {
    put(u, predicted_.get(), false);
    return predicted_.get();
  }
  Vec4<R>* u() { return u_.get(); }
  Vec4<R>* v() { return v_.get(); }

  B backend;

 private:
  void put(const std::vector<Vec3<double>>& from, Vec4<R>* to, bool inverse_mass) {
    std::vector<Vec4<R>> host(from.size());
    for (std::size_t n = 0; n < from.size(); ++n) {
      auto& a = host[std::size_t(nodes_.numbering.internal_of_user[n])];
      a = detail::narrow<R>(from[n]);
      if (inverse_mass) a.w = nodes_.masses[n] > 0 ? R(1 / nodes_.masses[n]) : R(0);
    }
    backend.copy_in(host.data(), to, host.size());
  }
  void get(const Vec4<R>* from, std::vector<Vec3<double>>& to) {
    std::vector<Vec4<R>> host(to.size());
    backend.copy_out(from, host.data(), host.size());
    for (std::size_t n = 0; n < to.size(); ++n) {
      const auto& a = host[std::size_t(nodes_.numbering.internal_of_user[n])];
      to[n] = {double(a.x), double(a.y), double(a.z)};
    }
  }

  BenchNodes& nodes_;
  Buffer<Vec4<R>> u_, v_, f_, predicted_;
};

}  // namespace glisson
