// What set-up derives from a model: numbering, masses, stable steps, blocks, history.
#include <set>

#include <glisson/core/base/error.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/materials/kinematics.hpp>
#include <glisson/core/solids/element_fields.hpp>
#include <glisson/core/solids/mass.hpp>
#include <glisson/cpu/emulated_device.hpp>

#include "solid_bench.hpp"

namespace glisson::test {
namespace {

TEST(Numbering, IsAPermutationThatKeepsNeighboursClose) {
  Mesh mesh = box_mesh({12, 12, 12}, {1, 1, 1}, Shape::tetrahedron, 0.1, true);
  mesh.X.push_back({5, 5, 5});  // belongs to no element
  const Numbering numbering = make_numbering(mesh);
  ASSERT_EQ(numbering.internal_of_user.size(), mesh.X.size());
  for (int n = 0; n < mesh.node_count(); ++n)
    EXPECT_EQ(numbering.user_of_internal[std::size_t(numbering.internal_of_user[std::size_t(n)])], n);
  EXPECT_EQ(numbering.internal_of_user.back(), mesh.node_count() - 1);
  EXPECT_EQ(std::set<int>(numbering.element_order.begin(), numbering.element_order.end()).size(),
            std::size_t(mesh.element_count()));
  auto spread = [&](auto number) {
    double sum = 0;
    for (int e = 0; e < mesh.element_count(); ++e) {
      int low = mesh.node_count(), high = 0;
      for (const int n : mesh.element(e)) low = std::min(low, number(n)), high = std::max(high, number(n));
      sum += high - low;
    }
    return sum / mesh.element_count();
  };
  const double shuffled = spread([](int n) { return n; });
  const double local = spread([&](int n) { return numbering.internal_of_user[std::size_t(n)]; });
  EXPECT_LT(local, 0.3 * shuffled);
}

TEST(LumpedMass, IsThatOfTheVolume) {
  for (const Formulation formulation : all_formulations) {
    const Model model = cube(formulation);
    double sum = 0;
    for (const double m : lumped_mass(model)) sum += m;
    EXPECT_NEAR(sum, 1000, 1e-9) << name_of(formulation);
  }
}

TEST(InertialMass, BringsSmallElementsToTheWantedStep) {
  Model model = cube(Formulation::t4);
  const double wanted = 1.3 * element_stable_step(model).dt;
  model.time.mass_scaling_step = wanted;
  const InertialMass scaled = inertial_mass(model);
  EXPECT_GT(scaled.added_share, 0);
  EXPECT_LT(scaled.added_share, 1);
  EXPECT_NEAR(scaled.step.dt, wanted, 1e-12 * wanted);
  double sum = 0;
  for (const double m : scaled.mass) sum += m;
  EXPECT_NEAR(sum, 1000 * (1 + scaled.added_share), 1e-9);
}

double component(const Vec3<double>& a, std::size_t i) { return i == 0 ? a.x : i == 1 ? a.y : a.z; }

/// Largest eigenvalue of M^-1 K at rest by many power iterations on the matrix, found by central differences
/// of forces.
double largest_omega(const Model& model) {
  SolidBench<double> bench(model);
  const std::vector<double> mass = lumped_mass(model);
  const std::size_t count = 3 * mass.size();
  std::vector<double> A(count * count);
  for (std::size_t j = 0; j < count; ++j) {
    Field u(mass.size());
    (j % 3 == 0 ? u[j / 3].x : j % 3 == 1 ? u[j / 3].y : u[j / 3].z) = 1e-6;
    const Field plus = bench.forces(u);
    for (auto& a : u) a = -1.0 * a;
    const Field minus = bench.forces(u);
    for (std::size_t i = 0; i < count; ++i)
      A[i * count + j] =
          -component(plus[i / 3] - minus[i / 3], i % 3) / 2e-6 / std::sqrt(mass[i / 3] * mass[j / 3]);
  }
  std::vector<double> x(count), y(count);
  for (std::size_t i = 0; i < count; ++i) x[i] = std::sin(double(i * i) + 0.3);
  double value = 0;
  for (int iteration = 0; iteration < 2000; ++iteration) {
    double norm = 0;
    for (std::size_t i = 0; i < count; ++i) {
      y[i] = 0;
      for (std::size_t j = 0; j < count; ++j) y[i] += A[i * count + j] * x[j];
      norm += y[i] * y[i];
    }
    value = std::sqrt(norm);
    for (std::size_t i = 0; i < count; ++i) x[i] = y[i] / value;
  }
  return std::sqrt(value);
}

const Material materials[] = {
    {"NH", {mu, kappa}}, {"NH", {mu, 500 * mu}}, {"TI", {mu, kappa, 20000, 1, 0.3, 0}}};

TEST(ElementStableStep, BoundsThatOfTheMesh) {
  for (const Formulation formulation : all_formulations)
    for (const Material& material : materials) {
      const Model model = box_model({2, 2, 2}, {1, 1.2, 0.8}, formulation, material, 0.15);
      const double exact = 2 / largest_omega(model), bound = element_stable_step(model).dt;
      EXPECT_LE(bound, exact * (1 + 1e-5))
          << name_of(formulation) << " " << material.law << material.parameters[1];
      // The bound gives every direction the stiffness that strong fibres have in one.
      EXPECT_GE(bound, (material.law == "TI" ? 0.4 : 0.5) * exact)
          << name_of(formulation) << " " << material.law << material.parameters[1];
    }
}

TEST(ElementStableStep, IsExactForOneElement) {
  Model tetrahedron;
  tetrahedron.mesh.X = {{0, 0, 0}, {1, 0.1, 0}, {0.2, 0.7, 0}, {0.1, 0.3, 0.4}};
  const int nodes[] = {0, 1, 2, 3};
  tetrahedron.mesh.add_element(Shape::tetrahedron, nodes);
  for (const auto& material : {materials[0], materials[1]}) {
    tetrahedron.sections = {section_of_all(tetrahedron.mesh, Formulation::t4, material)};
    const double exact = 2 / largest_omega(tetrahedron);
    EXPECT_NEAR(element_stable_step(tetrahedron).dt, exact, 1e-5 * exact);
    for (const Formulation formulation : {Formulation::h8, Formulation::h8_fixed}) {
      const Model brick = box_model({1, 1, 1}, {1, 0.5, 0.3}, formulation, material);
      const double exact_brick = 2 / largest_omega(brick);
      EXPECT_NEAR(element_stable_step(brick).dt, exact_brick, 1e-5 * exact_brick) << name_of(formulation);
    }
  }
}

TEST(Blocks, TakeParametersPerElement) {
  const Model uniform = cube(Formulation::h8);
  Model varied = uniform;
  const std::size_t count = varied.sections[0].elements.size();
  varied.sections[0].material.parameters[0] = 0;
  varied.sections[0].material.element_parameters = {{0, std::vector<double>(count, mu)}};
  const Field u = random_field(uniform.mesh.X.size(), 0.03), f = SolidBench<double>(uniform).forces(u);
  EXPECT_EQ(largest_difference(f, SolidBench<double>(varied).forces(u)), 0);
  varied.sections[0].material.element_parameters[0].second[7] = 5 * mu;
  const Field g = SolidBench<double>(varied).forces(u);
  const auto touched = uniform.mesh.element(7);
  for (int n = 0; n < uniform.mesh.node_count(); ++n) {
    const bool of_element = std::find(touched.begin(), touched.end(), n) != touched.end();
    EXPECT_EQ(length(f[std::size_t(n)] - g[std::size_t(n)]) > 0, of_element) << n;
  }
}

TEST(Blocks, HaveTheSameForcesInGuardedMemoryAndRandomOrder) {
  for (const Formulation formulation : all_formulations) {
    const Model model = cube(formulation);
    const Field u = random_field(model.mesh.X.size(), 0.03);
    SolidBench<float> plain(model);
    SolidBench<float, EmulatedDevice> guarded(model);
    EXPECT_EQ(largest_difference(plain.forces(u), guarded.forces(u)), 0) << name_of(formulation);
    const double energy = plain.energy(u);  // of a device the sum has another order
    EXPECT_NEAR(guarded.energy(u), energy, 1e-14 * energy) << name_of(formulation);
  }
}

Model viscous(Formulation formulation) {
  Model model = cube(formulation);
  model.sections[0].material.isochoric = {{0.3, 0.1}, {0.2, 2}};
  model.sections[0].material.volumetric = {{0.1, 0.5}};
  return model;
}

/// Held for long, the stress is that of (1 - sum alpha) S_iso + (1 - sum alpha) S_vol: moduli (1 - 0.5) mu
/// and (1 - 0.1) kappa.
TEST(History, RelaxesToTheLongTermModuli) {
  for (const Formulation formulation : {Formulation::t4, Formulation::h8, Formulation::h8_full}) {
    const Model model = viscous(formulation);
    Model relaxed = cube(formulation);
    relaxed.sections[0].material.parameters = {0.5 * mu, 0.9 * kappa};
    if (formulation == Formulation::h8) relaxed.sections[0].hourglass *= 2;  // its modulus is 4 mu
    const Field u = random_field(model.mesh.X.size(), 0.02);
    SolidBench<double> bench(model);
    Field f;
    for (int step = 0; step < 2000; ++step) f = bench.forces(u, 0.05, true);
    const Field expected = SolidBench<double>(relaxed).forces(u);
    EXPECT_LT(largest_difference(f, expected), 1e-9 * largest(expected)) << name_of(formulation);
  }
}

TEST(History, SurvivesAnotherOrderOfElements) {
  for (const Formulation formulation : all_formulations) {
    const Model model = viscous(formulation);
    const Field u = random_field(model.mesh.X.size(), 0.02);
    SolidBench<double> first(model);
    first.forces(u, 0.05, true);
    const auto history = first.solids().history();
    const std::size_t points = formulation == Formulation::h8_full ? 8 : 1;
    ASSERT_EQ(history.size(), model.sections[0].elements.size() * points * 3 * 6);
    SolidBench<double, EmulatedDevice> second(model);
    second.solids().set_history(history);
    EXPECT_EQ(largest_difference(first.forces(u, 0.05), second.forces(u, 0.05)), 0) << name_of(formulation);
    EXPECT_EQ(second.solids().history(), history);
  }
}

TEST(History, OfAnotherModelIsRefused) {
  SolidBench<double> bench(viscous(Formulation::t4));
  EXPECT_THROW(bench.solids().set_history(std::vector<double>(7)), Error);
}

/// S of the element times F and the gradients must be the forces: element_fields() and the loop bodies are
/// written apart.
TEST(Fields, BelongToTheForces) {
  for (const Formulation formulation : {Formulation::t4, Formulation::t4anp}) {
    const Model model = viscous(formulation);
    const Field u = random_field(model.mesh.X.size(), 0.02);
    SolidBench<double> bench(model);
    bench.forces(u, 0.05, true);
    const ElementFieldSource source = element_field_source(model, u, bench.solids().history(), 0.05);
    const ElementFields fields = source.range(0, source.element_count);
    for (int e = 0; e < source.element_count; ++e) {  // a part gives the bits of the whole
      const ElementFields one = source.range(e, 1);
      EXPECT_EQ(one.stress.at(0).xy, fields.stress[std::size_t(e)].xy);
      EXPECT_EQ(one.J.at(0), fields.J[std::size_t(e)]);
    }
    const Field f = bench.forces(u, 0.05, false);
    Field sum(f.size());
    for (int e = 0; e < model.mesh.element_count(); ++e) {
      const auto nodes = model.mesh.element(e);
      Vec3<double> X[4], ue[4], own[4];
      for (std::size_t a = 0; a < 4; ++a)
        X[a] = model.mesh.X[std::size_t(nodes[a])], ue[a] = u[std::size_t(nodes[a])];
      const auto c = T4::make(X);
      Mat3<double> H = T4::displacement_gradient(c, ue), D;
      double j = 0;
      volume_terms(H, D, j);
      const double stretch =
          std::cbrt(fields.J[std::size_t(e)] / (1 + j));  // of the averaged volume; 1 for T4
      for (int i = 0; i < 3; ++i)
        for (int K = 0; K < 3; ++K) H.m[i][K] = stretch * (H.m[i][K] + (i == K)) - (i == K);
      T4::nodal_forces(c, push_first(H, fields.stress[std::size_t(e)]), own);
      for (std::size_t a = 0; a < 4; ++a) sum[std::size_t(nodes[a])] = sum[std::size_t(nodes[a])] + own[a];
    }
    EXPECT_LT(largest_difference(f, sum), 1e-11 * largest(f)) << name_of(formulation);
  }
}

}  // namespace
}  // namespace glisson::test
