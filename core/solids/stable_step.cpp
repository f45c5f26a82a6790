#include <glisson/core/solids/stable_step.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include <glisson/core/elements/hexahedron.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/solids/section_laws.hpp>
#include <glisson/core/tensor/symmetric.hpp>

namespace glisson {
namespace {

/// Isotropic solid that is at least as stiff as the law at rest [Pa]. With wave = bulk + 4/3 shear it is the
/// law itself if that is isotropic; fibres, 2 eta (a.dev(e) a)^2 <= 4/3 eta dev(e):dev(e), become the shear
/// modulus 2/3 eta that the wave modulus has for them.
struct Stiffest {
  double bulk, shear;
};

/// Eigenvalues of a symmetric 3x3 matrix, largest first, by the trigonometric solution of the cubic (Smith
/// 1961). Absolute error about 1e-16 of the largest, which is the one that matters here; four times faster
/// than rotations.
std::array<double, 3> eigenvalues(const Sym3<double>& a) {
  const double mean = trace(a) / 3;
  const Sym3<double> d = deviator(a);
  const double p = std::sqrt(contract(d, d) / 6);
  if (!(p > 0)) return {mean, mean, mean};
  const double r = std::clamp(determinant((1 / p) * d) / 2, -1.0, 1.0), angle = std::acos(r) / 3;
  const double first = mean + 2 * p * std::cos(angle),
               last = mean + 2 * p * std::cos(angle + 2.0943951023931957);
  return {first, 3 * mean - first - last, last};
}

Stiffest stiffest(const RestModuli& moduli) { return {moduli.bulk, 0.75 * (moduli.wave - moduli.bulk)}; }

/// Largest eigenvalue of D B B^T [Pa/m^2], the nonzero spectrum of B^T D B, for one point with G = sum_a dN_a
/// dN_a^T. It maps a stress s to D sym(s G). Along the principal axes of G (values g) shear stresses
/// decouple, mu (g_i + g_j), and the normal ones leave the matrix 2 mu diag(g) + lambda sqrt(g_i g_j).
double point_stiffness(const Sym3<double>& G, const Stiffest& solid) {
  const auto e = eigenvalues(G);
  const double mu = solid.shear, lambda = solid.bulk - 2.0 / 3 * mu;
  double g[3], root[3], shear = 0;
  for (int i = 0; i < 3; ++i) g[i] = std::max(e[std::size_t(i)], 0.0), root[i] = std::sqrt(g[i]);
  for (int i = 0; i < 3; ++i) shear = std::max(shear, mu * (g[i] + g[(i + 1) % 3]));
  const Sym3<double> normal{(2 * mu + lambda) * g[0],   (2 * mu + lambda) * g[1],
                            (2 * mu + lambda) * g[2],   lambda * root[0] * root[1],
                            lambda * root[1] * root[2], lambda * root[0] * root[2]};
  return std::max(shear, eigenvalues(normal)[0]);
}

Sym3<double> gram(const HexahedronGradient& g) {
  Sym3<double> G{};
  for (const auto& B : g.B) G = G + dyad(Vec3<double>{B[0], B[1], B[2]});
  return G;
}

/// What an element's step follows from.
struct ElementStiffness {
  double largest = 0;  ///< eigenvalue of K, or a bound from above [N/m]
  double volume = 0;   ///< [m^3]
  double squares = 0;  ///< sum |dN_a|^2 over all but the first node of T4, over all of H8 [1/m^2]
};

ElementStiffness tetrahedron(const Vec3<double> (&X)[4], const Stiffest& solid) {
  const auto c = T4::make(X);
  Vec3<double> first{};
  Sym3<double> G{};
  for (const auto& row : c.B) {
    const Vec3<double> dN{row[0], row[1], row[2]};
    G = G + dyad(dN);
    first = first - dN;
  }
  return {c.volume * point_stiffness(G + dyad(first), solid), c.volume, trace(G)};
}

/// Largest eigenvalue of a A + b B for projections A, B whose ranges enclose an angle of this cos^2.
double of_two_projections(double a, double b, double cos2) {
  return 0.5 * (a + b + std::sqrt((a - b) * (a - b) + 4 * a * b * std::min(cos2, 1.0)));
}

/// Gradients and hourglass vectors are orthogonal in a parallelepiped. Otherwise cos^2 between their spans is
/// bounded by the sum of the squares of all principal cosines.
ElementStiffness one_point(const Vec3<double> (&X)[8], const Stiffest& solid,
                           const HexahedronGradient& gradient, double exact_volume, double modulus) {
  Eigen::Matrix<double, 8, 3> B;
  Eigen::Matrix<double, 8, 4> hourglass;
  for (int a = 0; a < 8; ++a) {
    for (int j = 0; j < 3; ++j) B(a, j) = gradient.B[a][j];
    for (int m = 0; m < 4; ++m) hourglass(a, m) = mode_sign(3 + m, a);
  }
  Eigen::Matrix<double, 8, 3> x;
  for (int a = 0; a < 8; ++a) x.row(a) << X[a].x - X[0].x, X[a].y - X[0].y, X[a].z - X[0].z;
  const Eigen::Matrix<double, 8, 4> gamma = hourglass - B * (x.transpose() * hourglass);
  const Eigen::Matrix4d springs = gamma.transpose() * gamma;
  const Eigen::Matrix<double, 3, 4> mixed = B.transpose() * gamma;
  const Eigen::Matrix3d bb = B.transpose() * B;
  const double cos2 = (bb.inverse() * mixed * springs.inverse() * mixed.transpose()).trace();
  const double largest =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(springs, Eigen::EigenvaluesOnly).eigenvalues()(3);
  const Sym3<double> G = gram(gradient);
  const double k = modulus * exact_volume * trace(G) / 8;
  return {of_two_projections(gradient.volume * point_stiffness(G, solid), k * largest, cos2), exact_volume,
          trace(G)};
}

/// K <= sum of the points' largest eigenvalues, with the volumetric part at each point (the mean has no more
/// energy) or once for the mean gradient; the smaller of the two counts.
ElementStiffness full(const Vec3<double> (&X)[8], const Stiffest& solid) {
  double together = 0, isochoric = 0;
  for (int p = 0; p < 8; ++p) {
    double point[3];
    gauss_point(p, point);
    const HexahedronGradient g = gradient_at(X, point);
    const Sym3<double> G = gram(g);
    together += g.volume / 8 * point_stiffness(G, solid);
    isochoric += g.volume / 8 * point_stiffness(G, {0, solid.shear});
  }
  const HexahedronGradient mean = mean_gradient(X);
  const double squares = trace(gram(mean));
  return {std::min(together, isochoric + solid.bulk * mean.volume * squares), mean.volume, squares};
}

template <int N>
void corners(const Mesh& mesh, int e, Vec3<double> (&X)[N]) {
  const auto nodes = mesh.element(e);
  for (std::size_t a = 0; a < N; ++a) X[a] = mesh.X[static_cast<std::size_t>(nodes[a])];
}

ElementStiffness stiffness_of(const Mesh& mesh, int e, const Section& section, const Stiffest& solid,
                              double hourglass) {
  if (shape_of(section.formulation) == Shape::tetrahedron) {
    Vec3<double> X[4];
    corners(mesh, e, X);
    return tetrahedron(X, solid);  // T4ANP averages J, which takes energy away: Jensen's inequality
  }
  Vec3<double> X[8];
  corners(mesh, e, X);
  if (section.formulation == Formulation::h8_full) return full(X, solid);
  const HexahedronGradient mean = mean_gradient(X);
  const bool fixed = section.formulation == Formulation::h8_fixed;
  return one_point(X, solid, fixed ? centre_gradient(X) : mean, mean.volume, hourglass);
}

}  // namespace

void visit_element_steps(const Model& model,
                         const std::function<void(int, double, double, double, double)>& visit) {
  std::vector<double> parameters;
  for (const Section& section : model.sections) {
    Stiffest solid{};
    double hourglass = 0;
    const double rho = section.material.density;
    for (std::size_t k = 0; k < section.elements.size(); ++k) {
      if (k == 0 || !section.material.element_parameters.empty()) {
        element_parameters(section, k, parameters);
        solid = stiffest(rest_moduli(section.material.law, parameters));
        hourglass = hourglass_stiffness(section, parameters);
      }
      const int e = section.elements[k];
      const ElementStiffness s = stiffness_of(model.mesh, e, section, solid, hourglass);
      const double nodal_mass = rho * s.volume / node_count_of(shape_of(section.formulation));
      visit(e, 2 / std::sqrt(s.largest / nodal_mass), s.volume, 1 / std::sqrt(s.squares), rho);
    }
  }
}

StableStep element_stable_step(const Model& model) {
  StableStep smallest;
  visit_element_steps(model, [&](int e, double dt, double, double size, double) {
    if (dt < smallest.dt) smallest.dt = dt, smallest.element = e;
    smallest.smallest_size = std::min(smallest.smallest_size, size);
  });
  return smallest;
}

}  // namespace glisson
