// Loop bodies of the tetrahedron with nodal-averaged pressure (T4ANP): Joldes, Wittek & Miller 2009.
#pragma once

#include <glisson/core/elements/t4.hpp>
#include <glisson/core/kernels/element_forces.hpp>

namespace glisson {

/// p_e = kappa (J - 1).
template <class R, class L>
GLISSON_HD R element_pressure(const T4::Constants<R>& c, const Vec3<R> (&u_e)[4], const L& law) {
  Mat3<R> D;
  R J_minus_1;
  volume_terms(T4::displacement_gradient(c, u_e), D, J_minus_1);
  return law.bulk_modulus() * J_minus_1;
}

/// Sweep 1.
template <class R, class L>
struct ElementPressure {
  BlockView<R> block;
  EvaluationView<R> now;
  GLISSON_HD void operator()(int e) const {
    Vec3<R> u_e[4];
    gather<R, T4>(block.nodes, e, now.u, u_e);
    const auto& c = static_cast<const T4::Constants<R>*>(block.constants)[e];
    block.volume_change[e] = element_pressure(c, u_e, law_of<R, L>(block, e));
  }
};

/// Between the sweeps: the volume-weighted mean over the elements of a node, whatever set they belong to.
template <class R>
struct NodalPressure {
  const int* begin;    ///< [mesh node_count + 1]
  const int* element;  ///< place in element_pressure [begin.back()]
  const R* weight;     ///< V_e / sum of V at the node [-]  [begin.back()]
  const R* element_pressure;
  R* nodal_pressure;  ///< [Pa]  [mesh node_count]
  GLISSON_HD void operator()(int n) const {
    R sum = R(0);
    for (int k = begin[n]; k < begin[n + 1]; ++k) sum = sum + weight[k] * element_pressure[element[k]];
    nodal_pressure[n] = sum;
  }
};

/// Fm = (Jm / J)^(1/3) F with Jm = 1 + mean nodal pressure / kappa; returns Fm - I.
template <class R>
GLISSON_HD Mat3<R> averaged_gradient(const Mat3<R>& H, R Jm_minus_1) {
  Mat3<R> D, A;
  R J_minus_1;
  volume_terms(H, D, J_minus_1);
  const R z = (Jm_minus_1 - J_minus_1) / (J_minus_1 + R(1));
  const R s = R(1) / rcbrt(z + R(1)), t = z / (R(1) + s + s * s);  // t = s - 1 without cancellation
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) A.m[i][k] = H.m[i][k] + t * H.m[i][k];
  for (int i = 0; i < 3; ++i) A.m[i][i] = A.m[i][i] + t;
  return A;
}

template <class R, class L>
GLISSON_HD R averaged_volume(const BlockView<R>& block, const L& law, int e) {
  R p = R(0);
  for (int a = 0; a < 4; ++a) p = p + block.nodal_pressure[block.nodes[4 * e + a]];
  return R(0.25) * p / law.bulk_modulus();
}

/// Sweep 2: the stress of Fm with the gradients of the element.
template <class R, class L, bool viscous>
struct AveragedForces {
  BlockView<R> block;
  EvaluationView<R> now;
  GLISSON_HD void operator()(int e) const {
    Vec3<R> u_e[4], f_e[4];
    gather<R, T4>(block.nodes, e, now.u, u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = static_cast<const T4::Constants<R>*>(block.constants)[e];
    const Mat3<R> H = averaged_gradient(T4::displacement_gradient(c, u_e), averaged_volume(block, law, e));
    T4::nodal_forces(c, PointStress<R, L, viscous>{block, law, e, now.store}(H, 0), f_e);
    for (int a = 0; a < 4; ++a) block.f_element[4 * e + a] = {f_e[a].x, f_e[a].y, f_e[a].z, R(0)};
  }
};

/// V (W(Fm) + kappa/2 (Jm - 1)(J - Jm)). The second term makes the pressure work on the nodal means: for one
/// kappa the volumetric part sums to that of the nodes, sum_a V_a kappa/2 (J_a - 1)^2, of which the forces
/// are the derivative up to factors (Jm/J)^(1/3). W(Fm) alone is less, because each element smooths once
/// more.
template <class R, class L>
GLISSON_HD double averaged_energy(const T4::Constants<R>& c, const Vec3<R> (&u_e)[4], const L& law,
                                  R Jm_minus_1) {
  const Mat3<R> H = T4::displacement_gradient(c, u_e);
  Mat3<R> D;
  R J_minus_1;
  volume_terms(H, D, J_minus_1);
  const R volumetric = R(0.5) * law.bulk_modulus() * Jm_minus_1 * (J_minus_1 - Jm_minus_1);
  return double(c.volume) * (double(law.energy(averaged_gradient(H, Jm_minus_1))) + double(volumetric));
}

template <class R, class L>
struct AveragedEnergy {
  BlockView<R> block;
  EvaluationView<R> now;
  GLISSON_HD void operator()(int e) const {
    Vec3<R> u_e[4];
    gather<R, T4>(block.nodes, e, now.u, u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = static_cast<const T4::Constants<R>*>(block.constants)[e];
    block.energy[e] = averaged_energy(c, u_e, law, averaged_volume(block, law, e));
  }
};

}  // namespace glisson
