// What loads on a list of nodes share whose forces are proportional to the amplitude of one load curve.
#pragma once

#include <utility>

#include <glisson/core/loads/list_forces.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson {

/// Keeps the amplitude of the last step, from which such loads compute the force whose work is counted.
template <Backend B, class R>
class ScaledLoad : public ForceProvider<R> {
 public:
  Space space() const final { return B::space; }
  double work() const final { return work_.total(); }
  std::vector<std::byte> save() const final {
    detail::ByteWriter out;
    work_.save(out.value(amplitude_before_));
    return out.take();
  }
  void load(std::span<const std::byte> bytes) final {
    detail::ByteReader in(bytes, std::string(this->name()));
    in.value(amplitude_before_);
    work_.load(in);
    in.end();
  }

 protected:
  ScaledLoad(B& backend, LoadCurve curve, int entry_count)
      : curve_(std::move(curve)), work_(backend, entry_count) {}

  /// Adds the forces of rule(amplitude now, amplitude of the last step).
  template <class MakeRule>
  void run(const StepView<R>& step, const int* nodes, MakeRule rule) {
    const double amplitude = curve_(step.t);
    work_.run(step, nodes, rule(amplitude, amplitude_before_));
    if (step.advance) amplitude_before_ = amplitude * work_.share(step);
  }

 private:
  LoadCurve curve_;
  ListWork<B, R> work_;
  double amplitude_before_ = 0;
};

}  // namespace glisson
