// The phases of patches of membranes and shells. Most constants of a triangle are formed anew from the rest
// positions of its nodes, which a patch reads once: memory is what bounds these kernels, not arithmetic.
#pragma once

#include <glisson/core/kernels/patch_bodies.hpp>
#include <glisson/shells/laws/tension_field.hpp>
#include <glisson/shells/patches/section_rest.hpp>
#include <glisson/shells/relaxation.hpp>

namespace glisson::shells {

/// What the phases share.
template <class R, class E, class L>
struct ShellPatchBody : PatchBody<R, E> {
  using Constants = typename E::template Constants<R>;
  SectionRest<R> rest;
  PlaneHistory<R, R> history;
  L law;
  bool wrinkling;

  /// Values of memory per patch: after those of solids the rest positions by axis.
  static constexpr std::size_t memory_size(int stride) {
    return PatchMemory<R>::size(stride) + 3 * std::size_t(stride);
  }
  GLISSON_HD R* rest_position(R* values, int axis) const {
    return values + PatchMemory<R>::size(this->patches.stride) + axis * this->patches.stride;
  }
  GLISSON_HD void load(int p, int t, R* values) const {
    PatchBody<R, E>::load(p, t, values);
    const int first = this->patches.node_begin[p], count = this->patches.node_begin[p + 1] - first;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = t; i < count; i += this->threads)
        rest_position(values, axis)[i] = rest.X[axis * rest.place_count + first + i];
  }
  /// use.template operator()<element>(constants, u_e) for a triangle; most shells have no images and need no
  /// arithmetic for them.
  template <class Use>
  GLISSON_HD_INLINE void with_constants(int e, R* values, const Use& use) const {
    const auto memory = patch_memory(this->patches, values);
    const R *x = rest_position(values, 0), *y = rest_position(values, 1), *z = rest_position(values, 2);
    Vec3<R> X[E::node_count], u[E::node_count];
    int place[E::node_count];
    bool images = false;
    for (int a = 0; a < E::node_count; ++a) {
      const int i = place[a] = this->place(e, a);
      u[a] = {memory.u(0)[i], memory.u(1)[i], memory.u(2)[i]};
      X[a] = {x[i], y[i], z[i]};
      if (a >= 3) images = images || i == place[a - 3];
    }
    if constexpr (E::node_count == 3)
      use.template operator()<E>(rest.membrane(e, X), u);
    else if (images)
      use.template operator()<E>(rest.template shell<RotationFree::Constants<R>>(e, X), u);
    else
      use.template operator()<RotationFreeInner>(rest.template shell<ShellPatch<R>>(e, X), u);
  }
};

template <class R, class E, class L>
struct ShellPatchForces : ShellPatchBody<R, E, L> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    const auto stress = [&](const Plane<R>& c) {
      const Plane<R> S = this->wrinkling ? tension_field_stress(this->law, c) : this->law.second_pk(c);
      return relaxed(this->history, e, S, this->step.store);
    };
    Vec3<R> f_e[E::node_count];
    this->with_constants(e, values, [&]<class Own>(const auto& constants, const Vec3<R>(&u)[E::node_count]) {
      Own::forces(constants, u, stress, f_e);
    });
    this->put(t, f_e, patch_memory(this->patches, values));
  }
};

/// W of the law and of bending.
template <class R, class E, class L>
struct ShellPatchEnergy : ShellPatchBody<R, E, L> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    double& energy = this->patches.block.energy[e];
    this->with_constants(e, values, [&]<class Own>(const auto& constants, const Vec3<R>(&u)[E::node_count]) {
      const Plane<R> c = Own::plane_strain(constants, u);
      const R W = this->law.energy(this->wrinkling ? tension_field(this->law, c).c : c);
      energy = double(constants.volume) * double(W) + double(Own::bending_energy(constants, u));
    });
  }
  GLISSON_HD void sum(int, int, R*) const {}
};

}  // namespace glisson::shells
