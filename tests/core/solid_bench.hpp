// A bench for solid elements: forces and energies of a model for a displacement in the user's numbering,
// without a time loop.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <glisson/core/solids/plain_solids.hpp>
#include <glisson/cpu/serial.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {

using Field = std::vector<Vec3<double>>;

constexpr Formulation all_formulations[] = {Formulation::t4, Formulation::t4anp, Formulation::h8,
                                            Formulation::h8_fixed, Formulation::h8_full};

template <class R, class B = Serial>
class SolidBench {
 public:
  explicit SolidBench(const Model& model)
      : numbering_(make_numbering(model.mesh)),
        nodes_(model.mesh.X.size()),
        solids_(make_plain_solids<B, R>(backend_, model, numbering_)),
        u_(backend_.template allocate<Vec4<R>>(nodes_)),
        f_(backend_.template allocate<Vec4<R>>(nodes_)) {}

  Field forces(const Field& u, double dt = 1, bool advance = false) {
    const StepView<R> step = view(u, dt, advance);
    solids_->add_forces(step);
    std::vector<Vec4<R>> host(nodes_);
    backend_.copy_out(f_.get(), host.data(), nodes_);
    Field f(nodes_);
    for (std::size_t n = 0; n < nodes_; ++n) {
      const auto& g = host[internal(n)];
      f[n] = {double(g.x), double(g.y), double(g.z)};
    }
    return f;
  }
  double strain_energy(const Field& u) { return solids_->strain_energy(view(u, 1, false)).read(); }
  double hourglass_energy(const Field& u) { return solids_->hourglass_energy(view(u, 1, false)).read(); }
  double energy(const Field& u) { return strain_energy(u) + hourglass_energy(u); }
  SolidForces<R>& solids() { return *solids_; }
  static constexpr double epsilon() { return double(std::numeric_limits<R>::epsilon()); }

 private:
  std::size_t internal(std::size_t n) const { return std::size_t(numbering_.internal_of_user[n]); }
  StepView<R> view(const Field& u, double dt, bool advance) {
    std::vector<Vec4<R>> host(nodes_), zero(nodes_);
    for (std::size_t n = 0; n < nodes_; ++n) host[internal(n)] = {R(u[n].x), R(u[n].y), R(u[n].z), R(0)};
    backend_.copy_in(host.data(), u_.get(), nodes_);
    backend_.copy_in(zero.data(), f_.get(), nodes_);
    StepView<R> step;
    step.u = u_.get();
    step.f = f_.get();
    step.node_count = int(nodes_);
    step.dt = dt;
    step.advance = advance;
    return step;
  }

  B backend_;
  Numbering numbering_;
  std::size_t nodes_;
  std::unique_ptr<SolidForces<R>> solids_;
  Buffer<Vec4<R>> u_, f_;
};

/// u = H X + shift
inline Field affine(const Mesh& mesh, const Mat3<double>& H, Vec3<double> shift = {}) {
  Field u;
  for (const auto& X : mesh.X) {
    auto row = [&](int i) { return H.m[i][0] * X.x + H.m[i][1] * X.y + H.m[i][2] * X.z; };
    u.push_back(Vec3<double>{row(0), row(1), row(2)} + shift);
  }
  return u;
}

/// Rotation by an angle [rad] about (1, 2, 3): Rodrigues.
inline Mat3<double> rotation(double angle) {
  const double n = std::sqrt(14.0), a[3] = {1 / n, 2 / n, 3 / n}, c = std::cos(angle), s = std::sin(angle);
  return {{{c + a[0] * a[0] * (1 - c), a[0] * a[1] * (1 - c) - a[2] * s, a[0] * a[2] * (1 - c) + a[1] * s},
           {a[1] * a[0] * (1 - c) + a[2] * s, c + a[1] * a[1] * (1 - c), a[1] * a[2] * (1 - c) - a[0] * s},
           {a[2] * a[0] * (1 - c) - a[1] * s, a[2] * a[1] * (1 - c) + a[0] * s, c + a[2] * a[2] * (1 - c)}}};
}
inline Vec3<double> apply(const Mat3<double>& A, const Vec3<double>& x) {
  return {A.m[0][0] * x.x + A.m[0][1] * x.y + A.m[0][2] * x.z,
          A.m[1][0] * x.x + A.m[1][1] * x.y + A.m[1][2] * x.z,
          A.m[2][0] * x.x + A.m[2][1] * x.y + A.m[2][2] * x.z};
}

/// Displacement of the state X + u turned by Q and shifted.
inline Field turned(const Mesh& mesh, const Field& u, const Mat3<double>& Q, Vec3<double> shift = {}) {
  Field result(u.size());
  for (std::size_t n = 0; n < u.size(); ++n) result[n] = apply(Q, mesh.X[n] + u[n]) + shift - mesh.X[n];
  return result;
}

inline Field random_field(std::size_t count, double amplitude, unsigned seed = 5) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-amplitude, amplitude);
  Field u(count);
  for (auto& a : u) a = {value(random), value(random), value(random)};
  return u;
}

inline double length(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }
inline double largest(const Field& f) {
  double most = 0;
  for (const auto& a : f) most = std::max(most, length(a));
  return most;
}
inline double largest_difference(const Field& f, const Field& g) {
  double most = 0;
  for (std::size_t n = 0; n < f.size(); ++n) most = std::max(most, length(f[n] - g[n]));
  return most;
}

constexpr double mu = 1000, kappa = 5000;  ///< of the bench's material [Pa]

/// The unit cube in 3 x 3 x 3 bricks of a compressible neo-Hookean solid.
inline Model cube(Formulation formulation, double jitter = 0.15) {
  return box_model({3, 3, 3}, {1, 1, 1}, formulation, {"NH", {mu, kappa}}, jitter);
}

template <class R>
class InBothPrecisions : public testing::Test {};
using Precisions = testing::Types<float, double>;

}  // namespace glisson::test
