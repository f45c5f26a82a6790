// Simulation: construction, results and checkpoints. Included by simulation.hpp.
#pragma once

namespace glisson {

/// The rule of NiftySim where the file does not choose: Newmark if every element is T4ANP.
inline Stepper default_stepper(const Model& model) {
  const bool averaged = std::all_of(model.sections.begin(), model.sections.end(),
                                    [](const Section& s) { return s.formulation == Formulation::t4anp; });
  return averaged && !model.sections.empty() ? Stepper::newmark : Stepper::central_difference;
}

inline bool has_prony(const Model& model) {
  for (const ShellSection& shell : model.shells)
    if (!shell.prony.empty()) return true;
  return std::any_of(model.sections.begin(), model.sections.end(), [](const Section& s) {
    return !s.material.isochoric.empty() || !s.material.volumetric.empty();
  });
}

/// Fibres and wrinkling membranes are stiffer in tension than in compression, however small the strain.
inline bool has_one_sided_stiffness(const Model& model) {
  return std::any_of(model.shells.begin(), model.shells.end(), [](const ShellSection& s) {
    const ShellLawRule* rule = find_shell_law(s.law);
    return s.wrinkling || (rule != nullptr && rule->one_sided);
  });
}

inline bool has_capped_springs(const Model& model) {
  return std::any_of(model.springs.begin(), model.springs.end(),
                     [](const Springs& s) { return s.strain_energy_cap.has_value(); });
}

/// Largest ratio of wave to shear speed among the materials [-].
inline double slowness(const Model& model) {
  double largest = 1;
  std::vector<double> parameters;
  for (const Section& section : model.sections) {
    if (section.elements.empty()) continue;
    element_parameters(section, 0, parameters);
    const RestModuli moduli = rest_moduli(section.material.law, parameters);
    if (moduli.shear > 0) largest = std::max(largest, std::sqrt(moduli.wave / moduli.shear));
  }
  return largest;
}

template <Backend B, class R>
Simulation<B, R>::Simulation(const Model& model, SimulationParts<B, R> parts)
    : model_(model),
      parts_(std::move(parts)),
      backend_(*parts_.backend),
      nodes_(backend_, parts_.mass),
      monitor_(backend_, nodes_.count()),
      power_(backend_, nodes_, parts_.element_step.smallest_size),
      healthy_(nodes_.zeros()),
      stepper_(model.time.stepper.value_or(default_stepper(model))),
      prony_(has_prony(model)),
      capped_(has_capped_springs(model)),
      one_sided_(has_one_sided_stiffness(model)) {
  if (!parts_.bodies.empty()) u_predicted_ = nodes_.zeros();
  list_predicted_nodes();
  if (model.time.quasi_static) {
    // shear waves cross the mesh a few times while the loads grow: one element takes them wave / shear speed
    // steps
    const double ratio = std::min(slowness(model), 50.0);
    const auto ramp = static_cast<std::int64_t>(50 + 6 * std::cbrt(double(nodes_.count())) * ratio);
    relaxation_.emplace(backend_, nodes_, *parts_.constraints, *model.time.quasi_static, ramp, parts_.mass);
  }
  choose_step();
  set_initial_velocity();
}

template <Backend B, class R>
void Simulation<B, R>::list_predicted_nodes() {
  std::vector<int> nodes;
  for (const auto& body : parts_.bodies) {
    const std::vector<int> its = body->nodes_to_predict();
    if (its.empty()) return;
    nodes.insert(nodes.end(), its.begin(), its.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  predicted_nodes_ = detail::upload(backend_, nodes);
  predicted_count_ = static_cast<int>(nodes.size());
}

template <Backend B, class R>
void Simulation<B, R>::set_initial_velocity() {
  if (model_.initial_velocities.empty()) return;
  auto v = nodes_.get(nodes_.v());
  const auto initial = initial_velocity(model_, parts_.numbering);
  for (std::size_t n = 0; n < v.size(); ++n)
    v[n] = {R(initial[n].x), R(initial[n].y), R(initial[n].z), v[n].w};
  nodes_.put(v, nodes_.v());
  parts_.constraints->project(nodes_.v());
}

template <Backend B, class R>
void Simulation<B, R>::add(std::unique_ptr<ForceProvider<double>> provider) {
  if (step_ > 0) throw Error(ErrorKind::usage, "A force provider is added before the first step, not after.");
  std::vector<double> mass(nodes_.size());
  std::vector<int> same(nodes_.size());
  for (std::size_t n = 0; n < mass.size(); ++n) {
    same[n] = static_cast<int>(n);
    mass[static_cast<std::size_t>(parts_.numbering.user_of_internal[n])] = parts_.mass[n];
  }
  provider->attach({model_.mesh.X, mass, same});
  if (provider->needs_prediction())
    throw Error(
        ErrorKind::usage,
        "User providers do not get a predicted displacement yet: return false from needs_prediction().");
  users_.push_back(
      std::make_unique<UserForces<B, R>>(backend_, nodes_, parts_.numbering, std::move(provider)));
  choose_step();
}

template <Backend B, class R>
std::vector<Vec3<double>> Simulation<B, R>::displacement() const {
  return nodes_.for_user(nodes_.u(), parts_.numbering);
}

/// Forces of the present state in the user's order, without touching the run; f is zero before and after.
/// With loads and contact: what is left of them in the free directions.
template <Backend B, class R>
std::vector<Vec3<double>> Simulation<B, R>::forces_for_user(bool with_loads) const {
  StepView<R> view = make_view();
  view.advance = false;
  view.monitor = false;
  parts_.solids->add_forces(view);
  if (with_loads) {
    for (auto& load : parts_.loads) load->add_forces(view);
    for (auto& user : users_) user->add_forces(view);
    predict_and_touch(view);
  }
  if (with_loads) parts_.constraints->project(nodes_.f());
  auto forces = nodes_.for_user(nodes_.f(), parts_.numbering);
  backend_.for_each(nodes_.count(), ZeroForces<R>{nodes_.f()});
  return forces;
}

template <Backend B, class R>
std::vector<Vec3<double>> Simulation<B, R>::internal_force() const {
  return forces_for_user(false);
}

/// The state holds v(n-1/2); half a kick of the present forces brings it to the time of u.
template <Backend B, class R>
std::vector<Vec3<double>> Simulation<B, R>::velocity() const {
  auto v = nodes_.for_user(nodes_.v(), parts_.numbering);
  if (step_ == 0 || relaxation_) return v;
  const auto f = forces_for_user(true);
  const double half = 0.5 * plan_.dt(), h = model_.time.damping * half;
  for (std::size_t n = 0; n < v.size(); ++n) {
    const double mass = parts_.mass[static_cast<std::size_t>(parts_.numbering.internal_of_user[n])];
    const bool pushed = f[n].x != 0 || f[n].y != 0 || f[n].z != 0;  // constrained nodes have no force left
    if (mass > 0 && pushed) v[n] = (1 / (1 + h)) * (v[n] + (half / mass) * f[n]);
  }
  return v;
}

template <Backend B, class R>
ElementFieldSource Simulation<B, R>::element_field_source() const {
  return glisson::element_field_source(model_, displacement(), parts_.solids->history(), make_view().dt);
}

template <Backend B, class R>
ShellFields Simulation<B, R>::shell_fields() const {
  if (model_.shells.empty()) return {};
  return parts_.solids->shell_fields(model_, displacement(), make_view().dt);
}

template <Backend B, class R>
std::vector<NamedContact> Simulation<B, R>::contacts() const {
  std::vector<NamedContact> all;
  for (const auto& body : parts_.bodies)
    if (const auto* source = dynamic_cast<const ContactSource*>(body.get()))
      all.push_back({std::string(body->name()), source->report()});
  return all;
}

template <Backend B, class R>
std::vector<Vec3<double>> Simulation<B, R>::contact_force() const {
  if (parts_.bodies.empty()) return {};
  std::vector<Vec3<double>> internal(nodes_.size()), user(nodes_.size());
  for (const auto& body : parts_.bodies)
    if (const auto* source = dynamic_cast<const ContactSource*>(body.get()))
      source->add_node_forces(internal);
  for (std::size_t n = 0; n < user.size(); ++n)
    user[static_cast<std::size_t>(parts_.numbering.user_of_internal[n])] = internal[n];
  return user;
}

template <Backend B, class R>
std::size_t Simulation<B, R>::memory_bytes() const {
  return nodes_.memory_bytes() + power_.memory_bytes() + parts_.solids->memory_bytes();
}

constexpr std::uint64_t checkpoint_mark = 0x34'6b'63'20'73'69'6c'67;  // "glis ck4"

template <Backend B, class R>
void Simulation<B, R>::save(std::ostream& out) const {
  write_value(out, checkpoint_mark);
  write_value<std::uint64_t>(out, sizeof(R));
  write_value(out, step_);
  write_value(out, plan_);
  write_value(out, std::array<double, 2>{strain_energy_, stable_step_});
  write_value(out, std::array<std::int64_t, 2>{next_recheck_, healthy_step_});
  Vec4<R>* healthy = healthy_step_ == step_ ? nodes_.u() : healthy_.get();
  for (const Vec4<R>* a : {nodes_.u(), nodes_.v(), power_.vector(), healthy})
    write_array<Vec4<R>>(out, nodes_.get(a));
  write_array<double>(out, parts_.solids->history());
  monitor_.save(out);
  if (relaxation_) relaxation_->save(out);
  auto bytes = [&](const std::vector<std::byte>& b) { write_array<std::byte>(out, b); };
  bytes(parts_.constraints->save());
  for (const auto& load : parts_.loads) bytes(load->save());
  for (const auto& body : parts_.bodies) bytes(body->save());
  for (const auto& user : users_) bytes(user->provider().save());
}

template <Backend B, class R>
void Simulation<B, R>::load(std::istream& in) {
  if (read_value<std::uint64_t>(in) != checkpoint_mark || read_value<std::uint64_t>(in) != sizeof(R))
    throw Error(
        ErrorKind::input,
        "The checkpoint was written with another precision or version. Resume with the same options.");
  step_ = read_value<std::int64_t>(in);
  plan_ = read_value<StepPlan>(in);
  const auto scalars = read_value<std::array<double, 2>>(in);
  strain_energy_ = scalars[0], stable_step_ = scalars[1];
  const auto counters = read_value<std::array<std::int64_t, 2>>(in);
  next_recheck_ = counters[0], healthy_step_ = counters[1];
  for (Vec4<R>* a : {nodes_.u(), nodes_.v(), power_.vector(), healthy_.get()})
    nodes_.put(read_array<Vec4<R>>(in, nodes_.size()), a);
  parts_.solids->set_history(read_array<double>(in, parts_.solids->history().size()));
  monitor_.load(in);
  if (relaxation_) relaxation_->load(in);
  auto bytes = [&](std::size_t expected) { return read_array<std::byte>(in, expected); };
  parts_.constraints->load(bytes(parts_.constraints->save().size()));
  for (auto& load : parts_.loads) load->load(bytes(load->save().size()));
  for (auto& body : parts_.bodies) body->load(read_bytes(in));  // their lists change their length
  for (auto& user : users_) user->provider().load(bytes(user->provider().save().size()));
}

}  // namespace glisson
