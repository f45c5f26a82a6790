// Free masses in a time loop with what is rigid in a model. Backend and precision are a value here, not a
// type: what depends on them is compiled in free_nodes.cpp only.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <glisson/core/contact_report.hpp>
#include <glisson/core/model.hpp>

#include "tests/core/bench_nodes.hpp"

namespace glisson::contact {

/// Nodes on a backend with the providers of a model's rigid bodies and rigid surfaces.
class RigidBench {
 public:
  virtual ~RigidBench() = default;
  virtual BenchNodes& nodes() = 0;
  virtual double tolerance() const = 0;
  /// The displacement [m] that the nodes would have at the end of the step without these forces.
  virtual void add_forces(double dt, double advance_per_force,
                          const std::vector<Vec3<double>>& predicted) = 0;
  // of the first provider:
  virtual ContactReport report() const = 0;
  virtual double work() const = 0;
  virtual std::vector<std::byte> save() const = 0;
  virtual void load(std::span<const std::byte> bytes) = 0;
};

struct BenchCase {
  const char* name;
  std::unique_ptr<RigidBench> (*make)(const Model&, double mass);
};
std::vector<BenchCase> bench_cases();
/// Names of tests must not hold the bytes of pointers.
inline void PrintTo(const BenchCase& c, std::ostream* out) { *out << c.name; }

using BenchTest = testing::TestWithParam<BenchCase>;
inline std::string bench_case_name(const testing::TestParamInfo<BenchCase>& info) { return info.param.name; }

struct FreeNodes {
  explicit FreeNodes(const BenchCase& c, const Model& its_model, double mass = 1)
      : model(its_model), rigid(c.make(model, mass)), bench(rigid->nodes()) {}

  void step(double dt);
  ContactReport report() const { return rigid->report(); }
  Vec3<double> position(int n) const { return model.mesh.X[std::size_t(n)] + bench.u[std::size_t(n)]; }
  double tolerance() const { return rigid->tolerance(); }

  Model model;
  std::unique_ptr<RigidBench> rigid;
  BenchNodes& bench;
  Vec3<double> gravity;
};

/// After each of 20 steps the work of the first body is what the nodes have gained: with v(t - dt/2) . v(t +
/// dt/2) for v^2 the kinetic energy of the central difference balances trapezoidal work exactly.
void expect_work_to_be_the_energy_of_the_nodes(FreeNodes& scene, double tolerance);

/// 20 steps at once, and 11 steps whose state another scene takes over for the others.
void expect_same_bits_after_restart(const BenchCase& c, const Model& model, double mass = 1);

}  // namespace glisson::contact

#define GLISSON_BENCH_CASES(suite)                                                         \
  INSTANTIATE_TEST_SUITE_P(All, suite, testing::ValuesIn(glisson::contact::bench_cases()), \
                           glisson::contact::bench_case_name)
