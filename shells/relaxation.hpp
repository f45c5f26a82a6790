// Linear relaxation of the stress in the plane.
#pragma once

#include <cstddef>

#include <glisson/core/materials/prony.hpp>
#include <glisson/shells/laws/plane.hpp>

namespace glisson::shells {

/// Prony history of the triangles of one section; R may be a pack, then element_count counts packs.
template <class R, class T>
struct PlaneHistory {
  R* Y = nullptr;                               ///< overstress [Pa]  [term][3][element_count]
  const PronyCoefficients<T>* terms = nullptr;  ///< [term_count]
  int term_count = 0, element_count = 1;
};

/// S less the relaxed part; new Y are stored if asked for.
template <class R, class T>
GLISSON_HD Plane<R> relaxed(const PlaneHistory<R, T>& history, int e, const Plane<R>& S, bool store) {
  const R elastic[3] = {S.xx, S.yy, S.xy};
  R left[3] = {S.xx, S.yy, S.xy};
  for (int t = 0; t < history.term_count; ++t)
    for (int k = 0; k < 3; ++k) {
      R& place = history.Y[std::ptrdiff_t(3 * t + k) * history.element_count + e];
      const R before = place,
              Y = before + R(history.terms[t].rate) * (R(history.terms[t].alpha) * elastic[k] - before);
      left[k] = left[k] - Y;
      if (store) place = Y;
    }
  return {left[0], left[1], left[2]};
}

}  // namespace glisson::shells
