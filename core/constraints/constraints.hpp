// Fixed nodes, prescribed displacements and sliding planes of a run. Include it only where a backend is
// instantiated.
#pragma once

#include <algorithm>
#include <vector>

#include <glisson/core/constraints/constrain_nodes.hpp>
#include <glisson/core/kernels/complete_nodes.hpp>

namespace glisson {

/// The stepper treats every node as free; apply() then sets the constrained nodes. With energies wanted,
/// add_reactions() goes before the stepper: the reactions become forces like all others, so that kinetic
/// energy and damping of the node update are those of the constrained motion and their work closes the
/// balance.
template <Backend B, class R>
class Constraints {
 public:
  Constraints(B& backend, const Model& model, const Numbering& numbering)
      : Constraints(backend, make_constraint_list(model, numbering),
                    static_cast<int>(numbering.user_of_internal.size())) {}

  int count() const { return count_; }

  /// f += reactions of this step, and their work up to `step.t`. t_next: time of the displacement that the
  /// step leads to [s].
  template <class Stepper>
  void add_reactions(const StepView<R>& step, double t_next, const Stepper& stepper) {
    if (count_ == 0) return;
    set_targets(t_next, step.dt);
    work_.run(step, nodes_.get(),
              Reaction<R, Stepper>{{last_.get()}, view(), step.v, step.f, rates(), stepper});
  }

  /// u(t_next) = sum A(t_next) value and v = (u(t_next) - u(t)) / dt on prescribed axes, 0 on fixed ones and
  /// along plane normals. The amplitude that was applied last counts as that of time t (0 at the start), so
  /// that a jump of a curve is a motion.
  void apply(Vec4<R>* u, Vec4<R>* v, double t_next, double dt) {
    if (count_ == 0) return;
    set_targets(t_next, dt);
    backend_.for_each(count_, ConstrainNodes<R>{view(), u, v, node_count_, displacements(), rates()});
    applied_ = amplitudes_;
  }

  /// The same as part of a sweep over all nodes: reactions, their work and the constraint. The targets are
  /// those of the step until finish() is called.
  template <class Stepper>
  NodeConstraints<R, Stepper> for_sweep(const StepView<R>& step, double t_next, const Stepper& stepper) {
    if (count_ == 0) return {};
    set_targets(t_next, step.dt);
    return {entry_of_node_.get(), {{last_.get()}, view(), step.v, step.f, rates(), stepper},
            displacements(),      work_.half_dt(),
            R(work_.share(step)), sweep_work_.get()};
  }
  /// After the sweep.
  void finish(const StepView<R>& step) {
    applied_ = amplitudes_;
    work_.finish(step);
  }

  /// The displacement of constrained nodes at t_next, nothing else: for predictions.
  void place(Vec4<R>* u, double t_next, double dt) {
    if (count_ == 0) return;
    set_targets(t_next, dt);
    backend_.for_each(count_, ProjectNodes<R>{view(), u, displacements()});
  }

  /// a <- its part in the free directions; for residual forces and initial velocities.
  void project(Vec4<R>* a) {
    if (count_ > 0) backend_.for_each(count_, ProjectNodes<R>{view(), a, {}});
  }

  /// Work of the reactions since the start [J].
  double work() const {
    double sum = work_.total();
    for (const double part : sweep_work()) sum += part;
    return sum;
  }
  std::vector<std::byte> save() const {
    detail::ByteWriter out;
    for (const double amplitude : applied_) out.value(amplitude);
    work_.save(out.buffer(backend_, last_, std::size_t(count_)));
    out.buffer(backend_, sweep_work_, sweep_chunks());
    return out.take();
  }
  void load(std::span<const std::byte> bytes) {
    detail::ByteReader in(bytes, "constraints");
    for (double& amplitude : applied_) in.value(amplitude);
    in.buffer(backend_, last_, std::size_t(count_));
    work_.load(in);
    in.buffer(backend_, sweep_work_, sweep_chunks());
    in.end();
  }

 private:
  Constraints(B& backend, ConstraintList list, int node_count)
      : backend_(backend),
        count_(list.count()),
        node_count_(node_count),
        curves_(std::move(list.curves)),
        amplitudes_(curves_.size()),
        applied_(curves_.size()),
        rates_(curves_.size()),
        nodes_(detail::upload(backend, list.nodes)),
        axes_(detail::upload(backend, list.axes)),
        value_begin_(detail::upload(backend, list.value_begin)),
        plane_begin_(detail::upload(backend, list.plane_begin)),
        values_(detail::upload(backend, list.values)),
        planes_(detail::upload(backend, list.planes)),
        many_(detail::zeros<double>(backend, 2 * curves_.size())),
        last_(detail::zeros<Vec4<R>>(backend, std::size_t(count_))),
        work_(backend, count_) {
    if (B::space == Space::host || count_ == 0) return;  // where launches cost nothing there is no sweep
    std::vector<int> entry(std::size_t(node_count_), -1);
    for (int i = 0; i < count_; ++i) entry[std::size_t(list.nodes[std::size_t(i)])] = i;
    entry_of_node_ = detail::upload(backend, entry);
    sweep_work_ = detail::zeros<double>(backend, sweep_chunks());
  }

  std::size_t sweep_chunks() const {
    return entry_of_node_ ? std::size_t(chunks_of(node_count_, node_energy_chunk)) : 0;
  }
  std::vector<double> sweep_work() const {
    std::vector<double> host(sweep_chunks());
    if (!host.empty()) backend_.copy_out(sweep_work_.get(), host.data(), host.size());
    return host;
  }

  void set_targets(double t_next, double dt) {
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      amplitudes_[k] = curves_[k](t_next);
      rates_[k] = (amplitudes_[k] - applied_[k]) / dt;
    }
    if (curves_.size() <= CurveValues::by_value) return;
    backend_.copy_in(amplitudes_.data(), many_.get(), curves_.size());
    backend_.copy_in(rates_.data(), many_.get() + curves_.size(), curves_.size());
  }
  CurveValues curve_values(const std::vector<double>& values, const double* many) const {
    CurveValues result;
    if (values.size() > CurveValues::by_value)
      result.many = many;
    else
      std::copy(values.begin(), values.end(), result.few);
    return result;
  }
  CurveValues displacements() const { return curve_values(amplitudes_, many_.get()); }
  CurveValues rates() const { return curve_values(rates_, many_.get() + curves_.size()); }
  ConstraintView view() const {
    return {nodes_.get(), axes_.get(), value_begin_.get(), values_.get(), plane_begin_.get(), planes_.get()};
  }

  B& backend_;
  int count_, node_count_;
  std::vector<LoadCurve> curves_;
  std::vector<double> amplitudes_;  ///< at t_next [-]            [curve_count]
  std::vector<double> applied_;     ///< as applied last [-]      [curve_count]
  std::vector<double> rates_;       ///< between the two [1/s]    [curve_count]
  Buffer<int> nodes_;
  Buffer<unsigned> axes_;
  Buffer<int> value_begin_, plane_begin_;
  Buffer<PrescribedValue> values_;
  Buffer<PlaneProjection> planes_;
  Buffer<double> many_;  ///< amplitudes, then rates, when there are many curves
  Buffer<Vec4<R>> last_;
  ListWork<B, R> work_;
  Buffer<int> entry_of_node_;  ///< for sweeps, see NodeConstraints
  Buffer<double> sweep_work_;  ///< done in sweeps [J]  [sweep_chunks()]
};

}  // namespace glisson
