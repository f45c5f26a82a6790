// Quasi-static runs against closed forms, published values and an independent code.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

/// node,X,Y,Z,ux,uy,uz of tests/reference/calculix.
std::vector<std::array<double, 7>> reference(const std::string& name) {
  const char* carried = std::getenv("GLISSON_TEST_SOURCES");  // where the tests run without their sources
  std::ifstream file((carried ? carried : GLISSON_SOURCE_DIR) + ("/tests/reference/calculix/" + name));
  std::vector<std::array<double, 7>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::array<double, 7> row{};
    std::istringstream words(line);
    std::string word;
    for (auto& value : row) {
      std::getline(words, word, ',');
      value = std::stod(word);
    }
    rows.push_back(row);
  }
  return rows;
}

/// The block of tests/reference/calculix/make_case.py: clamped at x = 0, total force 0.03 N along z at x =
/// 0.06.
Model clamped_block(std::array<int, 3> cells, Formulation formulation) {
  const Vec3<double> size{0.06, 0.02, 0.02};
  Model model = box_model(cells, size, formulation, {"NH", {1000, 5000}, 1000});
  model.fixed.push_back({face(model.mesh, 0, 0), all_axes});
  const auto end = face(model.mesh, 0, size.x);
  auto edge = [](double c, double length) { return c < 1e-9 || c > length - 1e-9 ? 0.5 : 1.0; };
  std::vector<double> share;
  for (const int n : end) {
    const auto& X = model.mesh.X[static_cast<std::size_t>(n)];
    share.push_back(edge(X.y, size.y) * edge(X.z, size.z));
  }
  const double total = std::accumulate(share.begin(), share.end(), 0.0);
  for (auto& s : share) s *= 0.03 / total;
  model.forces.push_back({end, 4, share, smooth_curve(1)});
  model.time = relaxed();
  return model;
}

class Static : public Matrix {};

TEST_P(Static, RelaxationFindsTheSolutionOfAnIndependentCode) {
  const Model model = clamped_block({6, 2, 2}, Formulation::t4);
  const auto u = final_displacement(model, GetParam());
  const auto rows = reference("block_c3d4.csv");
  ASSERT_EQ(rows.size(), u.size());
  double largest = 0;
  for (const auto& row : rows) {
    const auto& mine = u[static_cast<std::size_t>(row[0])];
    const auto& X = model.mesh.X[static_cast<std::size_t>(row[0])];
    ASSERT_NEAR(X.x + X.y + X.z, row[1] + row[2] + row[3], 1e-9)
        << "node numbering differs from the reference";
    largest =
        std::max({largest, std::abs(mine.x - row[4]), std::abs(mine.y - row[5]), std::abs(mine.z - row[6])});
  }
  EXPECT_LT(largest, 0.0217 * (5e-6 + 2 * GetParam().rounding()));  // the reference prints 7 digits
}
GLISSON_ALL_CASES(Static);

double tip(const Model& model, const Case& c) {
  const auto u = final_displacement(model, c);
  double mean = 0;
  const auto end = face(model.mesh, 0, 0.06);
  for (const int n : end) mean += u[static_cast<std::size_t>(n)].z / double(end.size());
  return mean;
}

double converged_tip(const std::string& name) {
  const auto rows = reference(name);
  double mean = 0;
  for (const auto& row : rows) mean += row[6] / double(rows.size());
  return mean;
}

TEST(StaticAccuracy, BetterElementsApproachTheConvergedSolution) {
  const double converged = converged_tip("block_c3d20r_end_face.csv");
  EXPECT_NEAR(tip(clamped_block({12, 4, 4}, Formulation::h8_full), threads_float) / converged, 1, 0.03);
  EXPECT_NEAR(tip(clamped_block({12, 4, 4}, Formulation::h8), threads_float) / converged, 1, 0.06);
}

/// Cook's membrane at finite strain, plane strain: u_y at (48, 52) is 14.74 mm (deal.II code gallery, after
/// Miehe 1994). Psi = mu/2 (I1bar - 3) + kappa/4 (J^2 - 1 - 2 ln J): the law AB without chain locking
/// (lambda_m large).
Model cook(int n, Formulation formulation) {
  const double mu = 0.4225, nu = 0.3, kappa = 2 * mu * (1 + nu) / (3 * (1 - 2 * nu));  // N/mm^2, mm
  Model model = box_model({n, n, 1}, {1, 1, 1}, formulation, {"AB", {mu, 1e3, kappa}, 1e-6});
  for (auto& X : model.mesh.X) {
    const double low = 44 * X.x, high = 44 + 16 * X.x;
    X = {48 * X.x, low + (high - low) * X.y, X.z};
  }
  model.fixed.push_back({face(model.mesh, 0, 0), all_axes});
  std::vector<int> all(model.mesh.X.size());
  std::iota(all.begin(), all.end(), 0);
  model.fixed.push_back({all, 4});
  const auto end = face(model.mesh, 0, 48);
  std::vector<double> share;
  for (const int a : end) {
    const double y = model.mesh.X[static_cast<std::size_t>(a)].y;
    share.push_back((y < 44 + 1e-9 || y > 60 - 1e-9 ? 0.5 : 1.0) /
                    (2.0 * n));  // total 1 N over two node layers
  }
  model.forces.push_back({end, 2, share, smooth_curve(1)});
  model.time = relaxed(1e-5, 1e-5);
  return model;
}

double cook_tip(int n, Formulation formulation, const Case& c) {
  const Model model = cook(n, formulation);
  const auto u = final_displacement(model, c);
  for (int a = 0; a < model.mesh.node_count(); ++a) {
    const auto& X = model.mesh.X[static_cast<std::size_t>(a)];
    if (std::abs(X.x - 48) < 1e-9 && std::abs(X.y - 52) < 1e-9) return u[static_cast<std::size_t>(a)].y;
  }
  return 0;
}

TEST(StaticAccuracy, CooksMembraneConverges) {
  const double target = 14.74;
  double error_before = 1;
  for (const int n : {4, 8, 16, 32}) {
    const double u = cook_tip(n, Formulation::h8_full, threads_float), error = std::abs(u / target - 1);
    printf("    %2d elements per edge: %.3f mm\n", n, u);
    EXPECT_LT(error, 0.45 * error_before) << n << " elements per edge";
    error_before = error;
  }
  EXPECT_LT(error_before, 0.003);
  EXPECT_NEAR(cook_tip(32, Formulation::h8, threads_float) / target, 1, 0.006);
}

/// Nearly incompressible block in bending (nu = 0.495): linear tetrahedra lock, the others less.
TEST(StaticAccuracy, AveragedPressureAndHexahedraLockLessThanTetrahedra) {
  const double converged = converged_tip("block_c3d20r_incompressible_end_face.csv");
  auto error = [&](Formulation formulation) {
    Model model = clamped_block({9, 3, 3}, formulation);
    model.sections[0].material.parameters = {1000, 100000};
    model.time = relaxed(1e-4, 1e-4);
    return std::abs(tip(model, threads_float) / converged - 1);
  };
  const double t4 = error(Formulation::t4);
  EXPECT_LT(error(Formulation::t4anp), 0.6 * t4);
  EXPECT_LT(error(Formulation::h8), 0.3 * t4);
  EXPECT_LT(error(Formulation::h8_full), 0.3 * t4);
  RecordProperty("t4_error", std::to_string(t4));
}

}  // namespace
}  // namespace glisson::test
