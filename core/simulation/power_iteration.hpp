// The highest frequency of the assembled mesh, by power iteration on M^-1 K. K x comes from two evaluations
// of the element forces, so it is the tangent of the current state. Sharper than the element bound, which it
// can only confirm from below.
#pragma once

#include <cmath>

#include <glisson/core/simulation/node_state.hpp>
#include <glisson/core/solids/solid_forces.hpp>

namespace glisson {

template <class B, class R>
class PowerIteration {
 public:
  PowerIteration(B& backend, NodeState<B, R>& nodes, double length)
      : backend_(backend),
        nodes_(nodes),
        length_(length),
        x_(nodes.zeros()),
        y_(nodes.zeros()),
        g_(nodes.zeros()) {
    seed();
  }

  /// omega_max [1/s] after `iterations`; view.f must be zero and is left so. Starts from the last vector
  /// found.
  double omega(SolidForces<R>& solids, StepView<R> view, int iterations) {
    view.advance = false;
    view.monitor = false;
    solids.add_forces(view);
    backend_.for_each(nodes_.count(), Copy<R>{view.f, g_.get()});
    double omega = 0;
    for (int i = 0; i < iterations; ++i) omega = iterate(solids, view);
    backend_.for_each(nodes_.count(), ZeroForces<R>{view.f});
    return omega;
  }

  Vec4<R>* vector() const { return x_.get(); }
  std::size_t memory_bytes() const { return 3 * nodes_.size() * sizeof(Vec4<R>); }

 private:
  /// x <- M^-1 K x / |M^-1 K x|; the growth in the mass norm lies between the Rayleigh quotient and
  /// omega_max^2.
  double iterate(SolidForces<R>& solids, StepView<R> view) {
    const double size = std::sqrt(nodes_.largest(x_.get()));
    if (!(size > 0)) return 0;
    const double s =
        1e-3 * length_ / size;  // strains of about 1e-3: small for the tangent, large against rounding
    backend_.for_each(nodes_.count(), Displaced<R>{nodes_.u(), x_.get(), R(s), y_.get()});
    backend_.for_each(nodes_.count(), ZeroForces<R>{view.f});
    StepView<R> moved = view;
    moved.u = y_.get();
    solids.add_forces(moved);
    backend_.for_each(nodes_.count(),
                      ScaledForceDifference<R>{g_.get(), view.f, nodes_.v(), R(1 / s), y_.get()});
    const auto [xMx, yMy, largest_y] = nodes_.norms(x_.get(), y_.get());
    const double norm_x = std::sqrt(xMx), norm_y = std::sqrt(yMy);
    if (!(norm_y > 0) || !std::isfinite(norm_y)) return 0;
    backend_.for_each(nodes_.count(), Copy<R>{y_.get(), x_.get()});
    backend_.for_each(nodes_.count(), Scale<R>{x_.get(), R(1 / std::sqrt(largest_y))});
    return std::sqrt(norm_y / norm_x);
  }

  /// A fixed pseudo-random start: no mode is orthogonal to it, and every run begins alike.
  void seed() {
    std::vector<Vec4<R>> x(nodes_.size());
    std::uint32_t state = 12345;
    auto next = [&] {
      state = state * 1664525u + 1013904223u;
      return R(double(state >> 8) / double(1u << 24) - 0.5);
    };
    for (auto& a : x) a = {next(), next(), next(), R(0)};
    nodes_.put(x, x_.get());
  }

  B& backend_;
  NodeState<B, R>& nodes_;
  double length_;  ///< smallest element size [m]
  Buffer<Vec4<R>> x_, y_, g_;
};

}  // namespace glisson
