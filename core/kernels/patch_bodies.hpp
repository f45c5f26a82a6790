// The phases of patches for each formulation and law. Ordinary C++: a device adds shared memory and barriers,
// the twin for tests runs the phases one after the other as loops.
#pragma once

#include <bit>

#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/kernels/patch_view.hpp>

namespace glisson {

/// Whether constants are stored [constant][element_count], so that the loads of neighbouring threads are one,
/// and copied into registers. More than these do not fit and would be indexed by the integration point: they
/// stay E::Constants<R> [element_count].
template <class E>
constexpr bool interleaved_constants = E::constant_count <= 40;

template <class R, class E>
GLISSON_HD decltype(auto) patch_constants(const BlockView<R>& block, int e) {
  using Constants = typename E::template Constants<R>;
  if constexpr (interleaved_constants<E>) {
    struct Values {
      R of[E::constant_count];
    } values;
    const R* from = static_cast<const R*>(block.constants) + e;
    for (int k = 0; k < E::constant_count; ++k) values.of[k] = from[std::size_t(k) * block.element_count];
    return std::bit_cast<Constants>(values);
  } else {
    return (static_cast<const Constants*>(block.constants)[e]);
  }
}

/// What the phases of all bodies for elements E share.
template <class R, class E>
struct PatchBody {
  static constexpr int threads = patch_threads(E::node_count);
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
    const auto& c = patch_constants<R, E>(block, e);
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
    Vec3<R> u_e[E::node_count];
    this->gather(e, patch_memory(this->patches, values), u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = patch_constants<R, E>(block, e);
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
    const BlockView<R>& block = this->patches.block;
    Vec3<R> u_e[E::node_count];
    this->gather(e, patch_memory(this->patches, values), u_e);
    block.energy[e] = double(E::hourglass_energy(patch_constants<R, E>(block, e), u_e));
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
    const auto& c = patch_constants<R, T4>(block, e);
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
    const auto& c = patch_constants<R, T4>(block, e);
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
    const auto& c = patch_constants<R, T4>(block, e);
    block.energy[e] = averaged_energy(c, u_e, law, this->mean_pressure(e, memory) / law.bulk_modulus());
  }
  GLISSON_HD void sum(int, int, R*) const {}
};

}  // namespace glisson
