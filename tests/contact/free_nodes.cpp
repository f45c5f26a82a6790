#include "tests/contact/free_nodes.hpp"

#include <glisson/contact/analytic/rigid_bodies.hpp>
#include <glisson/contact/surface/rigid_surfaces.hpp>

#include "tests/core/nodes_on_backend.hpp"

namespace glisson::contact {
namespace {

template <class B, class R>
class RigidBenchOn final : public RigidBench {
 public:
  RigidBenchOn(BenchCase row, const Model& model, double mass)
      : RigidBench(BenchNodes(row, model.mesh.node_count(), mass)),
        bodies_(make_rigid_bodies<B, R>(mirror_.backend, model, nodes.numbering)) {
    add_rigid_surfaces<B, R>(mirror_.backend, model, nodes.numbering, bodies_);
  }
  void add_forces(double dt, double advance_per_force, const std::vector<Vec3<double>>& predicted) override {
    StepView<R> view = mirror_.view(double(nodes.step_count) * dt, dt);
    view.t_next = double(nodes.step_count + 1) * dt;
    view.advance_per_force = R(advance_per_force);
    view.u_predicted = mirror_.put_predicted(predicted);
    for (auto& body : bodies_) body->add_forces(view);
    mirror_.get_f();
  }
  ContactReport report() const override { return dynamic_cast<const ContactSource&>(*bodies_[0]).report(); }
  double work() const override { return bodies_[0]->work(); }
  std::vector<std::byte> save() const override { return bodies_[0]->save(); }
  void load(std::span<const std::byte> bytes) override { bodies_[0]->load(bytes); }

 private:
  NodesOnBackend<B, R> mirror_{nodes};
  std::vector<std::unique_ptr<ForceProvider<R>>> bodies_;
};

/// sum m a . v / 2 [J].
double kinetic_energy(const BenchNodes& bench, const std::vector<Vec3<double>>& a) {
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += 0.5 * bench.masses[n] * dot(a[n], bench.v[n]);
  return sum;
}

}  // namespace

std::unique_ptr<RigidBench> rigid_bench(BenchCase row, const Model& model, double mass) {
  return make_for<RigidBench, RigidBenchOn>(row, row, model, mass);
}

void FreeNodes::step(double dt) {
  const double kick = bench.kick(dt);
  auto predicted = bench.u;
  for (std::size_t n = 0; n < predicted.size(); ++n)
    predicted[n] = predicted[n] + dt * (bench.v[n] + kick * gravity);
  bench.f.assign(bench.f.size(), {});
  rigid->add_forces(dt, dt * kick, predicted);
  for (std::size_t n = 0; n < bench.f.size(); ++n) bench.f[n] = bench.f[n] + bench.masses[n] * gravity;
  bench.advance(dt);
}

void expect_work_to_be_the_energy_of_the_nodes(FreeNodes& scene, double tolerance) {
  const double start = kinetic_energy(scene.bench, scene.bench.v);
  for (int n = 0; n < 20; ++n) {
    const auto before = scene.bench.v;
    scene.step(0.05);
    EXPECT_NEAR(scene.rigid->work(), kinetic_energy(scene.bench, before) - start,
                tolerance * scene.bench.tolerance())
        << n;
  }
}

void expect_same_bits_after_restart(BenchCase row, const Model& model, double mass) {
  FreeNodes whole(row, model, mass), first(row, model, mass), second(row, model, mass);
  for (int n = 0; n < 20; ++n) whole.step(0.05);
  for (int n = 0; n < 11; ++n) first.step(0.05);
  second.rigid->load(first.rigid->save());
  second.bench.u = first.bench.u, second.bench.v = first.bench.v, second.bench.step_count = 11;
  for (int n = 11; n < 20; ++n) second.step(0.05);
  for (std::size_t n = 0; n < whole.bench.u.size(); ++n) expect_near(second.bench.u[n], whole.bench.u[n], 0);
  EXPECT_EQ(second.rigid->save(), whole.rigid->save());
  EXPECT_EQ(second.rigid->work(), whole.rigid->work());
}

}  // namespace glisson::contact
