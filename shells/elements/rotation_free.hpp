// Thin shell triangle without rotations: EBST1 of Flores & Onate 2005.
#pragma once

#include <glisson/shells/elements/surface_gradient.hpp>

namespace glisson::shells {

/// What lies across a side of the triangle.
enum class Across {
  nothing,    ///< free or simply supported: the triangle turned about the middle of the side, so that the
              ///< gradient there is that of the triangle
  neighbour,  ///< the fourth node of the side
  mirror,     ///< clamped or symmetry: the mirror image of the triangle's own opposite node
};

/// Moments or changes of curvature: 11, 22 and, for curvature, 2 x 12.
template <class R>
struct Bending {
  R xx{}, yy{}, xy{};
};

/// Constants of a triangle with three neighbours.
template <class R>
struct ShellPatch {
  Vec3<R> a, b;           ///< rest edges 0-1 and 0-2 [m]
  Vec3<R> across[3];      ///< at rest, from node s to the node across side s [m]
  R g[3][2][2];           ///< at the middle of side s, differences: this one and the side [1/m]
  R dL[2][2];             ///< gradients of the area coordinates of nodes 1 and 2 [1/m]
  R inverse_double_area;  ///< at rest [1/m^2]
  R volume;               ///< at rest [m^3]
  R bending, nu;          ///< area times E h^3 / (12 (1 - nu^2)) [N m^3]; [-]
};

/// How the image across a side without a neighbour follows the triangle; all zero where there is a neighbour.
template <class R>
struct SideImage {
  Vec3<R> mirror;  ///< unit normal of the mirror plane [-]
  R turned;        ///< 1: the image of a free side [-]
};

/// Nodes 0 1 2 are the triangle's, node 3 + s is the neighbour across side s, which is opposite to node s.
/// Over the patch of four triangles the position is quadratic; its gradient is taken at the middle of the
/// sides, where only four nodes count: it is linear in two differences, across the side and along it. The
/// membrane strain is the mean over the sides (EBST1), the curvature follows from the gradients by the
/// divergence theorem, kappa_ab = -sum 2 L_s,a (n . phi_b at side s). The curvature at rest is subtracted: it
/// is free of stress. Good for shells that are thin against their radius and the side lengths; no transverse
/// shear.
struct RotationFree {
  static constexpr int node_count = 6;

  template <class R>
  struct Constants : ShellPatch<R> {
    SideImage<R> image[3];
  };

  /// u of the node across side s less u of node s. An image moves as u_e + M (u_s - u_e), with u_e of the
  /// middle of the side; M = I - 2 m m^T for a mirror, -I for a turn.
  template <class R, class C>
  GLISSON_HD_INLINE static Vec3<R> across(const C& c, const Vec3<R> (&u)[6], int s) {
    Vec3<R> d = u[3 + s] - u[s];
    if constexpr (requires { c.image; }) {
      const Vec3<R>& m = c.image[s].mirror;
      const Vec3<R> away = (u[s] - u[(s + 1) % 3]) + (u[s] - u[(s + 2) % 3]);  // twice u_s - u_e
      d = d - dot(m, away) * m - c.image[s].turned * away;
    }
    return d;
  }
  /// The transpose: what works on the difference to forces on the nodes.
  template <class R, class C>
  GLISSON_HD_INLINE static void subtract_across(const C& c, const Vec3<R>& on_d, int s, Vec3<R> (&f)[6]) {
    f[3 + s] = f[3 + s] - on_d;
    f[s] = f[s] + on_d;
    if constexpr (requires { c.image; }) {
      const int j = (s + 1) % 3, k = (s + 2) % 3;
      const Vec3<R>& m = c.image[s].mirror;
      const Vec3<R> pull = dot(m, on_d) * m + c.image[s].turned * on_d;
      f[s] = f[s] + R(2) * pull;
      f[j] = f[j] - pull;
      f[k] = f[k] - pull;
    }
  }
  /// -2 L_s,a: what the gradient at side s counts in the curvature.
  template <class R>
  GLISSON_HD_INLINE static void weight_of_side(const ShellPatch<R>& c, int s, R& x, R& y) {
    x = s == 0 ? R(2) * (c.dL[0][0] + c.dL[1][0]) : R(-2) * c.dL[s - 1][0];
    y = s == 0 ? R(2) * (c.dL[0][1] + c.dL[1][1]) : R(-2) * c.dL[s - 1][1];
  }

  template <class R>
  struct State {
    Vec3<R> F[3][2];        ///< dx/ds at the sides
    Plane<R> c;             ///< mean of the sides
    Vec3<R> h[3];           ///< sums whose product with the normal is the curvature: 11, 22, 2 x 12 [1/m]
    Vec3<R> n;              ///< current normal
    Vec3<R> a, b;           ///< current edges
    R inverse_double_area;  ///< current
    Bending<R> chi;         ///< change of curvature [1/m]
  };

  template <class R, class C>
  GLISSON_HD_INLINE static State<R> state(const C& c, const Vec3<R> (&u)[6]) {
    State<R> q;
    const Vec3<R> da = u[1] - u[0], db = u[2] - u[0];
    const Vec3<R> X_side[3] = {c.b - c.a, R(-1) * c.b, c.a}, u_side[3] = {db - da, R(-1) * db, da};
    Vec3<R> h0[3], dh[3];
    GLISSON_UNROLL
    for (int s = 0; s < 3; ++s) {
      const SurfaceGradient<R> rest = surface_gradient(c.g[s], c.across[s], X_side[s]),
                               change = surface_gradient(c.g[s], across(c, u, s), u_side[s]);
      const Plane<R> e = strain(rest.h, change);
      const R third = R(1.0 / 3);
      q.c = {q.c.xx + third * e.xx, q.c.yy + third * e.yy, q.c.xy + third * e.xy};
      R x, y;
      weight_of_side(c, s, x, y);
      h0[0] = h0[0] + x * rest.h[0], dh[0] = dh[0] + x * change.h[0];
      h0[1] = h0[1] + y * rest.h[1], dh[1] = dh[1] + y * change.h[1];
      h0[2] = h0[2] + y * rest.h[0] + x * rest.h[1], dh[2] = dh[2] + y * change.h[0] + x * change.h[1];
      GLISSON_UNROLL
      for (int k = 0; k < 2; ++k) q.F[s][k] = rest.h[k] + change.h[k];
    }
    q.a = c.a + da, q.b = c.b + db;
    const Vec3<R> N0 = cross(c.a, c.b), dN = cross(c.a, db) + cross(da, q.b), N = N0 + dN;
    const R double_area = square_root(dot(N, N));
    q.inverse_double_area = R(1) / double_area;
    q.n = q.inverse_double_area * N;
    // |N| - |N0| and n - n0 without subtracting nearly equal numbers
    const R growth = dot(dN, N0 + N) / (double_area + dot(N0, N0) * c.inverse_double_area);
    const Vec3<R> dn = q.inverse_double_area * (dN - (growth * c.inverse_double_area) * N0);
    GLISSON_UNROLL
    for (int k = 0; k < 3; ++k) q.h[k] = h0[k] + dh[k];
    q.chi = {dot(q.n, dh[0]) + dot(dn, h0[0]), dot(q.n, dh[1]) + dot(dn, h0[1]),
             dot(q.n, dh[2]) + dot(dn, h0[2])};
    return q;
  }

  template <class R>
  GLISSON_HD_INLINE static Bending<R> moments(const R& stiffness, const R& nu, const Bending<R>& chi) {
    return {stiffness * (chi.xx + nu * chi.yy), stiffness * (chi.yy + nu * chi.xx),
            stiffness * R(0.5) * (R(1) - nu) * chi.xy};
  }
  template <class R, class C>
  GLISSON_HD_INLINE static Plane<R> plane_strain(const C& c, const Vec3<R> (&u)[6]) {
    return state(c, u).c;
  }
  template <class R, class C>
  GLISSON_HD_INLINE static R bending_energy(const C& c, const Vec3<R> (&u)[6]) {
    const Bending<R> chi = state(c, u).chi, M = moments(c.bending, c.nu, chi);
    return R(0.5) * (M.xx * chi.xx + M.yy * chi.yy + M.xy * chi.xy);
  }

  /// f <- forces of given stress S [Pa] and of moments M that are integrated over the area [N m^2].
  template <class R, class C>
  GLISSON_HD_INLINE static void forces_of(const C& c, const State<R>& q, const Plane<R>& S,
                                          const Bending<R>& M, Vec3<R> (&f)[6]) {
    const Vec3<R> H = M.xx * q.h[0] + M.yy * q.h[1] + M.xy * q.h[2];
    const Vec3<R> Q = q.inverse_double_area * (H - dot(q.n, H) * q.n);  // M : h . dn = Q . dN
    f[1] = cross(Q, q.b);
    f[2] = cross(q.a, Q);
    f[0] = Vec3<R>{} - f[1] - f[2];
    f[3] = f[4] = f[5] = {};
    const R V = c.volume * R(1.0 / 3);
    const Plane<R> weighted{V * S.xx, V * S.yy, V * S.xy};
    GLISSON_UNROLL
    for (int s = 0; s < 3; ++s) {
      R x, y;
      weight_of_side(c, s, x, y);
      Vec3<R> P[2], on_across, on_side;
      first_pk(weighted, q.F[s], P);
      P[0] = P[0] + (M.xx * x + M.xy * y) * q.n;
      P[1] = P[1] + (M.yy * y + M.xy * x) * q.n;
      on_differences(c.g[s], P, on_across, on_side);
      subtract_across(c, on_across, s, f);
      f[(s + 1) % 3] = f[(s + 1) % 3] + on_side;
      f[(s + 2) % 3] = f[(s + 2) % 3] - on_side;
    }
  }
  template <class R, class C, class Stress>
  GLISSON_HD_INLINE static void forces(const C& c, const Vec3<R> (&u)[6], const Stress& stress,
                                       Vec3<R> (&f)[6]) {
    const State<R> q = state(c, u);
    forces_of(c, q, stress(q.c), moments(c.bending, c.nu, q.chi), f);
  }

  /// Sets what follows from the rest positions X, where an image repeats the node that it is the image of,
  /// from any origin near by. bending: E h^3 / (12 (1 - nu^2)) [N m]. Images are set before.
  template <class R, class C>
  GLISSON_HD_INLINE static void set_rest(C& c, const Vec3<R> (&X)[6], const R& thickness, const R& bending) {
    c.a = X[1] - X[0], c.b = X[2] - X[0];
    const auto N = cross(c.a, c.b);
    const R double_area = square_root(dot(N, N));
    c.inverse_double_area = R(1) / double_area;
    c.volume = R(0.5) * double_area * thickness;
    c.bending = R(0.5) * double_area * bending;
    for (int s = 0; s < 3; ++s) c.across[s] = across(c, X, s);
  }

  /// X: rest positions; those of images are not read. mirror: normal of the plane of each side that has one;
  /// bending as for set_rest().
  static Constants<double> make(const Vec3<double> (&X)[6], const Across (&across)[3],
                                const Vec3<double> (&mirror)[3], const Vec3<double>& along, double thickness,
                                double bending, double nu) {
    Constants<double> c{};
    c.nu = nu;
    Vec3<double> own[6];
    for (int s = 0; s < 3; ++s) {
      own[s] = X[s];
      own[3 + s] = across[s] == Across::neighbour ? X[3 + s] : X[s];
      if (across[s] == Across::mirror) c.image[s].mirror = mirror[s];
      if (across[s] == Across::nothing) c.image[s].turned = 1;
    }
    set_rest(c, own, thickness, bending);
    const auto flat = surface_point(c.a, c.b, along);
    for (int s = 0; s < 3; ++s) {
      const auto point = surface_point(c.across[s], X[(s + 2) % 3] - X[(s + 1) % 3], along);
      for (int i = 0; i < 4; ++i) c.g[s][i / 2][i % 2] = point.g[i / 2][i % 2];
      if (s > 0)
        for (int l = 0; l < 2; ++l) c.dL[s - 1][l] = flat.g[s - 1][l];
    }
    return c;
  }
};

/// The same with three neighbours: the constants of images are not read.
struct RotationFreeInner : RotationFree {
  template <class R>
  using Constants = ShellPatch<R>;
};

}  // namespace glisson::shells
