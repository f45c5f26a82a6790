// Free masses in a time loop with what is rigid in a model. Backend and precision are a value here, not a
// type: what depends on them is compiled in free_nodes.cpp only.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glisson/core/contact_report.hpp>
#include <glisson/core/model.hpp>

#include "tests/core/bench_nodes.hpp"

namespace glisson::contact {

/// Nodes on a backend with the providers of a model's rigid bodies and rigid surfaces.
class RigidBench {
 public:
  explicit RigidBench(BenchNodes its_nodes) : nodes(std::move(its_nodes)) {}
  virtual ~RigidBench() = default;
  /// predicted: displacement that the nodes would have at the end of the step without these forces [m]
  virtual void add_forces(double dt, double advance_per_force,
                          const std::vector<Vec3<double>>& predicted) = 0;
  // of the first provider:
  virtual ContactReport report() const = 0;
  virtual double work() const = 0;
  virtual std::vector<std::byte> save() const = 0;
  virtual void load(std::span<const std::byte> bytes) = 0;

  BenchNodes nodes;
};
std::unique_ptr<RigidBench> rigid_bench(BenchCase row, const Model& model, double mass);

struct FreeNodes {
  FreeNodes(BenchCase row, const Model& its_model, double mass = 1)
      : model(its_model), rigid(rigid_bench(row, model, mass)), bench(rigid->nodes) {}

  void step(double dt);
  ContactReport report() const { return rigid->report(); }
  Vec3<double> position(int n) const { return model.mesh.X[std::size_t(n)] + bench.u[std::size_t(n)]; }

  Model model;
  std::unique_ptr<RigidBench> rigid;
  BenchNodes& bench;
  Vec3<double> gravity;
};

/// After each of 20 steps the work of the first body is what the nodes have gained: with v(t - dt/2) . v(t +
/// dt/2) for v^2 the kinetic energy of the central difference balances trapezoidal work exactly.
void expect_work_to_be_the_energy_of_the_nodes(FreeNodes& scene, double tolerance);

/// 20 steps at once, and 11 steps whose state another scene takes over for the others.
void expect_same_bits_after_restart(BenchCase row, const Model& model, double mass = 1);

}  // namespace glisson::contact
