// What must hold of every element whatever the mesh: linear fields, rigid motions, momentum.
#include <glisson/core/elements/h8.hpp>

#include "solid_bench.hpp"

namespace glisson::test {
namespace {

template <class T>
class Elements : public InBothPrecisions<T> {};
TYPED_TEST_SUITE(Elements, Precisions);

const Mat3<double> stretch{{{0.11, 0.23, 0.15}, {0.19, 0.06, 0.08}, {0.01, 0.06, 0.18}}};

bool inside(const Vec3<double>& X) {
  auto in = [](double c) { return c > 1e-6 && c < 1 - 1e-6; };
  return in(X.x) && in(X.y) && in(X.z);
}

/// Largest force on interior nodes over the largest on the surface, for a linear displacement.
template <class R>
double patch_ratio(const Model& model) {
  SolidBench<R> bench(model);
  const Field f = bench.forces(affine(model.mesh, stretch));
  double interior = 0, boundary = 0;
  for (std::size_t n = 0; n < f.size(); ++n)
    (inside(model.mesh.X[n]) ? interior : boundary) =
        std::max(inside(model.mesh.X[n]) ? interior : boundary, length(f[n]));
  return interior / boundary;
}

TYPED_TEST(Elements, PassThePatchTestOnDistortedMeshes) {
  for (const Formulation formulation : all_formulations) {
    if (formulation == Formulation::h8_fixed) continue;
    EXPECT_LT(patch_ratio<TypeParam>(cube(formulation)), 1000 * SolidBench<TypeParam>::epsilon())
        << name_of(formulation);
  }
}

TYPED_TEST(Elements, WithCentreGradientsPassItForParallelepipedsOnly) {
  EXPECT_LT(patch_ratio<TypeParam>(cube(Formulation::h8_fixed, 0)), 1000 * SolidBench<TypeParam>::epsilon());
  EXPECT_GT(patch_ratio<TypeParam>(cube(Formulation::h8_fixed, 0.15)), 1e-3);
}

TYPED_TEST(Elements, FeelNoRigidMotion) {
  for (const Formulation formulation : all_formulations)
    for (const double angle : {0.3, M_PI / 2, M_PI}) {
      const Model model = cube(formulation);
      SolidBench<TypeParam> bench(model);
      const Field rest(model.mesh.X.size());
      const Field f = bench.forces(turned(model.mesh, rest, rotation(angle), {0.5, -1, 2}));
      // u is rounded to |u| eps <= 4 eps, so H is off by up to 4 eps / h per edge; f = stress x h^2.
      const double h = 1.0 / 3, rounding = 4 * SolidBench<TypeParam>::epsilon() / h;
      EXPECT_LT(largest(f), 20 * rounding * (kappa + 4.0 / 3 * mu) * h * h)
          << name_of(formulation) << " " << angle;
    }
}

TYPED_TEST(Elements, TurnTheirForcesWithTheBody) {
  for (const Formulation formulation : all_formulations) {
    const Model model = cube(formulation);
    SolidBench<TypeParam> bench(model);
    const Field u = random_field(model.mesh.X.size(), 0.03);
    const Mat3<double> Q = rotation(M_PI / 2);
    Field f = bench.forces(u);
    for (auto& a : f) a = apply(Q, a);
    const Field g = bench.forces(turned(model.mesh, u, Q));
    EXPECT_LT(largest_difference(f, g), 500 * SolidBench<TypeParam>::epsilon() * largest(f))
        << name_of(formulation);
  }
}

TYPED_TEST(Elements, KeepMomentumAndAngularMomentum) {
  for (const Formulation formulation : all_formulations) {
    const Model model = cube(formulation);
    SolidBench<TypeParam> bench(model);
    const Field u = random_field(model.mesh.X.size(), 0.05);
    const Field f = bench.forces(u);
    Vec3<double> sum{}, moment{};
    for (std::size_t n = 0; n < f.size(); ++n) {
      sum = sum + f[n];
      moment = moment + cross(model.mesh.X[n] + u[n], f[n]);
    }
    EXPECT_LT(length(sum), 100 * SolidBench<TypeParam>::epsilon() * largest(f)) << name_of(formulation);
    EXPECT_LT(length(moment), 100 * SolidBench<TypeParam>::epsilon() * largest(f)) << name_of(formulation);
  }
}

/// Bricks and tetrahedra that fill a chessboard, or one kind only.
Model chessboard(bool with_bricks, bool with_tetrahedra) {
  Model model = cube(Formulation::h8);
  const Mesh whole = model.mesh;
  Mesh mesh;
  mesh.X = whole.X;
  Section bricks = model.sections[0], tetrahedra = bricks;
  tetrahedra.formulation = Formulation::t4;
  bricks.elements.clear();
  tetrahedra.elements.clear();
  constexpr int kuhn[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                              {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  for (int e = 0; e < whole.element_count(); ++e) {
    const auto nodes = whole.element(e);
    if (e % 2 && with_tetrahedra)
      for (const auto& corner : kuhn) {
        int tetrahedron[4];
        for (int a = 0; a < 4; ++a) tetrahedron[a] = nodes[std::size_t(corner[a])];
        tetrahedra.elements.push_back(mesh.element_count());
        mesh.add_element(Shape::tetrahedron, tetrahedron);
      }
    if (e % 2 == 0 && with_bricks) {
      bricks.elements.push_back(mesh.element_count());
      mesh.add_element(Shape::hexahedron, nodes);
    }
  }
  model.mesh = mesh;
  model.sections = {bricks, tetrahedra};
  return model;
}

TYPED_TEST(Elements, MixInOneMesh) {
  const Model mixed = chessboard(true, true);
  const Field u = random_field(mixed.mesh.X.size(), 0.03), f = SolidBench<TypeParam>(mixed).forces(u);
  Field sum = SolidBench<TypeParam>(chessboard(true, false)).forces(u);
  const Field other = SolidBench<TypeParam>(chessboard(false, true)).forces(u);
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] = sum[n] + other[n];
  EXPECT_LT(largest_difference(f, sum), 10 * SolidBench<TypeParam>::epsilon() * largest(f));
}

/// The closed form of the constants against 2x2x2 points, which integrate the gradients exactly.
TYPED_TEST(Elements, HexahedraHaveTheConstantsOfTheirIntegrals) {
  using R = TypeParam;
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> bend(-0.2, 0.2);
  const double tolerance = 20 * SolidBench<R>::epsilon(), stiffness = 3;
  for (int k = 0; k < 200; ++k) {
    Vec3<double> X[8];
    Vec3<R> rounded[8];
    for (int a = 0; a < 8; ++a) {
      const auto at = [&](int axis) { return double(float(0.5 * corner_sign(a, axis) + bend(engine))); };
      X[a] = {at(0), at(1), at(2)};
      rounded[a] = {R(X[a].x), R(X[a].y), R(X[a].z)};
    }
    for (const bool at_centre : {false, true}) {
      const auto c = H8::rest_constants(rounded, R(stiffness), at_centre);
      const HexahedronGradient exact = at_centre ? centre_gradient(X) : mean_gradient(X);
      double squares = 0;
      for (int a = 0; a < 8; ++a)
        for (int j = 0; j < 3; ++j) {
          double B = 0;
          for (int i = 0; i < 3; ++i)
            B += mode_sign(i, a) * double(c.beta[i][j]) + mode_sign(3 + i, a) * double(c.eta[i][j]);
          EXPECT_NEAR(B, exact.B[a][j], tolerance);
          squares += exact.B[a][j] * exact.B[a][j];
        }
      EXPECT_NEAR(double(c.volume), exact.volume, tolerance);
      EXPECT_NEAR(double(c.hourglass), stiffness * mean_gradient(X).volume * squares / 8, 10 * tolerance);
    }
  }
}

}  // namespace
}  // namespace glisson::test
