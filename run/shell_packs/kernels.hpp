// Membranes and shells for packs, one triangle or strip of triangles per lane. Only for kernel files.
#pragma once

#include <glisson/cpu/simd/nodes.hpp>
#include <glisson/cpu/solids/stress.hpp>
#include <glisson/run/shell_packs/kernel_table.hpp>
#include <glisson/run/shell_packs/strip_layout.hpp>
#include <glisson/shells/elements/membrane.hpp>
#include <glisson/shells/elements/rotation_free.hpp>
#include <glisson/shells/laws/laws.hpp>
#include <glisson/shells/laws/tension_field.hpp>
#include <glisson/shells/relaxation.hpp>

namespace glisson::shells {

using patches::MaterialTile;
using patches::Pass;
using patches::Patch;
using patches::unrolled;

/// Parameters of a patch are the members of the law, so that what load() derives from its parameters is
/// computed once.
template <int W, template <class> class L>
GLISSON_INLINE const L<Pack<W>>& load_law(const float* members) {
  return *reinterpret_cast<const L<Pack<W>>*>(members);
}

template <int W, template <class> class L, bool wrinkling>
GLISSON_FLATTEN void stress_function(const void* c, const void* tile, void* S) {
  const auto& law = load_law<W, L>(static_cast<const MaterialTile*>(tile)->parameters);
  const auto& strain = *static_cast<const Plane<Pack<W>>*>(c);
  auto& result = *static_cast<Plane<Pack<W>>*>(S);
  if constexpr (wrinkling)
    result = tension_field_stress(law, strain);
  else
    result = law.second_pk(strain);
}
template <int W, template <class> class L, bool wrinkling>
GLISSON_FLATTEN void energy_function(const void* c, const void* tile, void* energy) {
  const auto& law = load_law<W, L>(static_cast<const MaterialTile*>(tile)->parameters);
  Plane<Pack<W>> strain = *static_cast<const Plane<Pack<W>>*>(c);
  if constexpr (wrinkling) strain = tension_field(law, strain).c;
  *static_cast<Pack<W>*>(energy) = law.energy(strain);
}

/// Through the pointer of the pass, with wrinkling and relaxation.
template <int W>
struct AnyLaw {
  GLISSON_INLINE static Plane<Pack<W>> stress(const Plane<Pack<W>>& c, const MaterialTile& tile) {
    Plane<Pack<W>> S;
    tile.pass.law(&c, &tile, &S);
    if (tile.pass.isochoric == 0) return S;
    const PlaneHistory<Pack<W>, float> history{reinterpret_cast<Pack<W>*>(tile.history), tile.pass.prony,
                                               tile.pass.isochoric, 1};
    return relaxed(history, 0, S, tile.pass.advance);
  }
};
template <int W, template <class> class L>
struct CompiledInLaw {
  GLISSON_INLINE static Plane<Pack<W>> stress(const Plane<Pack<W>>& c, const MaterialTile& tile) {
    return load_law<W, L>(tile.parameters).second_pk(c);
  }
};

template <int W>
GLISSON_INLINE MaterialTile material(const Patch& patch, const Pass& pass, int place) {
  return {patch.parameters, patch.history + static_cast<std::size_t>(place * 3 * pass.isochoric) * W, pass};
}

template <int W, int count>
GLISSON_INLINE void load_corners(const float* rows, const std::uint16_t* corner, Vec3<Pack<W>> (&u)[count]) {
  unrolled<count>([&](auto a) __attribute__((always_inline)) {
    const Vec4<Pack<W>> row = patches::load_nodes<W>(rows, corner + a * W);
    u[a] = {row.x, row.y, row.z};
  });
}

/// visit(number in the strip, constants, u, place) for every triangle of every tile; done(tile) after each.
template <int W, class Visit, class Done>
GLISSON_INLINE void over_strips(const Patch& patch, const float* rows, Visit&& visit, Done&& done) {
  using Constants = Membrane::Constants<Pack<W>>;
  const auto* constants = reinterpret_cast<const Constants*>(patch.constants);
  for (int tile = 0; tile < patch.tiles; ++tile) {
    patches::prefetch(reinterpret_cast<const float*>(constants) + patches::prefetch_distance,
                      triangles_per_strip * static_cast<int>(sizeof(Constants)));
    Vec3<Pack<W>> u[corners_of_strip];
    load_corners<W>(rows, patch.corner + tile * corners_of_strip * W, u);
    unrolled<triangles_per_strip>([&](auto j) __attribute__((always_inline)) {
      const Vec3<Pack<W>> nodes[3] = {u[j], u[j + 1], u[j + 2]};
      visit(j, constants[j], nodes, tile * triangles_per_strip + j);
    });
    constants += triangles_per_strip;
    done(tile);
  }
}

template <int W, class Stress>
GLISSON_FLATTEN void membrane_forces(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  float* rows = pass.force_rows + 16;
  Vec3<P> f[corners_of_strip];
  over_strips<W>(
      patch, pass.local_rows,
      [&](auto j, const Membrane::Constants<P>& c, const Vec3<P>(&u)[3], int place)
          __attribute__((always_inline)) {
            const MaterialTile tile = material<W>(patch, pass, place);
            Vec3<P> g[3];
            Membrane::forces(
                c, u, [&](const Plane<P>& strain) { return Stress::stress(strain, tile); }, g);
            GLISSON_UNROLL
            for (int a = 0; a < 3; ++a) f[j + a] = j == 0 || a == 2 ? g[a] : f[j + a] + g[a];
          },
      [&](int tile) __attribute__((always_inline)) {
        unrolled<corners_of_strip>([&](auto a) __attribute__((always_inline)) {
          patches::store_nodes<W>(rows + (tile * corners_of_strip + a) * 4 * W, f[a]);
        });
      });
}

template <int W>
GLISSON_FLATTEN double membrane_energy(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  double total = 0;
  over_strips<W>(
      patch, pass.local_rows,
      [&](auto, const Membrane::Constants<P>& c, const Vec3<P>(&u)[3], int place)
          __attribute__((always_inline)) {
            const MaterialTile tile = material<W>(patch, pass, place);
            const Plane<P> strain = Membrane::plane_strain(c, u);
            P W_of_law;
            pass.law(&strain, &tile, &W_of_law);
            total += patches::sum_of_lanes<W>(select(c.volume > P(0), c.volume * W_of_law, P(0)));
          },
      [](int) {});
  return total;
}

/// One triangle with images per lane, or a strip of those without.
struct BorderShells {
  using Element = RotationFree;
  static constexpr int triangles = 1, nodes = 6;
};
struct InnerShells {
  using Element = RotationFreeInner;
  static constexpr int triangles = triangles_per_strip, nodes = nodes_of_shell_strip;
};

/// visit(number in the strip, constants, u, place) for every triangle of every tile; done(tile) after each.
template <int W, class Shells, class Visit, class Done>
GLISSON_INLINE void over_shells(const Patch& patch, const float* rows, Visit&& visit, Done&& done) {
  using Constants = typename Shells::Element::template Constants<Pack<W>>;
  const auto* constants = reinterpret_cast<const Constants*>(patch.constants);
  for (int tile = 0; tile < patch.tiles; ++tile) {
    patches::prefetch(reinterpret_cast<const float*>(constants) + patches::prefetch_distance,
                      Shells::triangles * static_cast<int>(sizeof(Constants)));
    Vec3<Pack<W>> u[Shells::nodes];
    load_corners<W>(rows, patch.corner + tile * Shells::nodes * W, u);
    unrolled<Shells::triangles>([&](auto j) __attribute__((always_inline)) {
      Vec3<Pack<W>> nodes[6];
      GLISSON_UNROLL
      for (int a = 0; a < 6; ++a) nodes[a] = u[shell_strip_nodes[j][a]];
      visit(j, constants[j], nodes, tile * Shells::triangles + j);
    });
    constants += Shells::triangles;
    done(tile);
  }
}

template <int W, class Shells, class Stress>
GLISSON_FLATTEN void shell_forces(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  float* rows = pass.force_rows + 16;
  Vec3<P> f[Shells::nodes];
  over_shells<W, Shells>(
      patch, pass.local_rows,
      [&](auto j, const auto& c, const Vec3<P>(&u)[6], int place) __attribute__((always_inline)) {
        const MaterialTile tile = material<W>(patch, pass, place);
        Vec3<P> g[6];
        Shells::Element::forces(
            c, u, [&](const Plane<P>& strain) { return Stress::stress(strain, tile); }, g);
        GLISSON_UNROLL
        for (int a = 0; a < 6; ++a) {
          const int n = shell_strip_nodes[j][a];
          f[n] = n >= (j == 0 ? 0 : 4 + 2 * j) ? g[a] : f[n] + g[a];
        }
      },
      [&](int tile) __attribute__((always_inline)) {
        unrolled<Shells::nodes>([&](auto a) __attribute__((always_inline)) {
          patches::store_nodes<W>(rows + (tile * Shells::nodes + a) * 4 * W, f[a]);
        });
      });
}

template <int W, class Shells>
GLISSON_FLATTEN double shell_energy(const Patch& patch, const Pass& pass) {
  using P = Pack<W>;
  double total = 0;
  over_shells<W, Shells>(
      patch, pass.local_rows,
      [&](auto, const auto& c, const Vec3<P>(&u)[6], int place) __attribute__((always_inline)) {
        const MaterialTile tile = material<W>(patch, pass, place);
        const Plane<P> strain = Shells::Element::plane_strain(c, u);
        P W_of_law;
        pass.law(&strain, &tile, &W_of_law);
        const P energy = c.volume * W_of_law + Shells::Element::bending_energy(c, u);
        total += patches::sum_of_lanes<W>(select(c.volume > P(0), energy, P(0)));
      },
      [](int) {});
  return total;
}

template <int W, template <class> class L>
constexpr ShellLawFunctions law_functions() {
  return {L<Pack<W>>::name,
          {stress_function<W, L, false>, stress_function<W, L, true>},
          {energy_function<W, L, false>, energy_function<W, L, true>}};
}
/// With its own kernels.
template <int W, template <class> class L>
constexpr ShellLawFunctions compiled_in() {
  ShellLawFunctions functions = law_functions<W, L>();
  functions.membrane_forces = membrane_forces<W, CompiledInLaw<W, L>>;
  functions.shell_forces = shell_forces<W, InnerShells, CompiledInLaw<W, L>>;
  return functions;
}

template <int W>
constexpr ShellKernels shell_kernels_of(const char* set) {
  ShellKernels k;
  k.set = set;
  k.membrane_forces = membrane_forces<W, AnyLaw<W>>;
  k.membrane_energy = membrane_energy<W>;
  k.shell_forces = shell_forces<W, InnerShells, AnyLaw<W>>;
  k.border_forces = shell_forces<W, BorderShells, AnyLaw<W>>;
  k.shell_energy = shell_energy<W, InnerShells>;
  k.border_energy = shell_energy<W, BorderShells>;
  k.laws[0] = compiled_in<W, Linear>();
  k.laws[1] = compiled_in<W, NeoHookean>();
  k.laws[2] = law_functions<W, NeoHookeanCompressible>();
  k.laws[3] = law_functions<W, Fung>();
  k.laws[4] = law_functions<W, TwoFibre>();
  return k;
}

}  // namespace glisson::shells
