// The phases of patches for each formulation and law. Ordinary C++: a device adds shared memory and barriers,
// the twin for tests runs the phases one after the other as loops.
#pragma once

#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/kernels/patch_view.hpp>

namespace glisson {

/// Whether constants are formed anew from rest positions. Those of elements with several integration points
/// do not fit into registers: they are read, E::Constants<R> [element_count].
template <class E>
constexpr bool forms_constants = E::point_count == 1;

/// What the phases of all bodies for elements E share.
template <class R, class E>
struct PatchBody {
  static constexpr int threads = patch_threads(E::node_count);
  /// Values of memory per patch.
  static constexpr std::size_t memory_size(int stride) { return PatchMemory<R>::size(stride); }
  PatchView<R> patches;
  PatchStep<R> step;

  /// Element of a thread, or -1.
  GLISSON_HD int element(int p, int t) const {
    const int e = patches.element_begin[p] + t;
    return e < patches.element_begin[p + 1] ? e : -1;
  }
  GLISSON_HD int place(int e, int a) const { return patches.corner[a * patches.block.element_count + e]; }
  GLISSON_HD void gather(int e, const PatchMemory<R>& memory, Vec3<R> (&u_e)[E::node_count]) const {
    for (int a = 0; a < E::node_count; ++a) {
      const int i = place(e, a);
      u_e[a] = {memory.u(0)[i], memory.u(1)[i], memory.u(2)[i]};
    }
  }
  GLISSON_HD void gather_rest(int e, const PatchMemory<R>& memory, Vec3<R> (&X_e)[E::node_count]) const {
    for (int a = 0; a < E::node_count; ++a) {
      const int i = place(e, a);
      X_e[a] = {memory.rest(0)[i], memory.rest(1)[i], memory.rest(2)[i]};
    }
  }
  GLISSON_HD decltype(auto) constants(int e, const PatchMemory<R>& memory) const {
    if constexpr (forms_constants<E>) {
      const RestView<R>& rest = patches.rest;
      Vec3<R> X_e[E::node_count];
      gather_rest(e, memory, X_e);
      const R stiffness = rest.hourglass ? rest.hourglass[e * rest.hourglass_stride] : R(0);
      return E::rest_constants(X_e, stiffness, rest.at_centre);
    } else {
      return (static_cast<const typename E::template Constants<R>*>(patches.block.constants)[e]);
    }
  }
  GLISSON_HD void put(int t, const Vec3<R> (&f_e)[E::node_count], const PatchMemory<R>& memory) const {
    for (int a = 0; a < E::node_count; ++a) {
      const int r = a * threads + t;
      memory.rows(0)[r] = f_e[a].x, memory.rows(1)[r] = f_e[a].y, memory.rows(2)[r] = f_e[a].z;
    }
  }
  GLISSON_HD void load(int p, int t, R* values) const {
    load_nodes(patches, step.u, p, t, threads, patch_memory(patches, values));
  }
  GLISSON_HD void sum(int p, int t, R* values) const {
    sum_forces(patches, step.f, p, t, threads, patch_memory(patches, values));
  }
};

template <class R, class E, class L, bool viscous>
struct PatchForces : PatchBody<R, E> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    const BlockView<R>& block = this->patches.block;
    const auto memory = patch_memory(this->patches, values);
    Vec3<R> u_e[E::node_count], f_e[E::node_count];
    this->gather(e, memory, u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = this->constants(e, memory);
    E::forces(c, u_e, PointStress<R, L, viscous>{block, law, e, this->step.store}, f_e);
    this->put(t, f_e, memory);
  }
};

template <class R, class E, class L>
struct PatchEnergy : PatchBody<R, E> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    const BlockView<R>& block = this->patches.block;
    const auto memory = patch_memory(this->patches, values);
    Vec3<R> u_e[E::node_count];
    this->gather(e, memory, u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = this->constants(e, memory);
    double sum = 0;
    E::points(c, u_e,
              [&](const Mat3<R>& H, R weight, int) { sum += double(weight) * double(law.energy(H)); });
    block.energy[e] = sum;
  }
  GLISSON_HD void sum(int, int, R*) const {}
};

template <class R, class E>
struct PatchHourglassEnergy : PatchBody<R, E> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    const auto memory = patch_memory(this->patches, values);
    Vec3<R> u_e[E::node_count];
    this->gather(e, memory, u_e);
    this->patches.block.energy[e] = double(E::hourglass_energy(this->constants(e, memory), u_e));
  }
  GLISSON_HD void sum(int, int, R*) const {}
};

/// Sweep 1 of T4ANP: p V of the elements, summed per node.
template <class R, class L>
struct PatchPressure : PatchBody<R, T4> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    const BlockView<R>& block = this->patches.block;
    const auto memory = patch_memory(this->patches, values);
    Vec3<R> u_e[4];
    this->gather(e, memory, u_e);
    const auto& c = this->constants(e, memory);
    memory.rows(0)[t] = c.volume * element_pressure(c, u_e, law_of<R, L>(block, e));
  }
  GLISSON_HD void sum(int p, int t, R* values) const {
    sum_pressure(this->patches, p, t, this->threads, patch_memory(this->patches, values));
  }
};

/// Sweep 2: what reads the mean pressure of the nodes.
template <class R>
struct AveragedPatchBody : PatchBody<R, T4> {
  GLISSON_HD void load(int p, int t, R* values) const {
    const auto memory = patch_memory(this->patches, values);
    load_nodes(this->patches, this->step.u, p, t, this->threads, memory);
    load_pressure(this->patches, p, t, this->threads, memory);
  }
  GLISSON_HD R mean_pressure(int e, const PatchMemory<R>& memory) const {
    R p = R(0);
    for (int a = 0; a < 4; ++a) p = p + memory.pressure()[this->place(e, a)];
    return R(0.25) * p;
  }
};

template <class R, class L, bool viscous>
struct PatchAveragedForces : AveragedPatchBody<R> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    const BlockView<R>& block = this->patches.block;
    const auto memory = patch_memory(this->patches, values);
    Vec3<R> u_e[4], f_e[4];
    this->gather(e, memory, u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = this->constants(e, memory);
    const R Jm_minus_1 = this->mean_pressure(e, memory) / law.bulk_modulus();
    const Mat3<R> H = averaged_gradient(T4::displacement_gradient(c, u_e), Jm_minus_1);
    T4::nodal_forces(c, PointStress<R, L, viscous>{block, law, e, this->step.store}(H, 0), f_e);
    this->put(t, f_e, memory);
  }
};

template <class R, class L>
struct PatchAveragedEnergy : AveragedPatchBody<R> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    const BlockView<R>& block = this->patches.block;
    const auto memory = patch_memory(this->patches, values);
    Vec3<R> u_e[4];
    this->gather(e, memory, u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = this->constants(e, memory);
    block.energy[e] = averaged_energy(c, u_e, law, this->mean_pressure(e, memory) / law.bulk_modulus());
  }
  GLISSON_HD void sum(int, int, R*) const {}
};

}  // namespace glisson
