// A given force on each node of a list, f = A(t) F.
#pragma once

#include <glisson/core/loads/scaled_load.hpp>

namespace glisson {

template <class R>
struct GivenForce {
  const Vec4<R>* value;  ///< at amplitude 1 [N]  [entry_count]
  R amplitude, amplitude_before;

  GLISSON_HD Vec3<R> force(int i, int) const { return amplitude * xyz(value[i]); }
  GLISSON_HD Vec3<R> before(int i, int) const { return amplitude_before * xyz(value[i]); }
  GLISSON_HD void remember(int, const Vec3<R>&) const {}
};

/// A node that is listed twice gets both forces.
template <Backend B, class R>
class NodalForces final : public ScaledLoad<B, R> {
 public:
  NodalForces(B& backend, const NodalForce& load, const Numbering& numbering)
      : NodalForces(backend, load.curve, entries_of(load, numbering)) {}

  std::string_view name() const override { return "nodal force"; }
  void add_forces(const StepView<R>& step) override {
    this->run(step, nodes_.get(), [&](double amplitude, double before) {
      return GivenForce<R>{values_.get(), R(amplitude), R(before)};
    });
  }

 private:
  using Entries = std::map<int, Vec3<double>>;
  static Entries entries_of(const NodalForce& load, const Numbering& numbering) {
    return detail::by_node<Vec3<double>>(
        numbering, load.nodes,
        [&](std::size_t k) {
          return detail::on_axes(load.axes,
                                 detail::value_of(load.values, k, load.nodes.size(), "force values"));
        },
        [](Vec3<double>& sum, const Vec3<double>& more) { sum = sum + more; });
  }
  static std::vector<Vec4<R>> values_of(const Entries& entries) {
    std::vector<Vec4<R>> values;
    for (const auto& [node, force] : entries) values.push_back(detail::narrow<R>(force));
    return values;
  }
  NodalForces(B& backend, LoadCurve curve, const Entries& entries)
      : ScaledLoad<B, R>(backend, std::move(curve), static_cast<int>(entries.size())),
        nodes_(detail::upload(backend, detail::keys(entries))),
        values_(detail::upload(backend, values_of(entries))) {}

  Buffer<int> nodes_;
  Buffer<Vec4<R>> values_;
};

}  // namespace glisson
