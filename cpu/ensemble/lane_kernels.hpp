// The kernels of an ensemble for one width: the element bodies of core/ with R = pack of W members.
#pragma once

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/materials/laws.hpp>
#include <glisson/cpu/ensemble/lane_table.hpp>
#include <glisson/cpu/simd/math.hpp>
#include <glisson/cpu/simd/nodes.hpp>

namespace glisson::lanes {

template <int W>
GLISSON_INLINE Vec3<Pack<W>> load_vector(const float* from, int node) {
  const float* p = from + static_cast<std::size_t>(node) * 3 * W;
  return {Pack<W>::load(p), Pack<W>::load(p + W), Pack<W>::load(p + 2 * W)};
}

template <int W>
GLISSON_INLINE void add_vector(float* to, int node, const Vec3<Pack<W>>& a) {
  float* p = to + static_cast<std::size_t>(node) * 3 * W;
  (Pack<W>::load(p) + a.x).store(p);
  (Pack<W>::load(p + W) + a.y).store(p + W);
  (Pack<W>::load(p + 2 * W) + a.z).store(p + 2 * W);
}

/// Constants of element e, the same number in all lanes; only the hourglass stiffness is a member's own.
template <int W>
GLISSON_INLINE void load_constants(const LaneBlock& block, int e, T4::Constants<Pack<W>>& c) {
  const float* from = block.constants + static_cast<std::size_t>(e) * T4::constant_count;
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k < 3; ++k) c.B[a][k] = Pack<W>(from[3 * a + k]);
  c.volume = Pack<W>(from[9]);
}
template <int W>
GLISSON_INLINE void load_constants(const LaneBlock& block, int e, H8::Constants<Pack<W>>& c) {
  const float* from = block.constants + static_cast<std::size_t>(e) * H8::constant_count;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c.beta[i][j] = Pack<W>(from[3 * i + j]);
  for (int m = 0; m < 3; ++m)
    for (int j = 0; j < 3; ++j) c.eta[m][j] = Pack<W>(from[9 + 3 * m + j]);
  for (int m = 0; m < 4; ++m)
    for (int j = 0; j < 3; ++j) c.chi[m][j] = Pack<W>(from[18 + 3 * m + j]);
  c.volume = Pack<W>(from[30]);
  c.hourglass = Pack<W>::load(block.hourglass + static_cast<std::size_t>(e) * W);
}
template <int W>
GLISSON_INLINE void load_constants(const LaneBlock& block, int e, H8Full::Constants<Pack<W>>& c) {
  const float* from = block.constants + static_cast<std::size_t>(e) * H8Full::constant_count;
  for (int p = 0; p < 8; ++p) {
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) c.inverse[p][j][i] = Pack<W>(from[9 * p + 3 * j + i]);
    c.weight[p] = Pack<W>(from[72 + p]);
  }
}

template <int W, class E>
GLISSON_INLINE void load_element(const LaneBlock& block, const LanePass& pass, int e,
                                 typename E::template Constants<Pack<W>>& c,
                                 Vec3<Pack<W>> (&u)[E::node_count]) {
  load_constants<W>(block, e, c);
  for (int a = 0; a < E::node_count; ++a) u[a] = load_vector<W>(pass.u, block.nodes[e * E::node_count + a]);
}

/// detail::relaxed of core/materials/prony.hpp with coefficients, and the wish to move on, of each member.
template <int W>
GLISSON_INLINE Sym3<Pack<W>> relaxed(const Sym3<Pack<W>>& S, const LaneBlock& block, const LanePass& pass,
                                     float* history, int first, int count) {
  const Pack<W> elastic[6] = {S.xx, S.yy, S.zz, S.xy, S.yz, S.xz};
  Pack<W> left[6] = {S.xx, S.yy, S.zz, S.xy, S.yz, S.xz};
  const Mask<W> advance{*reinterpret_cast<const typename Pack<W>::Ints*>(pass.advance)};
  for (int t = first; t < first + count; ++t) {
    const Pack<W> alpha = Pack<W>::load(block.alpha + t * W), rate = Pack<W>::load(block.rate + t * W);
    for (int k = 0; k < 6; ++k) {
      float* place = history + (6 * t + k) * W;
      const Pack<W> before = Pack<W>::load(place), Y = before + rate * (alpha * elastic[k] - before);
      left[k] = left[k] - Y;
      select(advance, Y, before).store(place);
    }
  }
  return {left[0], left[1], left[2], left[3], left[4], left[5]};
}

/// P of any law, through pointers.
template <int W>
struct AnyStress {
  const LaneBlock& block;
  const LanePass& pass;
  const float* parameters;
  int e, points;

  Mat3<Pack<W>> operator()(const Mat3<Pack<W>>& H, int p) const {
    const int terms = block.isochoric + block.volumetric;
    if (terms == 0) {
      Mat3<Pack<W>> P;
      block.law->first_pk(&H, parameters, &P);
      return P;
    }
    SplitStress<Pack<W>> S;
    block.law->second_pk(&H, parameters, &S);
    float* history = block.history + (static_cast<std::size_t>(e) * points + p) * terms * 6 * W;
    return push_first(H,
                      relaxed<W>(S.isochoric, block, pass, history, 0, block.isochoric) +
                          relaxed<W>(S.volumetric, block, pass, history, block.isochoric, block.volumetric));
  }
};

template <int W>
GLISSON_INLINE const float* parameters_of(const LaneBlock& block, int e) {
  return block.parameters + static_cast<std::size_t>(e) * block.parameter_stride;
}

template <int W, class E>
GLISSON_FLATTEN void forces(const LaneBlock& block, const LanePass& pass) {
  for (int e = 0; e < block.element_count; ++e) {
    typename E::template Constants<Pack<W>> c;
    Vec3<Pack<W>> u[E::node_count], f[E::node_count];
    load_element<W, E>(block, pass, e, c, u);
    E::forces(c, u, AnyStress<W>{block, pass, parameters_of<W>(block, e), e, E::point_count}, f);
    for (int a = 0; a < E::node_count; ++a) add_vector<W>(pass.f, block.nodes[e * E::node_count + a], f[a]);
  }
}

template <int W>
GLISSON_FLATTEN void neo_hookean_forces(const LaneBlock& block, const LanePass& pass) {
  for (int e = 0; e < block.element_count; ++e) {
    T4::Constants<Pack<W>> c;
    Vec3<Pack<W>> u[4], f[4];
    load_element<W, T4>(block, pass, e, c, u);
    const float* p = parameters_of<W>(block, e);
    // -V P, in which the parameters are factors: two products instead of eighteen
    const NeoHookean<Pack<W>> law{Pack<W>(0) - c.volume * Pack<W>::load(p),
                                  Pack<W>(0) - c.volume * Pack<W>::load(p + W)};
    T4::forces_of(c, law.first_pk(T4::displacement_gradient(c, u)), f);
    for (int a = 0; a < 4; ++a) add_vector<W>(pass.f, block.nodes[4 * e + a], f[a]);
  }
}

template <int W>
GLISSON_INLINE Pack<W> bulk_modulus(const LaneBlock& block, int e) {
  return Pack<W>::load(parameters_of<W>(block, e) + block.law->parameter_count * W);
}

template <int W>
GLISSON_FLATTEN void pressures(const LaneBlock& block, const LanePass& pass) {
  for (int e = 0; e < block.element_count; ++e) {
    T4::Constants<Pack<W>> c;
    Vec3<Pack<W>> u[4];
    load_element<W, T4>(block, pass, e, c, u);
    Mat3<Pack<W>> D;
    Pack<W> J_minus_1;
    volume_terms(T4::displacement_gradient(c, u), D, J_minus_1);
    (bulk_modulus<W>(block, e) * J_minus_1).store(block.pressure + static_cast<std::size_t>(e) * W);
  }
}

template <int W>
GLISSON_FLATTEN void average(const AveragePass& pass) {
  for (int n = 0; n < pass.node_count; ++n) {
    Pack<W> sum(0);
    for (int k = pass.begin[n]; k < pass.begin[n + 1]; ++k)
      sum = sum + Pack<W>(pass.weight[k]) *
                      Pack<W>::load(pass.pressure + static_cast<std::size_t>(pass.element[k]) * W);
    sum.store(pass.nodal_pressure + static_cast<std::size_t>(n) * W);
  }
}

/// Jm - 1 of the element from the pressure of its nodes.
template <int W>
GLISSON_INLINE Pack<W> mean_volume_change(const LaneBlock& block, const LanePass& pass, int e) {
  Pack<W> p(0);
  for (int a = 0; a < 4; ++a)
    p = p + Pack<W>::load(pass.nodal_pressure + static_cast<std::size_t>(block.nodes[4 * e + a]) * W);
  return Pack<W>(0.25) * p / bulk_modulus<W>(block, e);
}

template <int W>
GLISSON_FLATTEN void averaged_forces(const LaneBlock& block, const LanePass& pass) {
  for (int e = 0; e < block.element_count; ++e) {
    T4::Constants<Pack<W>> c;
    Vec3<Pack<W>> u[4], f[4];
    load_element<W, T4>(block, pass, e, c, u);
    const Mat3<Pack<W>> H =
        averaged_gradient(T4::displacement_gradient(c, u), mean_volume_change<W>(block, pass, e));
    const AnyStress<W> stress{block, pass, parameters_of<W>(block, e), e, 1};
    T4::nodal_forces(c, stress(H, 0), f);
    for (int a = 0; a < 4; ++a) add_vector<W>(pass.f, block.nodes[4 * e + a], f[a]);
  }
}

template <int W>
GLISSON_INLINE void add_lanes(double* sums, Pack<W> weight, Pack<W> energy) {
  for (int lane = 0; lane < W; ++lane)
    sums[lane] += static_cast<double>(weight.v[lane]) * static_cast<double>(energy.v[lane]);
}

template <int W, class E>
GLISSON_FLATTEN void energies(const LaneBlock& block, const LanePass& pass, double* sums) {
  for (int e = 0; e < block.element_count; ++e) {
    typename E::template Constants<Pack<W>> c;
    Vec3<Pack<W>> u[E::node_count];
    load_element<W, E>(block, pass, e, c, u);
    E::points(c, u, [&](const Mat3<Pack<W>>& H, Pack<W> weight, int) {
      Pack<W> energy;
      block.law->energy(&H, parameters_of<W>(block, e), &energy);
      add_lanes<W>(sums, weight, energy);
    });
  }
}

/// See AveragedEnergy of core/kernels/averaged_pressure.hpp.
template <int W>
GLISSON_FLATTEN void averaged_energies(const LaneBlock& block, const LanePass& pass, double* sums) {
  using P = Pack<W>;
  for (int e = 0; e < block.element_count; ++e) {
    T4::Constants<P> c;
    Vec3<P> u[4];
    load_element<W, T4>(block, pass, e, c, u);
    const Mat3<P> H = T4::displacement_gradient(c, u);
    const P Jm_minus_1 = mean_volume_change<W>(block, pass, e);
    Mat3<P> D;
    P J_minus_1, energy;
    volume_terms(H, D, J_minus_1);
    const P volumetric = P(0.5) * bulk_modulus<W>(block, e) * Jm_minus_1 * (J_minus_1 - Jm_minus_1);
    const Mat3<P> averaged = averaged_gradient(H, Jm_minus_1);
    block.law->energy(&averaged, parameters_of<W>(block, e), &energy);
    add_lanes<W>(sums, c.volume, energy + volumetric);
  }
}

template <int W>
GLISSON_FLATTEN void hourglass_energies(const LaneBlock& block, const LanePass& pass, double* sums) {
  for (int e = 0; e < block.element_count; ++e) {
    H8::Constants<Pack<W>> c;
    Vec3<Pack<W>> u[8];
    load_element<W, H8>(block, pass, e, c, u);
    add_lanes<W>(sums, Pack<W>(1), H8::hourglass_energy(c, u));
  }
}

/// W/4 rows side by side.
template <int W>
GLISSON_INLINE Pack<W> join_rows(const float* const* rows, std::size_t place) {
  const auto row = [&](int k) { return patches::load_row(rows[4 * k] + place); };
  if constexpr (W == 4) {
    return Pack<4>(row(0));
  } else if constexpr (W == 8) {
    return Pack<8>(__builtin_shufflevector(row(0), row(1), 0, 1, 2, 3, 4, 5, 6, 7));
  } else {
    const auto low = __builtin_shufflevector(row(0), row(1), 0, 1, 2, 3, 4, 5, 6, 7),
               high = __builtin_shufflevector(row(2), row(3), 0, 1, 2, 3, 4, 5, 6, 7);
    return Pack<16>(__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  }
}

/// From rows of W members, as load_nodes of cpu/simd/nodes.hpp.
template <int W>
GLISSON_FLATTEN void gather(const float* const* rows, int node_count, float* u) {
  using namespace patches;
  const auto lanes = std::make_index_sequence<W>();
  for (int n = 0; n < node_count; ++n, u += 3 * W) {
    const std::size_t place = 4 * static_cast<std::size_t>(n);
    const Pack<W> r0 = join_rows<W>(rows, place), r1 = join_rows<W>(rows + 1, place),
                  r2 = join_rows<W>(rows + 2, place), r3 = join_rows<W>(rows + 3, place);
    const Pack<W> xy01 = interleave_low(r0, r1, lanes), zw01 = interleave_high(r0, r1, lanes),
                  xy23 = interleave_low(r2, r3, lanes), zw23 = interleave_high(r2, r3, lanes);
    shuffle_lanes<0, 1, 0, 1>(xy01, xy23).store(u);
    shuffle_lanes<2, 3, 2, 3>(xy01, xy23).store(u + W);
    shuffle_lanes<0, 1, 0, 1>(zw01, zw23).store(u + 2 * W);
  }
}

/// Adds W/4 rows that lie side by side to the lanes 0, 4, 8, ... behind `rows`.
template <int W>
GLISSON_INLINE void add_rows(Pack<W> values, float* const* rows, std::size_t place) {
  alignas(64) float side_by_side[W];
  values.store(side_by_side);
  for (int k = 0; k < W / 4; ++k) {
    if (!rows[4 * k]) continue;
    float* row = rows[4 * k] + place;
    patches::store_row(row, patches::load_row(row) + patches::load_row(side_by_side + 4 * k));
  }
}

template <int W>
GLISSON_FLATTEN void scatter(const float* f, int node_count, float* const* rows) {
  using namespace patches;
  const auto lanes = std::make_index_sequence<W>();
  for (int n = 0; n < node_count; ++n, f += 3 * W) {
    const std::size_t place = 4 * static_cast<std::size_t>(n);
    const Pack<W> x = Pack<W>::load(f), y = Pack<W>::load(f + W), z = Pack<W>::load(f + 2 * W), zero(0),
                  xy01 = interleave_low(x, y, lanes), xy23 = interleave_high(x, y, lanes),
                  z01 = interleave_low(z, zero, lanes), z23 = interleave_high(z, zero, lanes);
    add_rows<W>(shuffle_lanes<0, 1, 0, 1>(xy01, z01), rows, place);
    add_rows<W>(shuffle_lanes<2, 3, 2, 3>(xy01, z01), rows + 1, place);
    add_rows<W>(shuffle_lanes<0, 1, 0, 1>(xy23, z23), rows + 2, place);
    add_rows<W>(shuffle_lanes<2, 3, 2, 3>(xy23, z23), rows + 3, place);
  }
}

template <int W, template <class> class Law>
GLISSON_INLINE Law<Pack<W>> load_law(const float* parameters) {
  Pack<W> p[Law<Pack<W>>::parameter_count];
  for (int k = 0; k < Law<Pack<W>>::parameter_count; ++k) p[k] = Pack<W>::load(parameters + k * W);
  return Law<Pack<W>>::load(p);
}
template <int W, template <class> class Law>
GLISSON_FLATTEN void first_pk(const void* H, const float* parameters, void* P) {
  *static_cast<Mat3<Pack<W>>*>(P) =
      load_law<W, Law>(parameters).first_pk(*static_cast<const Mat3<Pack<W>>*>(H));
}
template <int W, template <class> class Law>
GLISSON_FLATTEN void second_pk(const void* H, const float* parameters, void* S) {
  *static_cast<SplitStress<Pack<W>>*>(S) =
      load_law<W, Law>(parameters).second_pk(*static_cast<const Mat3<Pack<W>>*>(H));
}
template <int W, template <class> class Law>
GLISSON_FLATTEN void energy(const void* H, const float* parameters, void* result) {
  *static_cast<Pack<W>*>(result) = load_law<W, Law>(parameters).energy(*static_cast<const Mat3<Pack<W>>*>(H));
}

template <int W, template <class> class Law>
constexpr LaneLaw lane_law() {
  return {Law<Pack<W>>::name, Law<Pack<W>>::parameter_count, first_pk<W, Law>, second_pk<W, Law>,
          energy<W, Law>};
}

template <int W>
constexpr LaneTable lane_table(const char* name, bool (*available)(), const LaneLaw* laws, int law_count) {
  return {name,
          W,
          available,
          gather<W>,
          scatter<W>,
          {forces<W, T4>, averaged_forces<W>, forces<W, H8>, forces<W, H8Full>},
          neo_hookean_forces<W>,
          pressures<W>,
          average<W>,
          {energies<W, T4>, averaged_energies<W>, energies<W, H8>, energies<W, H8Full>},
          hourglass_energies<W>,
          laws,
          law_count};
}

}  // namespace glisson::lanes
