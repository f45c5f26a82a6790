// Edges of membranes and shells: free, clamped, symmetric, and those where more than two triangles meet.
#include <gtest/gtest.h>

#include <algorithm>

#include <glisson/core/base/error.hpp>
#include <tests/shells/sheets.hpp>
#include <tests/shells/statics.hpp>
#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

enum class Edge { free, clamped, symmetric };

/// A profile in the x-z plane, drawn out along y: the edge s = 0 can be clamped, the edge y = 0 lies in a
/// plane. bend: curvature; fold: angle of a kink in the middle.
Model profile(Edge edge, double bend, double fold) {
  Model model = sheet(
      4, 3,
      [=](double s, double t) {
        const double beyond = std::max(s - 0.5, 0.0);
        return Vec3<double>{s - beyond * (1 - std::cos(fold)), t + 0.05 * t * (1 - t) * std::sin(8 * s),
                            0.5 * bend * s * s + beyond * std::sin(fold)};
      },
      shell_section(1e6, 0.3, 0.02));
  if (edge == Edge::clamped)
    model.clamped_nodes = sheet_nodes(model, [](const auto& X) { return X.x < 1e-9; });
  if (edge == Edge::symmetric)
    model.planes.push_back({sheet_nodes(model, [](const auto& X) { return X.y < 1e-9; }), {0, 1, 0}});
  return model;
}

/// Rotation about a unit axis through the origin (Rodrigues), then a shift.
Vec3<double> moved(const Vec3<double>& X, const Vec3<double>& axis, double angle, const Vec3<double>& shift) {
  return std::cos(angle) * X + std::sin(angle) * cross(axis, X) +
         ((1 - std::cos(angle)) * dot(axis, X)) * axis + shift;
}

double largest_force(const Model& model, const Vec3<double>& axis, double angle, const Vec3<double>& shift) {
  ShellStatics statics(model, FixedDirections(model.mesh.X.size()));
  for (std::size_t n = 0; n < model.mesh.X.size(); ++n)
    statics.u()[n] = moved(model.mesh.X[n], axis, angle, shift) - model.mesh.X[n];
  std::vector<Vec3<double>> f;
  std::vector<MatrixEntry> K;
  statics.evaluate(f, K);
  double largest = 0;
  for (const auto& g : f) largest = std::max(largest, std::sqrt(dot(g, g)));
  return largest;
}

constexpr double shapes[][2] = {{0, 0}, {0.4, 0}, {0, 1.2}, {-0.3, 0.8}};

TEST(ShellEdges, AFreeShellTurnsAnyWayWithoutForce) {
  const Vec3<double> axis{2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (const auto& shape : shapes)
    for (const double angle : {0.3, 2.5})
      EXPECT_LT(largest_force(profile(Edge::free, shape[0], shape[1]), axis, angle, {3, -1, 2}), 1e-8);
}

/// A mirror plane lets pass what keeps its normal: shifts, and turns about the normal. About the edge itself
/// the shell resists.
TEST(ShellEdges, ASymmetryEdgeTurnsAboutThePlanesNormalOnly) {
  for (const auto& shape : shapes) {
    const Model model = profile(Edge::symmetric, shape[0], shape[1]);
    EXPECT_LT(largest_force(model, {0, 1, 0}, 2.5, {3, -1, 2}), 1e-8);
    EXPECT_GT(largest_force(model, {1, 0, 0}, 0.1, {}), 1);
  }
}

/// The same for the plane normal to the shell along the clamped edge.
TEST(ShellEdges, AClampedEdgeTurnsAboutTheNormalOfItsPlaneOnly) {
  for (const auto& shape : shapes) {
    const Model model = profile(Edge::clamped, shape[0], shape[1]);
    const Vec3<double> along = model.mesh.X[1] - model.mesh.X[0];
    const double size = std::sqrt(along.x * along.x + along.z * along.z);
    EXPECT_LT(largest_force(model, {along.x / size, 0, along.z / size}, 2.5, {3, -1, 2}), 1e-8);
    EXPECT_GT(largest_force(model, {0, 1, 0}, 0.1, {}), 1);
  }
}

class RigidShells : public Matrix {};

/// Through the engine: every node is put where a turn of 90 degrees leaves it.
TEST_P(RigidShells, HaveNoInternalForceOnAnyBackend) {
  for (const Edge edge : {Edge::free, Edge::clamped, Edge::symmetric})
    for (const auto& shape : shapes) {
      Model model = profile(edge, shape[0], shape[1]);
      const Vec3<double> along = model.mesh.X[1] - model.mesh.X[0];
      const double size = std::sqrt(along.x * along.x + along.z * along.z);
      const Vec3<double> axis =
          edge == Edge::clamped ? Vec3<double>{along.x / size, 0, along.z / size} : Vec3<double>{0, 1, 0};
      for (int n = 0; n < model.mesh.node_count(); ++n) {
        const auto& X = model.mesh.X[static_cast<std::size_t>(n)];
        const auto u = moved(X, axis, pi / 2, {0.3, 0, 0.2}) - X;
        model.displacements.push_back({{n}, 1, {u.x}, step_curve(1)});
        model.displacements.push_back({{n}, 4, {u.z}, step_curve(1)});
        if (edge != Edge::symmetric || X.y > 1e-9)
          model.displacements.push_back({{n}, 2, {u.y}, step_curve(1)});
      }
      model.time.total = 1, model.time.step = 0.1, model.time.energy_tolerance = 0;
      auto simulation = simulate(model, GetParam());
      simulation->step(2);
      const auto u = simulation->displacement().back(), X = model.mesh.X.back();
      const auto d = X + u - moved(X, axis, pi / 2, {0.3, 0, 0.2});
      ASSERT_LT(std::sqrt(dot(d, d)), 1e-6);
      double largest = 0;
      for (const auto& f : simulation->internal_force()) largest = std::max(largest, std::sqrt(dot(f, f)));
      EXPECT_LT(largest, 1e6 * 0.02 * GetParam().rounding());  // of E h times the size
    }
}
GLISSON_ALL_CASES(RigidShells);

/// A panel, curved across x = 0, and its mirror image sewn to it.
Model half_panel(int n) {
  return sheet(
      n, n,
      [](double s, double t) {
        return Vec3<double>{0.5 * s, t, 0.1 * std::cos(2 * s) + 0.02 * t * t};
      },
      shell_section(1e6, 0.3, 0.02));
}
Model whole_panel(int n) {
  Model model = half_panel(n);
  const auto half = model.mesh;
  std::vector<int> image;
  for (int k = 0; k < half.node_count(); ++k) {
    const auto& X = half.X[static_cast<std::size_t>(k)];
    image.push_back(X.x == 0 ? k : model.mesh.node_count());
    if (X.x != 0) model.mesh.X.push_back({-X.x, X.y, X.z});
  }
  const auto at = [&](int k) { return image[static_cast<std::size_t>(k)]; };
  // the first two nodes change places, so that the first local axis is mirrored too
  for (const auto& t : half.triangles) model.mesh.triangles.push_back({at(t[1]), at(t[0]), at(t[2])});
  model.shells[0].elements.resize(model.mesh.triangles.size());
  std::iota(model.shells[0].elements.begin(), model.shells[0].elements.end(), 0);
  return model;
}

/// Displacement under a weight of `load` per area at rest, borders clamped but for the symmetry line.
std::vector<Vec3<double>> loaded(Model model, double load) {
  const auto border = sheet_nodes(
      model, [](const auto& X) { return std::abs(std::abs(X.x) - 0.5) < 1e-12 || X.y == 0 || X.y == 1; });
  model.clamped_nodes = border;
  FixedDirections fixed(model.mesh.X.size());
  fix(fixed, border, "xyz");
  const bool half = sheet_nodes(model, [](const auto& X) { return X.x < 0; }).empty();
  if (half) {
    const auto line = sheet_nodes(model, [](const auto& X) { return X.x == 0; });
    model.planes.push_back({line, {1, 0, 0}});
    fix(fixed, line, "x");
  }
  validate(model);
  ShellStatics statics(model, fixed);
  for (int part = 1; part <= 4; ++part) {
    std::vector<Vec3<double>> f(model.mesh.X.size());
    for (const auto& t : model.mesh.triangles) {
      const auto X = [&](std::size_t a) { return model.mesh.X[static_cast<std::size_t>(t[a])]; };
      const auto N = cross(X(1) - X(0), X(2) - X(0));
      for (const int n : t) f[static_cast<std::size_t>(n)].z -= 0.25 * part * load * std::sqrt(dot(N, N)) / 6;
    }
    EXPECT_TRUE(statics.solve(f, 1e-10));
  }
  return statics.u();
}

TEST(ShellEdges, HalfAPanelWithASymmetryEdgeBendsAsTheWholeOne) {
  const auto half = loaded(half_panel(6), 500), whole = loaded(whole_panel(6), 500);
  double largest = 0;
  for (std::size_t n = 0; n < half.size(); ++n) {
    const auto d = half[n] - whole[n];
    EXPECT_LT(std::sqrt(dot(d, d)), 1e-12) << n;
    largest = std::max(largest, -half[n].z);
  }
  EXPECT_GT(largest, 0.005);
}

/// Strips that leave one edge (nodes 0 to n) as the pages of a book, in the x-y plane turned about x.
Model book(int pages, ShellSection section) {
  Model model;
  const int n = 4;
  for (int i = 0; i <= n; ++i) model.mesh.X.push_back({double(i) / n, 0, 0});
  for (int page = 0; page < pages; ++page) {
    const double angle = 2 * pi * page / pages;
    const int first = model.mesh.node_count();
    for (int i = 0; i <= n; ++i)
      model.mesh.X.push_back({double(i) / n, 0.2 * std::cos(angle), 0.2 * std::sin(angle)});
    for (int i = 0; i < n; ++i) {
      model.mesh.triangles.push_back({i, i + 1, first + i + 1});
      model.mesh.triangles.push_back({i, first + i + 1, first + i});
    }
  }
  section.elements.resize(model.mesh.triangles.size());
  std::iota(section.elements.begin(), section.elements.end(), 0);
  model.shells = {std::move(section)};
  model.time.total = 1;
  return model;
}

/// Three membranes at one edge pull as three strips in parallel, mu (l - 1 / l^2) each.
TEST(ShellEdges, MembranesMayBranch) {
  const double mu = 1000, h = 1e-3, stretch = 1.4;
  const Model model = book(3, membrane_section("NeoHookean", {mu}, h));
  validate(model);
  FixedDirections fixed(model.mesh.X.size());
  fix(fixed, sheet_nodes(model, [](const auto& X) { return X.x == 0 || X.x == 1; }), "x");
  fix(fixed, {0, 1, 2, 3, 4}, "yz");
  ShellStatics statics(model, fixed);
  const double narrow = 1 / std::sqrt(stretch);
  for (std::size_t k = 0; k < model.mesh.X.size(); ++k) {
    const auto& X = model.mesh.X[k];
    statics.u()[k] = {(stretch - 1) * X.x, (narrow - 1) * X.y, (narrow - 1) * X.z};
  }
  std::vector<Vec3<double>> f;
  std::vector<MatrixEntry> K;
  statics.evaluate(f, K);
  double pull = 0;
  for (std::size_t k = 0; k < f.size(); ++k) {
    if (model.mesh.X[k].x == 1) pull -= f[k].x;
    EXPECT_NEAR(f[k].y, 0, 1e-12);
    EXPECT_NEAR(f[k].z, 0, 1e-12);
  }
  EXPECT_NEAR(pull, 3 * mu * (stretch - 1 / (stretch * stretch)) * 0.2 * h, 1e-12);
}

TEST(ShellEdges, RotationFreeShellsMayNotBranchButMembranesMayLeaveThem) {
  const Model model = book(3, shell_section(1e6, 0.3, 0.01));
  try {
    validate(model);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("shell edge 0 - 1"), std::string::npos) << text;
    EXPECT_NE(text.find("use membranes there, or give the parts nodes of their own"), std::string::npos)
        << text;
  }
  // two pages bend, the third is a membrane
  Model mixed = model;
  ShellSection third = membrane_section("NeoHookean", {1000}, 0.01);
  auto& bent = mixed.shells[0].elements;
  third.elements.assign(bent.begin() + 16, bent.end());
  bent.resize(16);
  mixed.shells.push_back(third);
  for (std::size_t e = 8; e < 16; ++e) std::swap(mixed.mesh.triangles[e][0], mixed.mesh.triangles[e][1]);
  EXPECT_NO_THROW(validate(mixed));
  EXPECT_LT(largest_force(mixed, {1, 0, 0}, 0.7, {1, 2, 3}), 1e-8);
}

/// A neighbour is found by shared nodes. Without one a side is free; where another side lies on it with nodes
/// of its own, that is said.
TEST(ShellEdges, SeamsWithoutSharedNodesAreWarnedOf) {
  Model model = sheet(
      2, 1,
      [](double s, double t) {
        return Vec3<double>{s, t, 0};
      },
      shell_section(1e6, 0.3, 0.01));
  const auto seam = [](const std::string& warning) {
    return warning.find("lie on each other without sharing their nodes") != std::string::npos;
  };
  auto warnings = validate(model);
  EXPECT_TRUE(std::none_of(warnings.begin(), warnings.end(), seam));
  // the right half gets nodes 6 and 7 of its own on the line x = 0.5 (nodes 1 and 4)
  model.mesh.X.push_back(model.mesh.X[1]);
  model.mesh.X.push_back(model.mesh.X[4]);
  for (auto& t : model.mesh.triangles)
    if (t[0] == 2 || t[1] == 2 || t[2] == 2 || t[1] == 5)
      for (int& n : t) n = n == 1 ? 6 : n == 4 ? 7 : n;
  warnings = validate(model);
  const auto found = std::find_if(warnings.begin(), warnings.end(), seam);
  ASSERT_NE(found, warnings.end());
  EXPECT_NE(found->find("1 pair of edges"), std::string::npos) << *found;
  EXPECT_NE(found->find("1 - 4 and 6 - 7"), std::string::npos) << *found;
  // membranes have no moments, but no force passes either
  model.shells = {membrane_section("NeoHookean", {1000}, 0.01)};
  model.shells[0].elements = {0, 1, 2, 3};
  warnings = validate(model);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), seam));
}

TEST(ShellEdges, AShellFoldedFlatOntoItselfIsRefused) {
  Model model;
  model.mesh.X = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.01, 1, 0}};
  model.mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  model.shells = {shell_section(1e6, 0.3, 0.01)};
  model.shells[0].elements = {0, 1};
  try {
    shells::make_shell_blocks(model);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("shell triangle 0: it is folded flat onto its neighbour"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace glisson::test
