// Weight of nodes, f = A(t) m g. The mass comes from the caller and is not the one that mass scaling may have
// raised.
#pragma once

#include <glisson/core/loads/scaled_load.hpp>

namespace glisson {

template <class R>
struct Weight {
  const R* mass;        ///< [kg]  [entry_count]
  Vec3<R> g, g_before;  ///< A g now and at the last step [m/s^2]

  GLISSON_HD Vec3<R> force(int i, int) const { return mass[i] * g; }
  GLISSON_HD Vec3<R> before(int i, int) const { return mass[i] * g_before; }
  GLISSON_HD void remember(int, const Vec3<R>&) const {}
};

/// Over all nodes it holds one number per node and one double per 16 nodes.
template <Backend B, class R>
class GravityLoad final : public ScaledLoad<B, R> {
 public:
  /// mass: [kg] in internal order [node_count].
  GravityLoad(B& backend, const Gravity& load, const Numbering& numbering, std::span<const double> mass)
      : GravityLoad(backend, load, entries_of(load, numbering), mass) {}

  std::string_view name() const override { return "gravity"; }
  void add_forces(const StepView<R>& step) override {
    this->run(step, everywhere_ ? nullptr : nodes_.get(), [&](double amplitude, double before) {
      return Weight<R>{mass_.get(), times(amplitude), times(before)};
    });
  }

 private:
  using Entries = std::map<int, double>;  ///< how often a node is listed [-]
  static Entries entries_of(const Gravity& load, const Numbering& numbering) {
    return detail::by_node<double>(
        numbering, load.nodes, [](std::size_t) { return 1.0; },
        [](double& sum, double more) { sum += more; });
  }
  static std::vector<R> masses(const Entries& entries, std::span<const double> mass) {
    std::vector<R> result;
    for (const auto& [node, times] : entries) result.push_back(R(times * mass[std::size_t(node)]));
    if (entries.empty())
      for (const double m : mass) result.push_back(R(m));
    return result;
  }
  GravityLoad(B& backend, const Gravity& load, const Entries& entries, std::span<const double> mass)
      : ScaledLoad<B, R>(backend, load.curve,
                         static_cast<int>((entries.empty() ? mass.size() : entries.size()))),
        acceleration_(load.acceleration),
        everywhere_(entries.empty()),
        nodes_(detail::upload(backend, detail::keys(entries))),
        mass_(detail::upload(backend, masses(entries, mass))) {}

  Vec3<R> times(double amplitude) const {
    const Vec3<double> g = amplitude * acceleration_;
    return {R(g.x), R(g.y), R(g.z)};
  }

  Vec3<double> acceleration_;
  bool everywhere_;
  Buffer<int> nodes_;
  Buffer<R> mass_;
};

}  // namespace glisson
