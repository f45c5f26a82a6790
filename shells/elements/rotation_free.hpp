// Thin shell triangle without rotations: EBST1 of Flores & Onate 2005.
#pragma once

#include <glisson/shells/elements/surface_gradient.hpp>

namespace glisson::shells {

/// What lies across a side of the triangle.
enum class Across {
  nothing,    ///< free or simply supported: the gradient there is that of the triangle
  neighbour,  ///< the fourth node of the side
  mirror,     ///< clamped or symmetry: the mirror image of the triangle's own opposite node
};

/// Moments or changes of curvature: 11, 22 and, for curvature, 2 x 12.
template <class R>
struct Bending {
  R xx{}, yy{}, xy{};
};

/// Nodes 0 1 2 are the triangle's, node 3 + s is the neighbour across side s, which is opposite to node s.
/// Over the patch of four triangles the position is quadratic; its gradient is taken at the middle of the
/// sides, where only four nodes count. The membrane strain is the mean over the sides (EBST1), the curvature
/// follows from the gradients by the divergence theorem, kappa_ab = -sum 2 L_s,a (n . phi_b at side s). The
/// curvature at rest is subtracted: it is free of stress. Good for shells that are thin against their radius
/// and the side lengths; no transverse shear.
struct RotationFree {
  static constexpr int node_count = 6;

  template <class R>
  struct Side {
    SurfacePoint<R, 4> point;  ///< nodes: s, s + 1, s + 2, across
    R dL[2];                   ///< gradient of the area coordinate of node s [1/m]
    Vec3<R> mirror;            ///< unit normal of the mirror plane, or zero
  };
  template <class R>
  struct Constants {
    Side<R> side[3];
    Vec3<R> a, b;    ///< rest edges 0-1 and 0-2 [m]
    Vec3<R> normal;  ///< at rest [-]
    Vec3<R> h0[3];   ///< sums whose product with the normal is the rest curvature: 11, 22, 2 x 12 [1/m]
    R double_area;   ///< at rest [m^2]
    R volume;        ///< [m^3]
    R bending, nu;   ///< area times E h^3 / (12 (1 - nu^2)) [N m^3]; [-]
  };

  /// Displacements of the four nodes of side s. A mirror image moves as u_e + M (u_s - u_e), M = I - 2 m m^T,
  /// with u_e of the middle of the side.
  template <class R>
  GLISSON_HD static void at_side(const Constants<R>& c, const Vec3<R> (&u)[6], int s, Vec3<R> (&v)[4]) {
    const int j = (s + 1) % 3, k = (s + 2) % 3;
    const Vec3<R>& m = c.side[s].mirror;
    v[0] = u[s], v[1] = u[j], v[2] = u[k];
    const Vec3<R> away = R(0.5) * ((u[s] - u[j]) + (u[s] - u[k]));
    v[3] = u[3 + s] - (R(2) * dot(m, away)) * m;
  }
  /// The transpose: force on the image to the nodes that it follows.
  template <class R>
  GLISSON_HD static void from_side(const Constants<R>& c, const Vec3<R> (&g)[4], int s, Vec3<R> (&f)[6]) {
    const int j = (s + 1) % 3, k = (s + 2) % 3;
    const Vec3<R>& m = c.side[s].mirror;
    const Vec3<R> pull = (R(2) * dot(m, g[3])) * m;
    f[s] = f[s] + g[0] - pull;
    f[j] = f[j] + g[1] + R(0.5) * pull;
    f[k] = f[k] + g[2] + R(0.5) * pull;
    f[3 + s] = f[3 + s] + g[3];
  }

  template <class R>
  struct State {
    SurfaceGradient<R> gradient[3];
    Plane<R> c;      ///< mean of the sides
    Vec3<R> h[3];    ///< as h0, now
    Vec3<R> n;       ///< current normal
    Vec3<R> a, b;    ///< current edges
    R double_area;   ///< current
    Bending<R> chi;  ///< change of curvature [1/m]
  };

  template <class R>
  GLISSON_HD static State<R> state(const Constants<R>& c, const Vec3<R> (&u)[6]) {
    State<R> q;
    Vec3<R> dh[3];
    for (int s = 0; s < 3; ++s) {
      Vec3<R> v[4];
      at_side(c, u, s, v);
      q.gradient[s] = surface_gradient(c.side[s].point, v);
      const Plane<R> e = strain(c.side[s].point.t, q.gradient[s]);
      const R third = R(1.0 / 3);
      q.c = {q.c.xx + third * e.xx, q.c.yy + third * e.yy, q.c.xy + third * e.xy};
      const R x = R(-2) * c.side[s].dL[0], y = R(-2) * c.side[s].dL[1];
      const auto& h = q.gradient[s].h;
      dh[0] = dh[0] + x * h[0];
      dh[1] = dh[1] + y * h[1];
      dh[2] = dh[2] + y * h[0] + x * h[1];
    }
    const Vec3<R> da = u[1] - u[0], db = u[2] - u[0];
    q.a = c.a + da, q.b = c.b + db;
    const Vec3<R> N = cross(q.a, q.b), dN = cross(c.a, db) + cross(da, q.b);
    q.double_area = square_root(dot(N, N));
    q.n = (R(1) / q.double_area) * N;
    // |N| - |N0| and n - n0 without subtracting nearly equal numbers
    const R growth = dot(dN, c.double_area * c.normal + N) / (q.double_area + c.double_area);
    const Vec3<R> dn = (R(1) / q.double_area) * (dN - growth * c.normal);
    for (int k = 0; k < 3; ++k) q.h[k] = c.h0[k] + dh[k];
    q.chi = {dot(q.n, dh[0]) + dot(dn, c.h0[0]), dot(q.n, dh[1]) + dot(dn, c.h0[1]),
             dot(q.n, dh[2]) + dot(dn, c.h0[2])};
    return q;
  }

  template <class R>
  GLISSON_HD static Bending<R> moments(const R& stiffness, const R& nu, const Bending<R>& chi) {
    return {stiffness * (chi.xx + nu * chi.yy), stiffness * (chi.yy + nu * chi.xx),
            stiffness * R(0.5) * (R(1) - nu) * chi.xy};
  }
  template <class R>
  GLISSON_HD static Plane<R> plane_strain(const Constants<R>& c, const Vec3<R> (&u)[6]) {
    return state(c, u).c;
  }
  template <class R>
  GLISSON_HD static R bending_energy(const Constants<R>& c, const Vec3<R> (&u)[6]) {
    const Bending<R> chi = state(c, u).chi, M = moments(c.bending, c.nu, chi);
    return R(0.5) * (M.xx * chi.xx + M.yy * chi.yy + M.xy * chi.xy);
  }

  /// f <- forces of given stress S [Pa] and of moments M that are integrated over the area [N m^2].
  template <class R>
  GLISSON_HD static void forces_of(const Constants<R>& c, const State<R>& q, const Plane<R>& S,
                                   const Bending<R>& M, Vec3<R> (&f)[6]) {
    for (int a = 0; a < 6; ++a) f[a] = {};
    for (int s = 0; s < 3; ++s) {
      const Side<R>& side = c.side[s];
      Vec3<R> g[4];
      subtract_stress(side.point, q.gradient[s], S, c.volume * R(1.0 / 3), g);
      const R x = R(-2) * (M.xx * side.dL[0] + M.xy * side.dL[1]),
              y = R(-2) * (M.yy * side.dL[1] + M.xy * side.dL[0]);
      for (int a = 0; a < 4; ++a) g[a] = g[a] - (x * side.point.dN[a][0] + y * side.point.dN[a][1]) * q.n;
      from_side(c, g, s, f);
    }
    const Vec3<R> H = M.xx * q.h[0] + M.yy * q.h[1] + M.xy * q.h[2];
    const Vec3<R> P = (R(1) / q.double_area) * (H - dot(q.n, H) * q.n);  // M : h . dn = P . dN
    const Vec3<R> on_1 = cross(q.b, P), on_2 = cross(P, q.a);
    f[1] = f[1] - on_1;
    f[2] = f[2] - on_2;
    f[0] = f[0] + on_1 + on_2;
  }
  template <class R, class Stress>
  GLISSON_HD static void forces(const Constants<R>& c, const Vec3<R> (&u)[6], const Stress& stress,
                                Vec3<R> (&f)[6]) {
    const State<R> q = state(c, u);
    forces_of(c, q, stress(q.c), moments(c.bending, c.nu, q.chi), f);
  }

  /// X: rest positions, mirror images and missing neighbours included; mirror: normal of the plane of each
  /// side that has one; bending: E h^3 / (12 (1 - nu^2)) [N m].
  static Constants<double> make(const Vec3<double> (&X)[6], const Across (&across)[3],
                                const Vec3<double> (&mirror)[3], const Vec3<double>& along, double thickness,
                                double bending, double nu) {
    Constants<double> c{};
    constexpr double own[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    c.a = X[1] - X[0], c.b = X[2] - X[0];
    const auto N = cross(c.a, c.b);
    c.double_area = ::sqrt(dot(N, N));
    c.normal = unit(N);
    c.volume = 0.5 * c.double_area * thickness;
    c.bending = 0.5 * c.double_area * bending;
    c.nu = nu;
    const auto flat = surface_point<3>(c.a, c.b, own, along);
    for (int s = 0; s < 3; ++s) {
      Side<double>& side = c.side[s];
      const int j = (s + 1) % 3, k = (s + 2) % 3;
      // derivatives by the area coordinates of j and k at the middle of their side
      constexpr double quadratic[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}};
      constexpr double linear[4][2] = {{-1, -1}, {1, 0}, {0, 1}, {0, 0}};
      if (across[s] == Across::nothing)
        side.point = surface_point<4>(X[j] - X[s], X[k] - X[s], linear, along);
      else
        side.point = surface_point<4>(0.5 * (X[3 + s] - X[s] + X[j] - X[k]),
                                      0.5 * (X[3 + s] - X[s] + X[k] - X[j]), quadratic, along);
      if (across[s] == Across::mirror) side.mirror = mirror[s];
      for (int l = 0; l < 2; ++l) side.dL[l] = flat.dN[s][l];
      const double x = -2 * side.dL[0], y = -2 * side.dL[1];
      c.h0[0] = c.h0[0] + x * side.point.t[0];
      c.h0[1] = c.h0[1] + y * side.point.t[1];
      c.h0[2] = c.h0[2] + y * side.point.t[0] + x * side.point.t[1];
    }
    return c;
  }
};

}  // namespace glisson::shells
