// Membranes that share the nodes of solids: both carry their part of the load.
#include <gtest/gtest.h>

#include <tests/shells/sheets.hpp>
#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

class ShellsOnSolids : public Matrix {};

void add_triangles(Model& model, std::array<int, 4> quad) {
  model.mesh.triangles.push_back({quad[0], quad[1], quad[2]});
  model.mesh.triangles.push_back({quad[0], quad[2], quad[3]});
}

void cover(Model& model, ShellSection section) {
  section.elements.resize(model.mesh.triangles.size());
  std::iota(section.elements.begin(), section.elements.end(), 0);
  model.shells = {std::move(section)};
}

double pull_on(AnySimulation& simulation, const std::vector<int>& nodes) {
  const auto f = simulation.internal_force();
  double sum = 0;
  for (const int n : nodes) sum -= f[static_cast<std::size_t>(n)].x;
  return sum;
}

void run(AnySimulation& simulation) {
  while (!simulation.finished()) simulation.step(100);
  EXPECT_EQ(simulation.report().ending, "converged");
}

/// Solid and membrane of one law with moduli in the ratio c narrow alike, so that no force acts between them:
/// pull P(l) (A + c h s) with the area A and the covered part s of the circumference.
TEST_P(ShellsOnSolids, ABlockInASkinPullsAsBothInParallel) {
  const double mu = 1000, kappa = 5000, c = 40, h = 1e-3, stretch = 1.3;
  const Vec3<double> size{0.06, 0.03, 0.02};
  // 3 kappa (J - 1) = mu J^(-5/3) (l^2 - J / l); nominal stress J s / l
  double low = 1, high = 2;
  for (int i = 0; i < 100; ++i) {
    const double J = 0.5 * (low + high);
    (3 * kappa * (J - 1) < mu * std::pow(J, -5.0 / 3) * (stretch * stretch - J / stretch) ? low : high) = J;
  }
  const double J = low, narrow = std::sqrt(J / stretch), nominal = J * 3 * kappa * (J - 1) / stretch;
  for (const auto formulation : {Formulation::t4, Formulation::h8, Formulation::h8_full}) {
    SCOPED_TRACE(name_of(formulation));
    Model model = box_model({4, 3, 2}, size, formulation, {"NH", {mu, kappa}});
    const auto node = [](int i, int j, int k) { return (k * 4 + j) * 5 + i; };
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 2; ++k)
        add_triangles(model, {node(i, 3, k), node(i, 3, k + 1), node(i + 1, 3, k + 1), node(i + 1, 3, k)});
      for (int j = 0; j < 3; ++j)
        add_triangles(model, {node(i, j, 2), node(i + 1, j, 2), node(i + 1, j + 1, 2), node(i, j + 1, 2)});
    }
    cover(model, membrane_section("NeoHookeanCompressible", {c * mu, c * kappa}, h));
    for (int axis = 0; axis < 3; ++axis) model.fixed.push_back({face(model.mesh, axis, 0), 1U << axis});
    const auto end = face(model.mesh, 0, size.x);
    model.displacements.push_back({end, 1, {(stretch - 1) * size.x}, smooth_curve(1)});
    model.time = relaxed(1e-5, 1e-6);
    validate(model);
    auto simulation = simulate(model, GetParam());
    run(*simulation);
    const double exact = nominal * (size.y * size.z + c * h * (size.y + size.z));
    EXPECT_NEAR(pull_on(*simulation, end), exact, 2e-4 * exact);
    const auto corner = simulation->displacement().back();
    EXPECT_NEAR(corner.y, (narrow - 1) * size.y, 1e-4 * size.y);
    EXPECT_NEAR(corner.z, (narrow - 1) * size.z, 1e-4 * size.z);
  }
}
GLISSON_ALL_CASES(ShellsOnSolids);

/// Pure bending of a core between two skins, nu = 0: M = k b (E H^3 / 12 + E_skin h H^2 / 2), by ends that
/// turn as planes.
double sandwich(int n, double skin) {
  const double E = 1000, L = 0.04, H = 0.04, width = L / n, h = 1e-4, k = 0.05;
  Model model = box_model({n, 1, n}, {L, width, H}, Formulation::h8_full, {"LE", {E, 0}});
  const auto node = [n](int i, int j, int level) { return (level * 2 + j) * (n + 1) + i; };
  for (int i = 0; i < n; ++i) {
    add_triangles(model, {node(i, 0, n), node(i + 1, 0, n), node(i + 1, 1, n), node(i, 1, n)});
    add_triangles(model, {node(i, 0, 0), node(i, 1, 0), node(i + 1, 1, 0), node(i + 1, 0, 0)});
  }
  cover(model, membrane_section("Linear", {skin, 0}, h));
  const auto all = nodes_where(model.mesh, [](const auto&) { return true; });
  model.fixed.push_back({all, 2});
  model.fixed.push_back({{node(0, 0, n / 2)}, 4});
  const auto end = face(model.mesh, 0, L);
  for (const double x : {0.0, L}) {
    const auto nodes = face(model.mesh, 0, x);
    std::vector<double> turn;
    for (const int a : nodes)
      turn.push_back(-k * (x - L / 2) * (model.mesh.X[static_cast<std::size_t>(a)].z - H / 2));
    model.displacements.push_back({nodes, 1, turn, smooth_curve(1)});
  }
  model.time = relaxed(1e-6, 1e-7);
  validate(model);
  auto simulation = simulate(model, serial_double);
  run(*simulation);
  const auto f = simulation->internal_force();
  double moment = 0;
  for (const int a : end)
    moment += f[static_cast<std::size_t>(a)].x * (model.mesh.X[static_cast<std::size_t>(a)].z - H / 2);
  return moment / (k * width * (E * H * H * H / 12 + skin * h * H * H / 2));
}

TEST(ShellsOnSolidsBending, ASandwichHasTheStiffnessOfCoreAndSkins) {
  for (const double skin : {1e5, 1e6}) {
    double before = 0;
    for (const int n : {2, 4, 8}) {
      const double ratio = sandwich(n, skin);
      printf("    E of the skins %g, n %2d: moment over the closed form %.4f\n", skin, n, ratio);
      if (before > 0) {
        EXPECT_LT(std::abs(ratio - 1), 0.4 * before);
      }
      before = std::abs(ratio - 1);
    }
    EXPECT_LT(before, 0.01);
  }
}

}  // namespace
}  // namespace glisson::test
