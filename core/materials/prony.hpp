// Linear relaxation on top of any law: Prony series on the isochoric and the volumetric stress.
#pragma once

#include <cstddef>
#include <glisson/core/materials/law.hpp>
#include <glisson/core/tensor/symmetric.hpp>

namespace glisson {

/// One term for a fixed time step dt: Y_n = Y_(n-1) + rate (alpha S_n - Y_(n-1)), rate = dt / (dt + tau).
/// This is backward Euler of tau Y' + Y = alpha S and the same as Y_n = dt alpha/(dt + tau) S_n + tau/(dt +
/// tau) Y_(n-1) (Taylor, Comas et al. 2009), but float keeps alpha S as its exact steady state: a decay
/// factor rounded near 1 does not.
template <class T>
struct PronyCoefficients {
  T alpha;  ///< relative modulus that relaxes [-]
  T rate;   ///< dt / (dt + tau) [-]
};

/// alpha [-], tau [s], dt [s]; call it in double and convert. In float the history stops to follow when its
/// change falls below rounding: with dt / tau = r it stays within about 6e-8 / r of the exact one, 0.06 % at
/// r = 1e-4.
template <class T>
constexpr PronyCoefficients<T> prony_coefficients(T alpha, T tau, T dt) {
  return {alpha, dt / (dt + tau)};
}

/// The terms of a block of elements: isochoric first, then volumetric. T is a built-in number also where R is
/// a pack.
template <class T>
struct PronyTerms {
  const PronyCoefficients<T>* terms = nullptr;  ///< [isochoric_count + volumetric_count]
  int isochoric_count = 0, volumetric_count = 0;
};

/// History of one element and integration point: component c (11 22 33 12 23 13) of term t is data[(6 t + c)
/// stride]. Scalars: data = array + element, stride = element count. Packs: data = start of the tile as
/// packs, stride 1, so that the tile in memory is [term][component][lane].
template <class R>
struct StridedHistory {
  R* data = nullptr;  ///< overstress Y [Pa]
  std::ptrdiff_t stride = 1;
  GLISSON_HD R get(int term, int component) const { return data[(6 * term + component) * stride]; }
  GLISSON_HD void set(int term, int component, const R& value) const {
    data[(6 * term + component) * stride] = value;
  }
};

namespace detail {

/// S - sum of Y_n over count terms, which all follow the elastic stress S; new Y are stored if asked for.
template <class R, class T, class History>
GLISSON_HD Sym3<R> relaxed(const Sym3<R>& S, const PronyCoefficients<T>* terms, int count, int first,
                           const History& history, bool store) {
  const R elastic[6] = {S.xx, S.yy, S.zz, S.xy, S.yz, S.xz};
  R left[6] = {S.xx, S.yy, S.zz, S.xy, S.yz, S.xz};
  for (int t = 0; t < count; ++t) {
    const R alpha = R(terms[t].alpha), rate = R(terms[t].rate);
    for (int c = 0; c < 6; ++c) {
      const R before = history.get(first + t, c);
      const R Y = before + rate * (alpha * elastic[c] - before);
      left[c] = left[c] - Y;
      if (store) history.set(first + t, c, Y);
    }
  }
  return {left[0], left[1], left[2], left[3], left[4], left[5]};
}

}  // namespace detail

/// S = S_iso + S_vol - sum Y_iso - sum Y_vol [Pa] at the end of a step of dt that leads to H. mu and kappa of
/// the law are the moduli of instantaneous load; (1 - sum alpha) of them remain. store = false only
/// evaluates, for energies and output; one stored update per step and point, or time runs twice.
template <class R, class L, class T, class History>
GLISSON_HD Sym3<R> second_pk_relaxed(const L& law, const Mat3<R>& H, const PronyTerms<T>& prony,
                                     const History& history, bool store) {
  const SplitStress<R> S = law.second_pk(H);
  const int n = prony.isochoric_count;
  return detail::relaxed(S.isochoric, prony.terms, n, 0, history, store) +
         detail::relaxed(S.volumetric, prony.terms + n, prony.volumetric_count, n, history, store);
}

/// P = F S of the above. Formulations that replace F (averaged nodal pressure, F-bar) pass H = F_modified -
/// I.
template <class R, class L, class T, class History>
GLISSON_HD Mat3<R> first_pk_relaxed(const L& law, const Mat3<R>& H, const PronyTerms<T>& prony,
                                    const History& history, bool store) {
  return push_first(H, second_pk_relaxed(law, H, prony, history, store));
}

}  // namespace glisson
