#include "tests/contact/free_nodes.hpp"

#include <glisson/contact/analytic/rigid_bodies.hpp>
#include <glisson/contact/surface/rigid_surfaces.hpp>

#include "tests/core/load_bench.hpp"

namespace glisson::contact {
namespace {

template <class C>
class RigidBenchOn final : public RigidBench {
  using B = BackendOf<C>;
  using R = RealOf<C>;

 public:
  RigidBenchOn(const Model& model, double mass)
      : bench_(model.mesh.node_count(), mass),
        bodies_(make_rigid_bodies<B, R>(bench_.backend, model, bench_.numbering)) {
    add_rigid_surfaces<B, R>(bench_.backend, model, bench_.numbering, bodies_);
  }
  BenchNodes& nodes() override { return bench_; }
  double tolerance() const override { return bench_.tolerance(); }
  void add_forces(double dt, double advance_per_force, const std::vector<Vec3<double>>& predicted) override {
    StepView<R> view = bench_.view(double(bench_.step_count) * dt, dt);
    view.t_next = double(bench_.step_count + 1) * dt;
    view.advance_per_force = R(advance_per_force);
    bench_.put(predicted, bench_.predicted(), false);
    view.u_predicted = bench_.predicted();
    for (auto& body : bodies_) bench_.forces(*body, view);
  }
  ContactReport report() const override { return dynamic_cast<const ContactSource&>(*bodies_[0]).report(); }
  double work() const override { return bodies_[0]->work(); }
  std::vector<std::byte> save() const override { return bodies_[0]->save(); }
  void load(std::span<const std::byte> bytes) override { bodies_[0]->load(bytes); }

 private:
  Bench<C> bench_;
  std::vector<std::unique_ptr<ForceProvider<R>>> bodies_;
};

template <class B, class R>
BenchCase bench_case(const char* name) {
  return {name, [](const Model& model, double mass) -> std::unique_ptr<RigidBench> {
            return std::make_unique<RigidBenchOn<Case<B, R>>>(model, mass);
          }};
}

/// sum m a . v / 2 [J].
double kinetic_energy(const BenchNodes& bench, const std::vector<Vec3<double>>& a) {
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += 0.5 * bench.masses[n] * dot(a[n], bench.v[n]);
  return sum;
}

}  // namespace

std::vector<BenchCase> bench_cases() {
  return {bench_case<Serial, double>("SerialDouble"), bench_case<Serial, float>("SerialFloat"),
          bench_case<Threads, double>("ThreadsDouble"), bench_case<Threads, float>("ThreadsFloat"),
          bench_case<EmulatedDevice, float>("EmulatedFloat")};
}

void FreeNodes::step(double dt) {
  const double kick = bench.step_count == 0 ? 0.5 * dt : dt;
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
                tolerance * scene.tolerance())
        << n;
  }
}

void expect_same_bits_after_restart(const BenchCase& c, const Model& model, double mass) {
  FreeNodes whole(c, model, mass), first(c, model, mass), second(c, model, mass);
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
