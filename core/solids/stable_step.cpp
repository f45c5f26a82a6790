#include <glisson/core/solids/stable_step.hpp>

#include <cmath>

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/materials/st_venant_kirchhoff.hpp>
#include <glisson/core/solids/section_laws.hpp>

namespace glisson {
namespace {

/// Stress of an isotropic solid of the rest moduli for small H: 2 mu eps + lambda tr eps I, with lambda + 2 mu raised to the law's wave modulus.
struct LinearStress {
  double lambda, mu;
  Mat3<double> operator()(const Mat3<double>& H, int) const {
    Mat3<double> P;
    const double pressure = lambda * trace(H);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) P.m[i][k] = mu * (H.m[i][k] + H.m[k][i]) + (i == k ? pressure : 0.0);
    return P;
  }
};

template <int N>
double norm(const Vec3<double> (&a)[N]) {
  double sum = 0;
  for (const auto& v : a) sum += dot(v, v);
  return std::sqrt(sum);
}

/// Largest eigenvalue of K / m of one element with equal nodal masses, by power iteration on its forces at small displacement.
/// The start excites every mode; the growth of the norm in the last steps is a bound from below, so 1 % is added.
template <class E>
double omega_squared(const typename E::template Constants<double>& c, const LinearStress& stress, double nodal_mass, double size) {
  constexpr int N = E::node_count, iterations = 12;
  Vec3<double> x[N], f[N];
  for (int a = 0; a < N; ++a) x[a] = {std::sin(1.3 * a + 0.2), std::cos(2.1 * a + 0.5), std::sin(0.7 * a * a + 1.1)};
  double growth = 0;
  for (int i = 0; i < iterations; ++i) {
    const double scale = 1e-7 * size / norm<N>(x);  // linear also for formulations with F-bar
    for (auto& v : x) v = scale * v;
    E::forces(c, x, stress, f);
    growth = norm<N>(f) / norm<N>(x);
    for (int a = 0; a < N; ++a) x[a] = f[a];
  }
  return 1.01 * growth / nodal_mass;
}

template <class E, class Make>
void visit_section(const Model& model, const Section& section, const Make& make,
                   const std::function<void(int, double, double, double, double)>& visit) {
  std::vector<double> parameters;
  for (std::size_t k = 0; k < section.elements.size(); ++k) {
    const int e = section.elements[k];
    element_parameters(section, k, parameters);
    const RestModuli moduli = rest_moduli(section.material.law, parameters);
    Vec3<double> X[E::node_count];
    const auto nodes = model.mesh.element(e);
    for (std::size_t a = 0; a < nodes.size(); ++a) X[a] = model.mesh.X[static_cast<std::size_t>(nodes[a])];
    double volume = 0, squares = 0;
    if constexpr (E::node_count == 4) {
      const auto c = T4::make(X);
      volume = c.volume;
      for (const auto& row : c.B) squares += row[0] * row[0] + row[1] * row[1] + row[2] * row[2];
    } else {
      const auto g = mean_gradient(X);
      volume = g.volume;
      for (const auto& row : g.B) squares += row[0] * row[0] + row[1] * row[1] + row[2] * row[2];
    }
    const double size = 1 / std::sqrt(squares), rho = section.material.density;
    const auto c = make(X, hourglass_stiffness(section, parameters));
    const LinearStress stress{moduli.wave - 2 * moduli.shear, moduli.shear};
    const double omega2 = omega_squared<E>(c, stress, rho * volume / E::node_count, size);
    visit(e, 2 / std::sqrt(omega2), volume, size, rho);
  }
}

}  // namespace

void visit_element_steps(const Model& model, const std::function<void(int, double, double, double, double)>& visit) {
  for (const Section& section : model.sections) switch (section.formulation) {
      case Formulation::t4:
      case Formulation::t4anp: visit_section<T4>(model, section, T4::make, visit); break;
      case Formulation::h8: visit_section<H8>(model, section, H8::make, visit); break;
      case Formulation::h8_fixed: visit_section<H8>(model, section, H8::make_fixed, visit); break;
      case Formulation::h8_full: visit_section<H8Full>(model, section, H8Full::make, visit); break;
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
