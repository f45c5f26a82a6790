// Free masses in a time loop with the contact providers of a model.
#pragma once

#include <memory>
#include <vector>

#include <glisson/contact/list_contact.hpp>
#include <glisson/core/model.hpp>

#include "tests/core/load_bench.hpp"

namespace glisson::contact {

template <class C>
using Bodies = std::vector<std::unique_ptr<ForceProvider<RealOf<C>>>>;

/// make(backend, model, numbering) -> Bodies<C>
template <class C>
struct FreeNodes {
  using R = RealOf<C>;

  template <class Make>
  FreeNodes(const Model& m, double mass, Make make)
      : model(m), bench(m.mesh.node_count(), mass), bodies(make(bench.backend, model, bench.numbering)) {}

  void step(double dt) {
    const double kick = bench.step_count == 0 ? 0.5 * dt : dt, t = double(bench.step_count) * dt;
    StepView<R> view = bench.view(t, dt);
    view.t_next = double(bench.step_count + 1) * dt;
    view.advance_per_force = R(dt * kick);
    auto predicted = bench.u;
    for (std::size_t n = 0; n < predicted.size(); ++n)
      predicted[n] = predicted[n] + dt * (bench.v[n] + kick * gravity);
    bench.put(predicted, bench.predicted(), false);
    view.u_predicted = bench.predicted();
    bench.f.assign(bench.f.size(), {});
    for (auto& body : bodies) bench.forces(*body, view);
    for (std::size_t n = 0; n < bench.f.size(); ++n) bench.f[n] = bench.f[n] + bench.masses[n] * gravity;
    bench.advance(dt);
  }
  ContactReport report() const { return dynamic_cast<const ContactSource&>(*bodies[0]).report(); }
  Vec3<double> position(int n) const { return model.mesh.X[std::size_t(n)] + bench.u[std::size_t(n)]; }

  Model model;
  Bench<C> bench;
  Bodies<C> bodies;
  Vec3<double> gravity;
};

/// sum m a . b / 2 [J].
template <class Bench>
double kinetic_energy(const Bench& bench, const std::vector<Vec3<double>>& a) {
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += 0.5 * bench.masses[n] * dot(a[n], bench.v[n]);
  return sum;
}

/// After each of 20 steps the work of the first body is what the nodes have gained: with v(t - dt/2) . v(t +
/// dt/2) for v^2 the kinetic energy of the central difference balances trapezoidal work exactly.
template <class Scene>
void expect_work_to_be_the_energy_of_the_nodes(Scene& scene, double tolerance) {
  const double start = kinetic_energy(scene.bench, scene.bench.v);
  for (int n = 0; n < 20; ++n) {
    const auto before = scene.bench.v;
    scene.step(0.05);
    EXPECT_NEAR(scene.bodies[0]->work(), kinetic_energy(scene.bench, before) - start,
                tolerance * scene.bench.tolerance())
        << n;
  }
}

/// 20 steps at once, and 11 steps whose state another scene of make() takes over for the others.
template <class Make>
void expect_same_bits_after_restart(Make make) {
  auto whole = make(), first = make(), second = make();
  for (int n = 0; n < 20; ++n) whole.step(0.05);
  for (int n = 0; n < 11; ++n) first.step(0.05);
  second.bodies[0]->load(first.bodies[0]->save());
  second.bench.u = first.bench.u, second.bench.v = first.bench.v, second.bench.step_count = 11;
  for (int n = 11; n < 20; ++n) second.step(0.05);
  for (std::size_t n = 0; n < whole.bench.u.size(); ++n) expect_near(second.bench.u[n], whole.bench.u[n], 0);
  EXPECT_EQ(second.bodies[0]->save(), whole.bodies[0]->save());
  EXPECT_EQ(second.bodies[0]->work(), whole.bodies[0]->work());
}

}  // namespace glisson::contact
