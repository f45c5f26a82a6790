// Simulation: the stable step, energies and failure. Included by simulation.hpp.
#pragma once

namespace glisson {

/// Roughly, from the box of the nodes and their number [m].
inline double node_spacing(const Mesh& mesh) {
  Vec3<double> low = mesh.X.front(), high = low;
  for (const auto& X : mesh.X) {
    low = {std::min(low.x, X.x), std::min(low.y, X.y), std::min(low.z, X.z)};
    high = {std::max(high.x, X.x), std::max(high.y, X.y), std::max(high.z, X.z)};
  }
  return std::sqrt(dot(high - low, high - low)) / std::cbrt(double(mesh.X.size()));
}

/// Steps between two estimates of the stable step: 7 force evaluations each, ten times a run or every 500
/// steps; often while the loads of a static run grow, because that is when elements change their shape fast.
template <Backend B, class R>
std::int64_t Simulation<B, R>::recheck_interval() const {
  if (relaxation_) return step_ < relaxation_->ramp_steps() ? 25 : 500;
  return std::clamp<std::int64_t>(plan_.last_step() / 10, 25, 500);
}

/// The stable step [s] of the present state. A provider's stiffness adds to the elements': omega^2 = sum of
/// omega_i^2.
template <Backend B, class R>
double Simulation<B, R>::stable_step_now(int iterations) {
  // Power iteration converges from below (too large a step); 3 % covers what is missing after these many
  // iterations, see doc/time-step.md. At rest the element bound holds whatever the iteration says.
  constexpr double margin = 1.03;
  const double omega = margin * power_.omega(*parts_.solids, make_view(), iterations);
  double dt = omega > 0 ? 2 / omega : parts_.element_step.dt;
  if (step_ == 0) {
    // the iteration finds only those one-sided parts stiff that its vectors happen to pull
    dt = one_sided_ ? parts_.element_step.dt : std::max(dt, parts_.element_step.dt);
  }
  double inverse_square = 1 / (dt * dt);
  auto add = [&](double own) { inverse_square += std::isfinite(own) && own > 0 ? 1 / (own * own) : 0; };
  for (const auto& load : parts_.loads) add(load->stable_step());
  for (const auto& user : users_) add(user->provider().stable_step());
  return 1 / std::sqrt(inverse_square);
}

/// The element with the smallest step, or a provider that allows less than it.
template <Backend B, class R>
std::string Simulation<B, R>::limiter() const {
  const auto& e = parts_.element_step;
  double smallest = e.dt;
  std::string name = e.triangle >= 0 ? triangle_text(model_, e.triangle) : element_text(model_, e.element);
  auto compare = [&](const auto& provider) {
    if (provider.stable_step() < smallest) smallest = provider.stable_step(), name = provider.name();
  };
  for (const auto& load : parts_.loads) compare(*load);
  for (const auto& user : users_) compare(user->provider());
  return name;
}

template <Backend B, class R>
void Simulation<B, R>::choose_step() {
  stable_step_ = stable_step_now(40);
  limited_by_ = limiter();
  const TimeSettings& time = model_.time;
  if (!(stable_step_ > 0) || !std::isfinite(stable_step_))
    throw Error(ErrorKind::input, "The stable time step could not be estimated (" +
                                      std::to_string(stable_step_) +
                                      " s). The model needs elements with positive stiffness and mass.");
  const double wish = time.safety * stable_step_;
  if (relaxation_)
    plan_ = StepPlan::endless(wish);
  else
    plan_ = StepPlan(time.total, time.step.value_or(wish));
  const double speed = node_spacing(model_.mesh) / plan_.dt();
  rounding_energy_ = 1e-16 * speed * speed * std::accumulate(parts_.mass.begin(), parts_.mass.end(), 0.0);
  const std::int64_t automatic = std::max<std::int64_t>(20, plan_.last_step() / 100);
  monitor_every_ = time.monitor_every > 0 ? time.monitor_every : relaxation_ ? 100 : automatic;
  next_recheck_ = recheck_interval();
}

/// Before a step whose energies are accounted: what has to be known of the state at its start. A device goes
/// on with the step meanwhile, unless a provider wants to know.
template <Backend B, class R>
void Simulation<B, R>::review() {
  const StepView<R> view = make_view();
  strain_sum_ = parts_.solids->strain_energy(view);
  hourglass_sum_ = parts_.solids->hourglass_energy(view);
  if (watched_) watched_->find(nodes_.u());
  if (capped_ || !users_.empty()) strain_energy_ = strain_sum_.read();
}

template <Backend B, class R>
void Simulation<B, R>::recheck_stable_step() {
  next_recheck_ = step_ + recheck_interval();
  const double now = stable_step_now(6);
  if (!std::isfinite(now)) return;  // account() names what went wrong
  stable_step_ = now;
  const bool automatic = relaxation_ || !model_.time.step;
  if (automatic && plan_.dt() > 0.95 * now) plan_.shorten(step_, model_.time.safety * now);
}

/// All that has to come from the backend for an account.
template <Backend B, class R>
Energies Simulation<B, R>::read_energies() const {
  Energies parts = monitor_.node_sums();
  parts.strain = strain_sum_.read();
  parts.shell = parts_.solids->shell_energy();
  parts.hourglass = hourglass_sum_.read();
  for (const auto& load : parts_.loads) parts.external += load->work();
  for (const auto& body : parts_.bodies) parts.contact += body->work();
  parts.prescribed = parts_.constraints->work();
  return parts;
}

/// Closes the energy account of time t, after the nodes have moved on to t + dt.
template <Backend B, class R>
void Simulation<B, R>::account(double t) {
  Energies parts;
  copy_together(backend_, [&] {
    parts = read_energies();
    if (watched_) largest_displacement_ = watched_->read();
  });
  for (const auto& user : users_) parts.external += user->provider().work();
  strain_energy_ = parts.strain;
  const double share = monitor_.close(t, parts, prony_ || relaxation_.has_value());
  const Energies& now = monitor_.last();
  if (!std::isfinite(now.kinetic) || !std::isfinite(now.strain)) fail(nullptr, share);
  const double tolerance = model_.time.energy_tolerance;
  const bool at_rest = std::isfinite(share) && largest_term(now) < rounding_energy_;
  if (tolerance > 0 && !(share <= tolerance) && !at_rest) fail(&now, share);
  healthy_step_ = step_ + 1;
}

/// u of the check that passed is kept when the next step begins: after an account nothing is left to do.
template <Backend B, class R>
void Simulation<B, R>::keep_healthy() {
  if (step_ > 0 && healthy_step_ == step_)
    backend_.for_each(nodes_.count(), Copy<R>{nodes_.u(), healthy_.get()});
}

template <Backend B, class R>
void Simulation<B, R>::fail(const Energies* unbalanced, double share) {
  const auto u = displacement();
  const auto healthy =
      healthy_step_ > 0 ? nodes_.for_user(healthy_.get(), parts_.numbering) : std::vector<Vec3<double>>();
  FailureContext context;
  context.u = u;
  context.healthy = healthy;
  context.step = step_ + 1;
  context.healthy_step = healthy_step_;
  context.time = time();
  context.report = report();
  context.stable_now = stable_step_;
  const std::string text =
      unbalanced ? imbalance_message(model_, context, *unbalanced, share, model_.time.energy_tolerance)
                 : not_finite_message(model_, context);
  throw Error(ErrorKind::run, text, {model_.name, 0, ""});
}

template <Backend B, class R>
StepReport Simulation<B, R>::report() const {
  double user_seconds = 0;
  for (const auto& user : users_) user_seconds += user->seconds();
  return {plan_.dt(),        stable_step_,      limited_by_,
          parts_.added_mass, plan_.last_step(), relaxation_ ? relaxation_->ending(step_) : std::string(),
          monitor_every_,    user_seconds};
}

template <Backend B, class R>
std::array<double, 2> Simulation<B, R>::residuals() const {
  return relaxation_ ? relaxation_->residuals() : std::array<double, 2>{0, 0};
}

}  // namespace glisson
