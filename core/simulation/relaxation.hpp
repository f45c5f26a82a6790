// Adaptive dynamic relaxation: the run is damped critically for the lowest frequency that still moves, which
// is estimated on the way.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include <glisson/core/constraints/constraints.hpp>
#include <glisson/core/model.hpp>
#include <glisson/core/simulation/archive.hpp>
#include <glisson/core/simulation/node_state.hpp>

namespace glisson {

/// Underwood 1983 (in: Belytschko & Hughes, Computational Methods for Transient Analysis, ch. 5): the lowest
/// frequency that takes part is omega^2 = du.(f_int(n) - f_int(n-k)) / du.M du with du = u(n) - u(n-k);
/// critical damping is 2 omega. Differences over k = 10 steps instead of one, because rounding of f in float
/// would otherwise look like stiffness and freeze the last, slow part. The mass is fictitious (every element
/// gets the same stable step), the static solution does not depend on it.
template <class B, class R>
class DynamicRelaxation {
 public:
  static constexpr std::int64_t interval = 10;  ///< steps between two estimates

  DynamicRelaxation(B& backend, NodeState<B, R>& nodes, Constraints<B, R>& constraints,
                    const QuasiStatic& settings, std::int64_t ramp_steps, std::span<const double> mass)
      : backend_(backend),
        nodes_(nodes),
        constraints_(constraints),
        settings_(settings),
        ramp_steps_(ramp_steps),
        u_before_(nodes.zeros()),
        f_before_(nodes.zeros()),
        residual_(nodes.zeros()),
        carry_(nodes.zeros()) {
    for (const double m : mass) mass_norm_ += m * m;
    mass_norm_ = std::sqrt(mass_norm_);
  }

  double damping() const { return damping_; }
  std::int64_t ramp_steps() const { return ramp_steps_; }
  bool converged() const { return converged_; }
  bool ended(std::int64_t step) const { return converged_ || stalled_ || step >= settings_.max_steps; }
  /// How the run ended; empty while it runs.
  std::string ending(std::int64_t step) const {
    if (converged_) return "converged";
    if (stalled_ && far_from_rest())
      return "not converged: the residuals no longer fall, and rounding does not explain them; a part may be "
             "free to move away";
    if (stalled_)
      return "stalled: the residuals no longer fall; this is the accuracy of the precision in use";
    return step >= settings_.max_steps ? "not converged: MaxSteps reached" : "";
  }
  Vec4<R>* carry() const { return carry_.get(); }
  std::array<double, 2> residuals() const { return residuals_; }

  /// Share of the loads at `step`: smooth from 0 to 1 over the ramp.
  double load_share(std::int64_t step) const {
    if (step >= ramp_steps_) return 1;
    const double r = double(step) / double(ramp_steps_);
    return r * r * r * (10 + r * (-15 + 6 * r));
  }

  /// Called with the element forces alone in f: the scale that residuals are compared with.
  void note_internal_force(std::int64_t step) {
    if (step % interval == 0) internal_ = std::sqrt(nodes_.dot(nodes_.f(), nodes_.f(), false));
  }
  /// Called with all forces in f, before the nodes move.
  void update(std::int64_t step, double dt) {
    if (step % interval != 0) return;
    if (step > 0) {
      // u_before <- du, f_before <- f(before) - f(now)
      backend_.for_each(nodes_.count(), Displaced<R>{nodes_.u(), u_before_.get(), R(-1), u_before_.get()});
      backend_.for_each(nodes_.count(), Displaced<R>{f_before_.get(), nodes_.f(), R(-1), f_before_.get()});
      estimate_damping(dt);
      measure(dt);
    }
    backend_.for_each(nodes_.count(), Copy<R>{nodes_.u(), u_before_.get()});
    backend_.for_each(nodes_.count(), Copy<R>{nodes_.f(), f_before_.get()});
    if (step == 0) return;
    converged_ = step >= ramp_steps_ + interval &&
                 residuals_[0] < std::max(settings_.force_tolerance, rounding_) &&
                 residuals_[1] < std::max(settings_.displacement_tolerance,
                                          8 * double(std::numeric_limits<R>::epsilon()));
    watch_progress(step);
  }

  void save(std::ostream& out) const {
    write_value(out, Scalars{damping_, omega_, internal_, best_, rounding_, residuals_, best_step_,
                             converged_, stalled_});
    for (const Vec4<R>* a : {u_before_.get(), f_before_.get(), carry_.get()})
      write_array<Vec4<R>>(out, nodes_.get(a));
  }
  void load(std::istream& in) {
    const auto s = read_value<Scalars>(in);
    damping_ = s.damping, omega_ = s.omega, internal_ = s.internal, best_ = s.best, rounding_ = s.rounding,
    residuals_ = s.residuals;
    best_step_ = s.best_step, converged_ = s.converged, stalled_ = s.stalled;
    for (Vec4<R>* a : {u_before_.get(), f_before_.get(), carry_.get()})
      nodes_.put(read_array<Vec4<R>>(in, nodes_.size()), a);
  }

 private:
  struct Scalars {
    double damping, omega, internal, best, rounding;
    std::array<double, 2> residuals;
    std::int64_t best_step;
    bool converged, stalled;
  };

  void estimate_damping(double dt) {
    const double moving = nodes_.dot(u_before_.get(), u_before_.get(), true);
    const double stiff = nodes_.dot(u_before_.get(), f_before_.get(), false);
    const double omega2 = moving > 0 ? stiff / moving : 0;
    const bool readable = residuals_[0] > 4 * rounding_;  // else f(now) - f(before) is rounding
    if (omega2 > 0 && readable) omega_ = std::min(std::sqrt(omega2), 2 / dt);
    damping_ = std::min(2 * omega_, 1.8 / dt);  // 1 - h stays positive
  }
  bool far_from_rest() const {
    return residuals_[0] > 100 * std::max(settings_.force_tolerance, rounding_) ||
           residuals_[1] > 100 * settings_.displacement_tolerance;
  }
  /// Rounding ends the descent: no better residual for as long as the slowest mode needs to lose a factor of
  /// ten.
  void watch_progress(std::int64_t step) {
    const double now =
        std::max(residuals_[0] / settings_.force_tolerance, residuals_[1] / settings_.displacement_tolerance);
    if (step < ramp_steps_ || now < 0.9 * best_) best_ = now, best_step_ = step;
    stalled_ = step - best_step_ > std::max<std::int64_t>(2000, 4 * ramp_steps_);
  }
  void measure(double dt) {
    backend_.for_each(nodes_.count(), Copy<R>{nodes_.f(), residual_.get()});
    constraints_.project(residual_.get());
    const double force = std::sqrt(nodes_.dot(residual_.get(), residual_.get(), false));
    const double speed = std::sqrt(nodes_.largest(u_before_.get())) / (double(interval) * dt),
                 reach = std::sqrt(nodes_.largest(nodes_.u()));
    // u is rounded to half an ulp; a stiff node with m omega_max^2 / 2 = 2 m / dt^2 answers with this force,
    // which no step can remove
    const double ulp = double(std::numeric_limits<R>::epsilon()) * reach;
    rounding_ = internal_ > 0 ? 2 * mass_norm_ / (dt * dt) * ulp / internal_ : 0;
    residuals_[0] = internal_ > 0 ? force / internal_ : force > 0 ? 1.0 : 0.0;
    residuals_[1] = reach > 0 && omega_ > 0 ? speed / (omega_ * reach) : speed > 0 ? 1.0 : 0.0;
  }

  B& backend_;
  NodeState<B, R>& nodes_;
  Constraints<B, R>& constraints_;
  QuasiStatic settings_;
  std::int64_t ramp_steps_;
  Buffer<Vec4<R>> u_before_, f_before_, residual_, carry_;
  double mass_norm_ = 0;  ///< Euclidean norm of the nodal masses [kg]
  double rounding_ = 0;   ///< force residual that rounding of u causes [-]
  double damping_ = 0, omega_ = 0, internal_ = 0;
  double best_ =
      std::numeric_limits<double>::infinity();  ///< smallest residual over its tolerance so far [-]
  std::array<double, 2> residuals_{1, 1};
  std::int64_t best_step_ = 0;
  bool converged_ = false, stalled_ = false;
};

}  // namespace glisson
