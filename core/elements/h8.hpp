// One-point hexahedron with stiffness hourglass control.
#pragma once

#include <glisson/core/elements/hexahedron.hpp>

namespace glisson {

/// Uniform gradient and hourglass stiffness (Flanagan & Belytschko 1981; Joldes et al. 2008). Everything is
/// written in the 7 modes of the hexahedron that are not translations: 3 linear ones Lambda_i = (xi_a, eta_a,
/// zeta_a) and 4 hourglass ones h_m, which a Walsh-Hadamard transform finds with additions only.
///   gradient vectors   B_j = sum_i Lambda_i beta_ij + sum_m h_m eta_mj,   H = sum_a u_a B_a
///   hourglass vectors  gamma_m = h_m - sum_j chi_mj B_j with chi_mj = h_m . X_j,   q_m = gamma_m . u
///   forces             f_a = -V P B_a - k sum_m gamma_ma q_m
/// gamma is orthogonal to every linear field, so q vanishes for x = R X + t and turns with the element
/// otherwise: the energy k |q|^2 / 2 does not see rotations, although k and gamma are those of the rest
/// state. Formulation h8 takes the mean gradient and the exact volume: it passes the patch test on any
/// hexahedron. h8_fixed takes the gradient at the centre and 8 det J (eta = 0), as NiftySim does; both are
/// the same for parallelepipeds. The exact volume is a polynomial in the modes of X without that of xi eta
/// zeta (every product with it integrates to zero or has two equal factors), and B is its derivative: eta_3 =
/// 0 for both gradients.
struct H8 {
  static constexpr int node_count = 8;
  static constexpr int point_count = 1;
  static constexpr int constant_count = 32;

  template <class R>
  struct Constants {
    R beta[3][3];  ///< [1/m]
    R eta[3][3];   ///< [1/m]; eta_3 = 0
    R chi[4][3];   ///< [m]
    R volume;      ///< [m^3]
    R hourglass;   ///< k [N/m]
  };

  template <class R>
  GLISSON_HD static Mat3<R> gradient_of_modes(const Constants<R>& c, const Vec3<R> (&d)[3],
                                              const Vec3<R> (&h)[4]) {
    Mat3<R> H;
    for (int j = 0; j < 3; ++j) {
      auto column = [&](auto get) {
        R sum = get(d[0]) * c.beta[0][j] + get(d[1]) * c.beta[1][j] + get(d[2]) * c.beta[2][j];
        for (int m = 0; m < 3; ++m) sum = sum + get(h[m]) * c.eta[m][j];
        return sum;
      };
      H.m[0][j] = column([](const Vec3<R>& a) { return a.x; });
      H.m[1][j] = column([](const Vec3<R>& a) { return a.y; });
      H.m[2][j] = column([](const Vec3<R>& a) { return a.z; });
    }
    return H;
  }

  /// q_m = h_m.u - sum_j chi_mj H_.j
  template <class R>
  GLISSON_HD static Vec3<R> hourglass_mode(const Constants<R>& c, const Mat3<R>& H, const Vec3<R>& h, int m) {
    auto reduced = [&](const R& value, int i) {
      return value - (H.m[i][0] * c.chi[m][0] + H.m[i][1] * c.chi[m][1] + H.m[i][2] * c.chi[m][2]);
    };
    return {reduced(h.x, 0), reduced(h.y, 1), reduced(h.z, 2)};
  }

  template <class R, class Stress>
  GLISSON_HD static void forces(const Constants<R>& c, const Vec3<R> (&u)[8], const Stress& stress,
                                Vec3<R> (&f)[8]) {
    Vec3<R> d[3], h[4];
    hexahedron_modes(u, d, h);
    mode_forces(c, stress, d, h);
    hexahedron_nodes(d, h, f);
  }

  /// The same between modes: d, h of the displacement become those of the forces. The hourglass part does not
  /// wait for the stress.
  template <class R, class Stress>
  GLISSON_HD static void mode_forces(const Constants<R>& c, const Stress& stress, Vec3<R> (&d)[3],
                                     Vec3<R> (&h)[4]) {
    const Mat3<R> H = gradient_of_modes(c, d, h);
    Mat3<R> T{};  // k sum_m q_m chi_m - V P
    for (int m = 0; m < 4; ++m) {
      const Vec3<R> q = c.hourglass * hourglass_mode(c, H, h[m], m);
      for (int j = 0; j < 3; ++j) {
        T.m[0][j] = T.m[0][j] + q.x * c.chi[m][j];
        T.m[1][j] = T.m[1][j] + q.y * c.chi[m][j];
        T.m[2][j] = T.m[2][j] + q.z * c.chi[m][j];
      }
      h[m] = R(-1) * q;
    }
    const Mat3<R> P = stress(H, 0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) T.m[i][j] = T.m[i][j] - c.volume * P.m[i][j];
    auto along = [&](const R(&w)[3]) {
      auto row = [&](int i) { return T.m[i][0] * w[0] + T.m[i][1] * w[1] + T.m[i][2] * w[2]; };
      return Vec3<R>{row(0), row(1), row(2)};
    };
    for (int i = 0; i < 3; ++i) d[i] = along(c.beta[i]);
    for (int m = 0; m < 3; ++m) h[m] = h[m] + along(c.eta[m]);
  }

  template <class R, class Visit>
  GLISSON_HD static void points(const Constants<R>& c, const Vec3<R> (&u)[8], const Visit& visit) {
    Vec3<R> d[3], h[4];
    hexahedron_modes(u, d, h);
    visit(gradient_of_modes(c, d, h), c.volume, 0);
  }

  template <class R>
  GLISSON_HD static R hourglass_energy(const Constants<R>& c, const Vec3<R> (&u)[8]) {
    Vec3<R> d[3], h[4];
    hexahedron_modes(u, d, h);
    const Mat3<R> H = gradient_of_modes(c, d, h);
    R sum = R(0);
    for (int m = 0; m < 4; ++m) {
      const Vec3<R> q = hourglass_mode(c, H, h[m], m);
      sum = sum + dot(q, q);
    }
    return R(0.5) * c.hourglass * sum;
  }

  /// From rest positions. stiffness: coefficient times (lambda + 2 mu) [Pa]; k = stiffness V sum_a |B_a|^2 /
  /// 8 (Flanagan & Belytschko 1981) with the exact volume V, as NiftySim has it in h8_fixed, too. With the
  /// modes d, h of X, 64 V = d1.(d2 x d3) + (d1.(h3 x h2) + d2.(h1 x h3) + d3.(h2 x h1)) / 3: what is left of
  /// the integral of det J, whose odd terms vanish. beta and eta are its derivatives over 64 V.
  template <class R>
  GLISSON_HD static Constants<R> rest_constants(const Vec3<R> (&X)[8], R stiffness, bool at_centre) {
    Vec3<R> d[3], h[4], beta[3], eta[3];
    hexahedron_modes(X, d, h);
    const R third = R(1.0 / 3);
    const Vec3<R> centre[3] = {cross(d[1], d[2]), cross(d[2], d[0]), cross(d[0], d[1])};
    const Vec3<R> warp[3] = {third * cross(h[2], h[1]), third * cross(h[0], h[2]), third * cross(h[1], h[0])};
    const R straight = dot(d[0], centre[0]);
    const R whole = straight + dot(d[0], warp[0]) + dot(d[1], warp[1]) + dot(d[2], warp[2]);
    const R volume64 = at_centre ? straight : whole, inverse = R(1) / volume64;
    const R mean = at_centre ? R(0) : inverse;
    eta[0] = (third * mean) * (cross(h[2], d[1]) + cross(d[2], h[1]));
    eta[1] = (third * mean) * (cross(d[0], h[2]) + cross(h[0], d[2]));
    eta[2] = (third * mean) * (cross(h[1], d[0]) + cross(d[1], h[0]));
    R squares = R(0);
    Constants<R> c;
    for (int i = 0; i < 3; ++i) {
      beta[i] = inverse * centre[i] + mean * warp[i];
      squares = squares + dot(beta[i], beta[i]) + dot(eta[i], eta[i]);
      put(c.beta[i], beta[i]), put(c.eta[i], eta[i]);
    }
    for (int m = 0; m < 4; ++m) put(c.chi[m], h[m]);
    c.volume = R(1.0 / 64) * volume64;
    c.hourglass = stiffness * (R(1.0 / 64) * whole) * squares;
    return c;
  }
  static Constants<double> make(const Vec3<double> (&X)[8], double stiffness) {
    return rest_constants(X, stiffness, false);
  }
  /// With the gradient of the centre and 8 det J.
  static Constants<double> make_fixed(const Vec3<double> (&X)[8], double stiffness) {
    return rest_constants(X, stiffness, true);
  }

 private:
  template <class R>
  GLISSON_HD static void put(R (&to)[3], const Vec3<R>& a) {
    to[0] = a.x, to[1] = a.y, to[2] = a.z;
  }
};

}  // namespace glisson
