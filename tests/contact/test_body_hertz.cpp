// A ball pressed on a rigid plane against the solution of Hertz (1882; Johnson 1985, section 4.2).
#include <gtest/gtest.h>

#include <tests/contact/bodies.hpp>

namespace glisson::test {
namespace {

/// R, E and nu are those of the verification cases; the load is smaller, so that the contact is small against
/// the ball: its radius is 0.01 R.
struct Hertz {
  static constexpr double pi = 3.14159265358979, R = 0.02, E = 1e4, nu = 0.45, a = 0.01 * R;
  static constexpr double force = 4 * E / (1 - nu * nu) * a * a * a / (3 * R), approach = a * a / R;
  static constexpr double peak = 3 * force / (2 * pi * a * a);
  static constexpr int cells_per_radius = 6;

  Model model;
  Body ball;
  double size = 0;  ///< edge of the piece of the ball [m]

  /// A quarter of the surroundings of the contact, 8 a in size, with a finer mesh where it touches. The floor
  /// is a body all of whose nodes are held.
  Hertz() {
    const Material rubber{"LE", {E, nu}, 1000};
    const std::vector<double> lines = grid();
    size = lines.back();
    const int cells = static_cast<int>(lines.size()) - 1;
    const double n = cells;
    Mesh piece = box_mesh({cells, cells, cells}, {n, n, n}, Shape::hexahedron);
    const auto at = [&](double i) { return lines[static_cast<std::size_t>(std::lround(i))]; };
    for (auto& X : piece.X) X = {at(X.x), at(X.y), at(X.z)};
    const std::vector<Vec3<double>> half_space = piece.X;
    for (auto& X : piece.X) X.z += (X.x * X.x + X.y * X.y) / (2 * R) * (1 - X.z / size);
    ball = add_body(model, piece, Formulation::h8, rubber);
    Mesh floor = box_mesh({5, 5, 1}, {3 * a, 3 * a, 0.5 * a}, Shape::hexahedron);
    move(floor, {-0.4 * a, -0.4 * a, -0.5 * a});
    model.fixed.push_back({add_body(model, floor, Formulation::h8, rubber).nodes(), all_axes});
    constrain(half_space);
    model.contact.between_bodies = true;
    model.time = relaxed();
  }

 private:
  static std::vector<double> grid() {
    std::vector<double> lines{0};
    for (double h = a / cells_per_radius; lines.back() < 8 * a; lines.push_back(lines.back() + h))
      if (lines.back() > 1.49 * a) h *= 1.25;
    return lines;
  }
  /// Far from the contact the ball moves down by the approach and as a half-space under a point force does
  /// (Boussinesq 1885; Johnson 1985, eq. 3.18).
  static Vec3<double> far(const Vec3<double>& X) {
    const double r = std::sqrt(X.x * X.x + X.y * X.y), rho = std::sqrt(r * r + X.z * X.z);
    const double c = force * (1 + nu) / (2 * pi * E);
    const double aside = c * (X.z / (rho * rho * rho) - (1 - 2 * nu) / (rho * (rho + X.z)));
    const double along = c * (X.z * X.z / (rho * rho * rho) + 2 * (1 - nu) / rho);
    return {aside * X.x, aside * X.y, along - approach};
  }
  void constrain(const std::vector<Vec3<double>>& half_space) {
    std::vector<int> outer, on_x, on_y;
    std::vector<double> x, y, z;
    for (const int n : ball.nodes()) {
      const auto& X = half_space[static_cast<std::size_t>(n)];
      if (std::max({X.x, X.y, X.z}) > 0.999 * size) {
        const auto u = far(X);
        outer.push_back(n);
        x.push_back(u.x), y.push_back(u.y), z.push_back(u.z);
        continue;
      }
      if (X.x == 0) on_x.push_back(n);
      if (X.y == 0) on_y.push_back(n);
    }
    model.fixed.push_back({on_x, 1});
    model.fixed.push_back({on_y, 2});
    model.displacements.push_back({outer, 1, x, ramp_curve(1)});
    model.displacements.push_back({outer, 2, y, ramp_curve(1)});
    model.displacements.push_back({outer, 4, z, ramp_curve(1)});
  }
};

/// The radius follows from the moment of the pressure: integral p r^2 dA = 2/5 a^2 F.
TEST(BodyContactHertz, ABallOnARigidPlaneIsPressedAsInTheClosedForm) {
  const Hertz hertz;
  auto simulation = simulate(hertz.model, threads_float);
  while (!simulation->finished()) simulation->step(100);
  const auto f = simulation->contact_force();
  double quarter = 0, moment = 0, centre = 0;
  for (const int n : hertz.ball.nodes()) {
    const auto& X = hertz.model.mesh.X[static_cast<std::size_t>(n)];
    const double fz = f[static_cast<std::size_t>(n)].z, r2 = X.x * X.x + X.y * X.y;
    quarter += fz;
    moment += fz * r2;
    if (r2 + X.z * X.z == 0) centre = fz;
  }
  const double h = Hertz::a / Hertz::cells_per_radius;
  EXPECT_NEAR(4 * quarter / Hertz::force, 1, 0.03);
  EXPECT_NEAR(std::sqrt(2.5 * moment / quarter) / Hertz::a, 1, 0.03);
  EXPECT_NEAR(centre / (h * h / 4) / Hertz::peak, 1, 0.03);
  EXPECT_LT(simulation->contacts().at(0).report.depth, 0.01 * h);
}

}  // namespace
}  // namespace glisson::test
