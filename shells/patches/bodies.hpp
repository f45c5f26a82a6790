// The phases of patches of membranes and shells. Most constants of a triangle are formed anew from the rest
// positions of its nodes, as those of solids (RestView).
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

  /// use.template operator()<element>(constants, u_e) for a triangle; most shells have no images and need no
  /// arithmetic for them.
  template <class Use>
  GLISSON_HD_INLINE void with_constants(int e, R* values, const Use& use) const {
    const auto memory = patch_memory(this->patches, values);
    Vec3<R> X[E::node_count], u[E::node_count];
    this->gather(e, memory, u);
    this->gather_rest(e, memory, X);
    bool images = false;
    for (int a = 3; a < E::node_count; ++a) images = images || this->place(e, a) == this->place(e, a - 3);
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
