// Forces against energies, hourglass control, and the averaged pressure against its definition.
#include <glisson/core/elements/t4.hpp>

#include "solid_bench.hpp"

namespace glisson::test {
namespace {

/// Largest difference between the force and the central difference of the energy, over the largest force.
double mismatch(const Model& model, const Field& u, double step) {
  SolidBench<double> bench(model);
  const Field f = bench.forces(u);
  Field numeric(u.size());
  for (std::size_t n = 0; n < u.size(); ++n) {
    auto slope = [&](double Vec3<double>::*axis) {
      Field plus = u, minus = u;
      plus[n].*axis += step;
      minus[n].*axis -= step;
      return -(bench.energy(plus) - bench.energy(minus)) / (2 * step);
    };
    numeric[n] = {slope(&Vec3<double>::x), slope(&Vec3<double>::y), slope(&Vec3<double>::z)};
  }
  return largest_difference(f, numeric) / largest(f);
}

Model small(Formulation formulation, const Material& material = {"NH", {mu, kappa}}) {
  Model model = box_model({2, 2, 2}, {1, 1, 1}, formulation, material, 0.15);
  model.sections[0].hourglass = 0.1;
  return model;
}

TEST(ElementEnergy, IsWhatForcesDerive) {
  for (const Formulation formulation :
       {Formulation::t4, Formulation::h8, Formulation::h8_fixed, Formulation::h8_full})
    for (const Material& material :
         {Material{"NH", {mu, kappa}}, Material{"TI", {mu, kappa, 3000, 1, 1, 0}}}) {
      const Model model = small(formulation, material);
      // Strain about 0.2: the difference formula is off by step^2 W''' / f ~ 1e-10, its rounding by 1e-16 W /
      // (step f) ~ 1e-10.
      EXPECT_LT(mismatch(model, random_field(model.mesh.X.size(), 0.05), 1e-5), 1e-7)
          << name_of(formulation) << material.law;
    }
}

/// T4ANP takes the gradients of F for a stress of Fbar: the mismatch is of first order in the strain.
TEST(ElementEnergy, OfAveragedPressureIsWhatForcesDeriveToFirstOrder) {
  const Model model = small(Formulation::t4anp);
  double before = 0;
  for (const double amplitude : {0.02, 0.002, 0.0002}) {
    const double m = mismatch(model, random_field(model.mesh.X.size(), amplitude), amplitude * 1e-4);
    EXPECT_LT(m, 10 * amplitude);
    if (before > 0) {
      EXPECT_NEAR(m / before, 0.1, 0.03);
    }
    before = m;
  }
}

TEST(ElementEnergy, OfHourglassModesIsThatOfTheirSprings) {
  constexpr double coefficient = 0.1;
  for (const Formulation formulation : {Formulation::h8, Formulation::h8_fixed}) {
    Model model = box_model({1, 1, 1}, {1, 1, 1}, formulation, {"NH", {mu, kappa}});
    model.sections[0].hourglass = coefficient;
    SolidBench<double> bench(model);
    for (int m = 0; m < 4; ++m) {
      Field u(8);
      for (std::size_t n = 0; n < 8; ++n) {
        const auto& X = model.mesh.X[n];
        const double r = 2 * X.x - 1, s = 2 * X.y - 1, t = 2 * X.z - 1,
                     modes[] = {r * s, s * t, r * t, r * s * t};
        u[n].x = 0.01 * modes[m];
      }
      // |dN|^2 = 3/16 at each of 8 nodes, gamma = the mode: k = coefficient M (1 m^3) (8 x 3/16) / 8, |q| = 8
      // x 0.01.
      const double modulus = formulation == Formulation::h8_fixed ? kappa + 4.0 / 3 * mu : 4 * mu;
      const double expected = 0.5 * coefficient * modulus * 1.5 / 8 * 0.08 * 0.08;
      EXPECT_NEAR(bench.hourglass_energy(u), expected, 1e-12 * expected);
      EXPECT_NEAR(bench.strain_energy(u), 0, 1e-12 * expected);
      const Field f = bench.forces(u);
      double work = 0;
      for (std::size_t n = 0; n < 8; ++n) work += dot(f[n], u[n]);
      EXPECT_NEAR(work, -2 * expected, 1e-12 * expected);
    }
  }
}

TEST(ElementEnergy, OfFullIntegrationSeesEveryMode) {
  const Model model = box_model({1, 1, 1}, {1, 1, 1}, Formulation::h8_full, {"NH", {mu, kappa}});
  SolidBench<double> bench(model);
  for (unsigned seed = 1; seed < 9; ++seed) EXPECT_GT(bench.strain_energy(random_field(8, 0.01, seed)), 1e-3);
}

TEST(AveragedPressure, IsThatOfTheElementWhereVolumeChangesEvenly) {
  const Mat3<double> H{{{0.2, 0.1, 0}, {0, -0.1, 0.3}, {0.1, 0, 0.05}}};
  const Model plain = cube(Formulation::t4), averaged = cube(Formulation::t4anp);
  SolidBench<double> a(plain), b(averaged);
  const Field u = affine(plain.mesh, H), f = a.forces(u);
  EXPECT_LT(largest_difference(f, b.forces(u)), 1e-13 * largest(f) * 100);
  EXPECT_NEAR(a.strain_energy(u), b.strain_energy(u), 1e-12 * a.strain_energy(u));
}

Model two_halves(double first_kappa, double second_kappa) {
  Model model = cube(Formulation::t4anp);
  model.sections.push_back(model.sections[0]);
  for (auto& section : model.sections) section.elements.clear();
  for (int e = 0; e < model.mesh.element_count(); ++e)
    model.sections[std::size_t(e % 2)].elements.push_back(e);
  model.sections[0].material.parameters[1] = first_kappa;
  model.sections[1].material.parameters[1] = second_kappa;
  return model;
}

TEST(AveragedPressure, CrossesSections) {
  const Model whole = cube(Formulation::t4anp);
  const Field u = random_field(whole.mesh.X.size(), 0.03);
  Model halves = two_halves(kappa, kappa);
  halves.sections[1].material.isochoric = {{1e-30, 1}};  // another block with the same stress
  const Field f = SolidBench<double>(whole).forces(u);
  EXPECT_LT(largest_difference(f, SolidBench<double>(halves).forces(u)), 1e-12 * largest(f));
}

/// T4ANP written down from Joldes et al. 2009 with F and powers, for comparison.
Field textbook_forces(const Model& model, const Field& u) {
  const Mesh& mesh = model.mesh;
  Field f(u.size());
  std::vector<double> P(u.size()), V(u.size());
  for (int sweep = 0; sweep < 2; ++sweep)
    for (const Section& section : model.sections)
      for (const int e : section.elements) {
        const auto nodes = mesh.element(e);
        Vec3<double> X[4];
        for (std::size_t a = 0; a < 4; ++a) X[a] = mesh.X[std::size_t(nodes[a])];
        const auto c = T4::make(X);
        Mat3<double> F{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        for (int b = 0; b < 3; ++b)
          for (int K = 0; K < 3; ++K) {
            const Vec3<double> d = u[std::size_t(nodes[std::size_t(b + 1)])] - u[std::size_t(nodes[0])];
            F.m[0][K] += d.x * c.B[b][K], F.m[1][K] += d.y * c.B[b][K], F.m[2][K] += d.z * c.B[b][K];
          }
        const double J = determinant(F), k = section.material.parameters[1];
        if (sweep == 0) {
          for (const int n : nodes)
            P[std::size_t(n)] += k * (J - 1) * c.volume, V[std::size_t(n)] += c.volume / 4;
          continue;
        }
        double mean = 0;
        for (const int n : nodes) mean += P[std::size_t(n)] / V[std::size_t(n)] / 16;
        const double Jm = mean / k + 1, scale = std::pow(Jm / J, 1.0 / 3);
        for (auto& row : F.m)
          for (double& value : row) value *= scale;
        // P = mu Jm^(-2/3) (F - tr C/3 F^-T) + kappa (Jm - 1) cof F
        const Mat3<double> cof = cofactor(F);
        double C = 0;
        for (const auto& row : F.m)
          for (const double value : row) C += value * value;
        Mat3<double> S{};
        for (int i = 0; i < 3; ++i)
          for (int K = 0; K < 3; ++K)
            S.m[i][K] = mu * std::pow(Jm, -2.0 / 3) * (F.m[i][K] - C / 3 * cof.m[i][K] / Jm) +
                        k * (Jm - 1) * cof.m[i][K];
        Vec3<double> own[4];
        T4::nodal_forces(c, S, own);
        for (std::size_t a = 0; a < 4; ++a) f[std::size_t(nodes[a])] = f[std::size_t(nodes[a])] + own[a];
      }
  return f;
}

TEST(AveragedPressure, FollowsItsDefinitionWithTwoBulkModuli) {
  const Model model = two_halves(kappa, 10 * kappa);
  const Field u = random_field(model.mesh.X.size(), 0.03), expected = textbook_forces(model, u);
  EXPECT_LT(largest_difference(SolidBench<double>(model).forces(u), expected), 1e-12 * largest(expected));
  EXPECT_LT(largest_difference(SolidBench<float>(model).forces(u), expected), 1e-5 * largest(expected));
}

}  // namespace
}  // namespace glisson::test
