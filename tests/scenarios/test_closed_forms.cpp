// Homogeneous and radial solutions with closed forms.
#include <gtest/gtest.h>

#include <map>

#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

constexpr double mu = 1000, kappa = 200 * mu;

class ClosedForm : public Matrix {};

/// A unit cube with three symmetry faces; the faces x = 1 (and y = 1) are moved to the given stretch.
Model stretched_cube(double stretch, bool equibiaxial, Formulation formulation) {
  Model model = box_model({2, 2, 2}, {1, 1, 1}, formulation, {"NH", {mu, kappa}, 1000});
  for (int axis = 0; axis < 3; ++axis) model.fixed.push_back({face(model.mesh, axis, 0), 1u << axis});
  model.displacements.push_back({face(model.mesh, 0, 1), 1, {stretch - 1}, smooth_curve(1)});
  if (equibiaxial) model.displacements.push_back({face(model.mesh, 1, 1), 2, {stretch - 1}, smooth_curve(1)});
  model.time = relaxed();
  return model;
}

double cauchy_xx(AnySimulation& simulation, double stretch) {
  const auto fields = simulation.element_fields();
  return stretch * stretch * fields.stress[0].xx / fields.J[0];
}

/// Cauchy stress along the pulled axis of a compressible neo-Hookean cube whose free faces carry none, by
/// bisection on their stretch b.
double exact_stress(double l, bool two) {
  auto stress = [&](double along, double b) {
    const double other = two ? l : b, J = l * other * b, I1 = l * l + other * other + b * b;
    return mu * std::pow(J, -5.0 / 3) * (along * along - I1 / 3) + kappa * (J - 1);
  };
  double low = 0.1, high = 2;
  for (int i = 0; i < 100; ++i) {
    const double b = 0.5 * (low + high);
    (stress(b, b) < 0 ? low : high) = b;
  }
  return stress(l, low);
}

TEST_P(ClosedForm, UniaxialAndEquibiaxial) {
  for (const double l : {0.8, 1.5, 2.0})
    for (const bool two : {false, true}) {
      const Model model = stretched_cube(l, two, Formulation::h8_full);
      auto simulation = simulate(model, GetParam());
      while (!simulation->finished()) simulation->step(100);
      const double incompressible = mu * (two ? l * l - 1 / std::pow(l, 4) : l * l - 1 / l),
                   exact = exact_stress(l, two);
      EXPECT_NEAR(cauchy_xx(*simulation, l), exact, 2e-4 * std::abs(exact))
          << "stretch " << l << (two ? " biaxial" : "");
      // the pressure changes the volume by about |stress| / kappa, the stress by a few times that share
      EXPECT_NEAR(exact, incompressible, 4 * std::abs(exact) * std::abs(exact) / kappa);
    }
}

TEST_P(ClosedForm, SimpleShear) {
  for (const auto formulation :
       {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_full}) {
    const double gamma = 0.4;
    Model model = box_model({2, 2, 2}, {1, 1, 1}, formulation, {"NH", {mu, kappa}, 1000});
    const auto all = nodes_where(model.mesh, [](const auto&) { return true; });
    std::vector<double> x;
    for (const int n : all) x.push_back(gamma * model.mesh.X[static_cast<std::size_t>(n)].y);
    model.displacements.push_back({all, 1, x, smooth_curve(1)});
    model.fixed.push_back({all, 6});
    model.time.total = 1;
    model.time.step = 0.01;  // every node is prescribed: no stability limit
    model.time.energy_tolerance = 0;
    auto simulation = simulate(model, GetParam());
    while (!simulation->finished()) simulation->step();
    const auto S = simulation->element_fields().stress[0];
    // sigma = F S F^T with F = I + gamma e1 e2
    const double s12 = S.xy + gamma * S.yy, s11 = S.xx + 2 * gamma * S.xy + gamma * gamma * S.yy;
    const double rounding = 2 * GetParam().rounding() * kappa;
    EXPECT_NEAR(s12, mu * gamma, rounding);
    EXPECT_NEAR(s11 - S.yy, mu * gamma * gamma, rounding);
  }
}

/// An octant of a thick sphere from three patches that meet along (1, 1, 1).
Mesh sphere_octant(int n, int layers, double inner, double outer) {
  Mesh mesh;
  std::map<std::array<long, 3>, int> known;
  auto node = [&](int patch, int i, int j, int k) {
    const double p = double(i) / n, q = double(j) / n,
                 r = inner * std::pow(outer / inner, double(k) / layers);
    std::array<double, 3> d{};
    d[static_cast<std::size_t>(patch)] = 1, d[static_cast<std::size_t>((patch + 1) % 3)] = p,
    d[static_cast<std::size_t>((patch + 2) % 3)] = q;
    const double s = r / std::sqrt(1 + p * p + q * q);
    const Vec3<double> X{s * d[0], s * d[1], s * d[2]};
    auto [place, is_new] = known.try_emplace(
        {std::lround(X.x * 1e9), std::lround(X.y * 1e9), std::lround(X.z * 1e9)}, mesh.node_count());
    if (is_new) mesh.X.push_back(X);
    return place->second;
  };
  for (int patch = 0; patch < 3; ++patch)
    for (int k = 0; k < layers; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const std::array<int, 8> e{node(patch, i, j, k),
                                     node(patch, i + 1, j, k),
                                     node(patch, i + 1, j + 1, k),
                                     node(patch, i, j + 1, k),
                                     node(patch, i, j, k + 1),
                                     node(patch, i + 1, j, k + 1),
                                     node(patch, i + 1, j + 1, k + 1),
                                     node(patch, i, j + 1, k + 1)};
          mesh.add_element(Shape::hexahedron, e);
        }
  return mesh;
}

double radius(const Vec3<double>& X) { return std::sqrt(dot(X, X)); }

/// Inner surface as facets whose normals point out of the solid, i.e. towards the centre.
std::vector<Facet> inner_facets(const Mesh& mesh, double inner) {
  std::vector<Facet> facets;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto a = mesh.element(e);
    if (std::abs(radius(mesh.X[static_cast<std::size_t>(a[0])]) - inner) < 1e-9)
      facets.push_back({{a[0], a[3], a[2], a[1]}, e});
  }
  return facets;
}

TEST(ThickSphere, InnerPressureGivesTheClosedFormStretch) {
  // p / mu at inner stretch 1.25 for R_out / R_in = 2: 2 (f(lb) - f(la)), f = 1/l + 1/(4 l^4), incompressible
  const double inner = 0.01, outer = 0.02, stretch = 1.25, pressure = 0.55187 * mu;
  Model model;
  model.name = "sphere";
  model.mesh = sphere_octant(3, 6, inner, outer);
  model.sections = {section_of_all(model.mesh, Formulation::h8_full, {"NH", {mu, 200 * mu}, 1000})};
  for (int axis = 0; axis < 3; ++axis) model.fixed.push_back({face(model.mesh, axis, 0), 1u << axis});
  model.pressures.push_back({inner_facets(model.mesh, inner), pressure, smooth_curve(1)});
  model.time = relaxed(1e-4, 1e-4);
  const auto u = final_displacement(model, threads_float);
  double mean = 0;
  int count = 0;
  for (std::size_t n = 0; n < u.size(); ++n)
    if (std::abs(radius(model.mesh.X[n]) - inner) < 1e-9)
      mean += radius(model.mesh.X[n] + u[n]) / inner, ++count;
  EXPECT_NEAR(mean / count, stretch, 0.02 * (stretch - 1) + 0.002);
}

TEST_P(ClosedForm, PronyRelaxationAfterAStep) {
  const double gamma = 0.01, T = 0.5;
  Model model = box_model({1, 1, 1}, {1, 1, 1}, Formulation::h8, {"NH", {mu, kappa}, 1000});
  auto& material = model.sections[0].material;
  material.isochoric = {{0.4, 0.1}, {0.2, 1.0}};
  const auto all = nodes_where(model.mesh, [](const auto&) { return true; });
  std::vector<double> x;
  for (const int n : all) x.push_back(gamma * model.mesh.X[static_cast<std::size_t>(n)].y);
  model.displacements.push_back({all, 1, x, step_curve(T)});
  model.fixed.push_back({all, 6});
  model.time.total = T;
  model.time.step = 5e-4;
  model.time.energy_tolerance = 0;
  auto simulation = simulate(model, GetParam());
  while (!simulation->finished()) simulation->step();
  const double exact = 1 - 0.4 * (1 - std::exp(-T / 0.1)) - 0.2 * (1 - std::exp(-T / 1.0));
  // backward Euler: relative error of exp(-t/tau) is about dt t / (2 tau^2)
  EXPECT_NEAR(simulation->element_fields().stress[0].xy / (mu * gamma), exact, 0.003);
}

GLISSON_ALL_CASES(ClosedForm);

}  // namespace
}  // namespace glisson::test
