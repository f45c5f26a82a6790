// A given force on each node of a list, f = A(t) F.
#pragma once

#include <glisson/core/loads/list_forces.hpp>
#include <glisson/core/loads/node_list.hpp>

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
class NodalForces final : public ForceProvider<R> {
 public:
  NodalForces(B& backend, const NodalForce& load, const Numbering& numbering)
      : NodalForces(backend, load.curve, entries_of(load, numbering)) {}

  std::string_view name() const override { return "nodal force"; }
  Space space() const override { return B::space; }
  void add_forces(const StepView<R>& step) override {
    const double amplitude = curve_(step.t);
    work_.run(step, nodes_.get(), GivenForce<R>{values_.get(), R(amplitude), R(amplitude_before_)});
    if (step.advance) amplitude_before_ = amplitude * work_.share(step);
  }
  double work() const override { return work_.total(); }
  std::vector<std::byte> save() const override {
    detail::ByteWriter out;
    work_.save(out.value(amplitude_before_));
    return out.take();
  }
  void load(std::span<const std::byte> bytes) override {
    detail::ByteReader in(bytes, "nodal force");
    in.value(amplitude_before_);
    work_.load(in);
    in.end();
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
      : curve_(std::move(curve)),
        nodes_(detail::upload(backend, detail::keys(entries))),
        values_(detail::upload(backend, values_of(entries))),
        work_(backend, static_cast<int>(entries.size())) {}

  LoadCurve curve_;
  Buffer<int> nodes_;
  Buffer<Vec4<R>> values_;
  ListWork<B, R> work_;
  double amplitude_before_ = 0;
};

}  // namespace glisson
