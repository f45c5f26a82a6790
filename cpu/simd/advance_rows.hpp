// AdvanceNodes and AdvanceNodesDamped for W / 4 nodes at a time. Only for kernel files.
#pragma once

#include <cstring>

#include <glisson/cpu/node_kernels.hpp>
#include <glisson/cpu/simd/nodes.hpp>

namespace glisson::patches {

template <int W>
GLISSON_INLINE Pack<W> repeated(const Vec4<float>& row) {
  Pack<W> result;
  for (int i = 0; i < W; i += 4)
    result.v[i] = row.x, result.v[i + 1] = row.y, result.v[i + 2] = row.z, result.v[i + 3] = row.w;
  return result;
}

template <int W, class Stepper>
struct PackStepper;
template <int W>
struct PackStepper<W, CentralDifference<float>> {
  Pack<W> keep, kick, drift;
  GLISSON_INLINE explicit PackStepper(const CentralDifference<float>::Rows& rows)
      : keep(repeated<W>(rows.keep)), kick(repeated<W>(rows.kick)), drift(repeated<W>(rows.drift)) {}
  GLISSON_INLINE Pack<W> velocity(Pack<W> v, Pack<W> w, Pack<W> f) const { return keep * v + (w * kick) * f; }
};
template <int W>
struct PackStepper<W, Newmark<float>> {
  Pack<W> damping, kick, drift;
  GLISSON_INLINE explicit PackStepper(const Newmark<float>::Rows& rows)
      : damping(rows.damping), kick(repeated<W>(rows.kick)), drift(repeated<W>(rows.drift)) {}
  GLISSON_INLINE Pack<W> velocity(Pack<W> v, Pack<W> w, Pack<W> f) const {
    return v + kick * (w * f - damping * v);
  }
};

/// From and to rows of nodes, which need not start at a multiple of W floats.
template <int W>
GLISSON_INLINE Pack<W> load_anywhere(const float* rows) {
  Pack<W> a;
  __builtin_memcpy(&a.v, rows, sizeof(a.v));
  return a;
}
template <int W>
GLISSON_INLINE void store_anywhere(float* rows, Pack<W> a) {
  __builtin_memcpy(rows, &a.v, sizeof(a.v));
}

/// m |v(n-1/2) + v(n+1/2)|^2 in lanes x y z of each node, after moving W / 4 nodes.
template <int W, bool damped, class Step>
GLISSON_INLINE Pack<W> advance_rows(const Step& stepper, float* u, float* v, float* f) {
  using P = Pack<W>;
  const P v_old = load_anywhere<W>(v), w = shuffle_lanes<3, 3, 3, 3>(v_old, v_old),
          v_new = stepper.velocity(v_old, w, load_anywhere<W>(f)),
          u_new = load_anywhere<W>(u) + stepper.drift * v_new;
  store_anywhere(v, v_new);
  store_anywhere(u, u_new);
  store_anywhere(f, P(0));
  if constexpr (!damped) return P(0);
  const P both = v_old + v_new;
  return select(w > P(0), (both * both) / w, P(0));
}

/// Nodes first .. last - 1, the sum of what advance_rows gives. The last few go through a block of W floats.
template <int W, bool damped, class Step>
GLISSON_INLINE Pack<W> advance_nodes(const Step& stepper, float* u, float* v, float* f, int first, int last) {
  Pack<W> sum(0);
  std::ptrdiff_t i = 4 * static_cast<std::ptrdiff_t>(first);
  const std::ptrdiff_t end = 4 * static_cast<std::ptrdiff_t>(last);
  for (; i + W <= end; i += W) sum += advance_rows<W, damped>(stepper, u + i, v + i, f + i);
  if (i == end) return sum;
  float rows[3][W] = {};
  float* const arrays[3] = {u + i, v + i, f + i};
  const std::size_t bytes = static_cast<std::size_t>(end - i) * sizeof(float);
  for (int k = 0; k < 3; ++k) std::memcpy(rows[k], arrays[k], bytes);
  sum += advance_rows<W, damped>(stepper, rows[0], rows[1], rows[2]);
  for (int k = 0; k < 3; ++k) std::memcpy(arrays[k], rows[k], bytes);
  return sum;
}

GLISSON_INLINE float* numbers(Vec4<float>* rows) { return reinterpret_cast<float*>(rows); }

template <int W, class Stepper>
GLISSON_FLATTEN void advance_all(const AdvanceNodes<float, Stepper>& body, int first, int last) {
  const PackStepper<W, Stepper> stepper(body.stepper);
  advance_nodes<W, false>(stepper, numbers(body.u), numbers(body.v), numbers(body.f), first, last);
}

template <int W, class Stepper>
GLISSON_FLATTEN void advance_damped(const AdvanceNodesDamped<float, Stepper>& body, int first, int last) {
  const AdvanceNodes<float, Stepper>& nodes = body.nodes;
  const PackStepper<W, Stepper> stepper(nodes.stepper);
  for (int c = first; c < last; ++c) {
    const int begin = c * body.chunk, end = begin + body.chunk;
    const Pack<W> sum = advance_nodes<W, true>(stepper, numbers(nodes.u), numbers(nodes.v), numbers(nodes.f),
                                               begin, end < body.node_count ? end : body.node_count);
    double total = 0;
    for (int i = 0; i < W; ++i)
      if (i % 4 < 3) total += static_cast<double>(sum.v[i]);
    body.energies[c].damping += 0.25 * body.damping * body.dt * total;
  }
}

template <int W, class Stepper>
constexpr NodeKernelsOf<Stepper> node_kernels_of() {
  return {advance_all<W, Stepper>, advance_damped<W, Stepper>};
}

}  // namespace glisson::patches
