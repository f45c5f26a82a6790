// Simulation: one step. Included by simulation.hpp.
#pragma once

namespace glisson {

template <Backend B, class R>
void Simulation<B, R>::step(std::int64_t count) {
  for (std::int64_t i = 0; i < count && !finished(); ++i) {
    one_step();
    if constexpr (requires { backend_.step_done(); }) backend_.step_done();
  }
  if constexpr (requires { backend_.wait(); })
    if (healthy_step_ != step_) backend_.wait();  // an account has waited for all
}

template <Backend B, class R>
bool Simulation<B, R>::finished() const {
  return relaxation_ ? relaxation_->ended(step_) : plan_.finished(step_);
}

/// The time that load curves see: in quasi-static mode the loads grow to their final value over the ramp,
/// whose length is nobody's business if the model names none.
template <Backend B, class R>
double Simulation<B, R>::load_time(std::int64_t step) const {
  if (!relaxation_) return plan_.time(step);
  const double total = model_.time.total > 0 ? model_.time.total : pseudo_time;
  return total * relaxation_->load_share(step);
}

template <Backend B, class R>
double Simulation<B, R>::time() const {
  return load_time(step_);
}

template <Backend B, class R>
template <class F>
void Simulation<B, R>::with_stepper(F&& use) const {
  const double damping = relaxation_ ? relaxation_->damping() : model_.time.damping;
  const double interval = plan_.force_interval(step_);
  if (stepper_ == Stepper::newmark)
    use(Newmark<R>::make(damping, interval, plan_.dt()));
  else
    use(CentralDifference<R>::make(damping, interval, plan_.dt()));
}

template <Backend B, class R>
StepView<R> Simulation<B, R>::make_view() const {
  StepView<R> view;
  view.u = nodes_.u();
  view.v = nodes_.v();
  view.f = nodes_.f();
  view.node_count = nodes_.count();
  view.step = step_;
  view.t = load_time(step_);
  view.t_next = load_time(step_ + 1);
  // a static solution is one of infinite time: Prony terms are fully relaxed
  view.dt = relaxation_ ? 1e30 : plan_.dt();
  const double damping = relaxation_ ? relaxation_->damping() : model_.time.damping;
  const double interval = plan_.force_interval(step_);
  view.advance_per_force = R(plan_.dt() * interval / (1 + 0.5 * damping * interval));
  view.monitor = !relaxation_;
  view.strain_energy = strain_energy_;
  view.stream = backend_.stream();
  return view;
}

/// Returns what a sweep over the nodes has still to add; nothing unless it may be left.
template <Backend B, class R>
SharedForces<R> Simulation<B, R>::add_forces(StepView<R>& view, bool may_leave) {
  SharedForces<R> left;
  if (may_leave)
    left = parts_.solids->add_all_but_shared(view);
  else
    parts_.solids->add_forces(view);
  if (relaxation_) relaxation_->note_internal_force(step_);
  for (auto& load : parts_.loads) load->add_forces(view);
  for (auto& user : users_)
    if (!user->provider().needs_prediction()) user->add_forces(view);
  return left;
}

template <Backend B, class R>
void Simulation<B, R>::predict(const StepView<R>& view) const {
  with_stepper([&]<class S>(const S& stepper) {
    const PredictNodes<R, S> body{view.u, view.v, view.f, u_predicted_.get(), stepper, nodes_.count()};
    if (predicted_count_ > 0)
      backend_.for_each(predicted_count_, PredictListed<R, S>{body, predicted_nodes_.get()});
    else
      backend_.for_each(nodes_.count(), body);
  });
  parts_.constraints->place(u_predicted_.get(), view.t_next, plan_.dt());
}

/// Contact sees where the nodes would be without it, constrained nodes where they will be.
template <Backend B, class R>
void Simulation<B, R>::predict_and_touch(StepView<R>& view) const {
  if (!u_predicted_) return;
  predict(view);
  view.u_predicted = u_predicted_.get();
  bool complete = true;  // all forces so far are in the prediction
  for (auto& body : parts_.bodies) {
    if (!complete && body->needs_forces_before()) predict(view);
    body->add_forces(view);
    complete = body->moves_prediction();
    if (complete) predict(view);
  }
}

template <Backend B, class R>
void Simulation<B, R>::advance(bool energies) {
  with_stepper([&]<class S>(const S& stepper) {
    const AdvanceNodes<R, S> body{nodes_.u(), nodes_.v(), nodes_.f(), stepper.rows(), nodes_.count()};
    if (relaxation_)
      backend_.for_each(nodes_.count(), AdvanceNodesCompensated<R, S>{body, relaxation_->carry()});
    else if (energies || model_.time.damping > 0)
      advance_with_energies<S>(body, energies);
    else
      backend_.for_each(nodes_.count(), body);
  });
}

/// All energies of the step, or only what damping dissipates.
template <Backend B, class R>
template <class S, class Nodes>
void Simulation<B, R>::advance_with_energies(const Nodes& nodes, bool all) {
  const double damping = model_.time.damping, dt = plan_.dt();
  const int chunks = monitor_.chunk_count(), count = nodes_.count();
  if (all)
    backend_.for_each(chunks, AdvanceNodesMonitored<R, S, Nodes>{nodes, monitor_.chunks(), count, damping, dt,
                                                                 step_ == 0});
  else
    backend_.for_each(chunks,
                      AdvanceNodesDamped<R, S, Nodes>{nodes, monitor_.chunks(), count, damping, dt});
}

/// Whether nothing but the node update needs the sum of all forces: then reactions, update and constraints
/// are one sweep.
template <Backend B, class R>
bool Simulation<B, R>::sweeps() const {
  return B::space == Space::device && !relaxation_ && parts_.bodies.empty();
}

template <Backend B, class R>
void Simulation<B, R>::sweep(const StepView<R>& view, const SharedForces<R>& left, bool energies) {
  if constexpr (B::space == Space::device) {
    with_stepper([&]<class S>(const S& stepper) {
      const AdvanceNodes<R, S> update{nodes_.u(), nodes_.v(), nodes_.f(), stepper.rows(), nodes_.count()};
      const CompleteNodes<R, S> nodes{
          update, left, parts_.constraints->for_sweep(view, load_time(step_ + 1), stepper)};
      if (energies || model_.time.damping > 0)
        advance_with_energies<S>(nodes, energies);
      else
        backend_.for_each(monitor_.chunk_count(), CompleteNodesOnly<R, S>{nodes, nodes_.count()});
    });
    parts_.constraints->finish(view);
  }
}

template <Backend B, class R>
void Simulation<B, R>::react_and_advance(StepView<R>& view, bool energies) {
  predict_and_touch(view);
  if (relaxation_) relaxation_->update(step_, plan_.dt());
  const double t_next = load_time(step_ + 1);
  if (view.monitor)
    with_stepper([&](const auto& stepper) { parts_.constraints->add_reactions(view, t_next, stepper); });
  advance(energies);
  parts_.constraints->apply(nodes_.u(), nodes_.v(), t_next, plan_.dt());
}

template <Backend B, class R>
void Simulation<B, R>::one_step() {
  const bool due = step_ % monitor_every_ == 0 || step_ + 1 == plan_.last_step();
  keep_healthy();
  if (step_ >= next_recheck_) recheck_stable_step();
  if (due)
    review();
  else if (capped_)  // Johnsen 2016, eq. 3.15, compares the energy of every step with the cap
    strain_energy_ = parts_.solids->strain_energy(make_view()).read();
  StepView<R> view = make_view();
  const SharedForces<R> left = add_forces(view, sweeps());
  if (sweeps())
    sweep(view, left, due);
  else
    react_and_advance(view, due);
  if (due) account(view.t);
  ++step_;
}

}  // namespace glisson
