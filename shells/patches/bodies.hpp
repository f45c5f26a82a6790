// The phases of patches of membranes and shells; the nodes and the sums are those of solids.
#pragma once

#include <bit>

#include <glisson/core/kernels/patch_bodies.hpp>
#include <glisson/shells/laws/tension_field.hpp>
#include <glisson/shells/relaxation.hpp>
#include <glisson/shells/shell_blocks.hpp>

namespace glisson::shells {

/// Numbers of the constants that every element reads. The images of a shell come after them and are read only
/// where a side has no neighbour.
template <class E, class R>
constexpr int numbers_always_read = sizeof(typename E::template Constants<R>) / sizeof(R);
template <class R>
constexpr int numbers_always_read<RotationFree, R> = sizeof(ShellPatch<R>) / sizeof(R);

/// Constants from [number][element_count].
template <class R, class E>
GLISSON_HD_INLINE typename E::template Constants<R> constants_of(const BlockView<R>& block, int e,
                                                                 bool images) {
  using Constants = typename E::template Constants<R>;
  constexpr int all = sizeof(Constants) / sizeof(R), always = numbers_always_read<E, R>;
  struct Values {
    R of[all];
  } values;
  const R* from = static_cast<const R*>(block.constants) + e;
  for (int k = 0; k < always; ++k) values.of[k] = from[std::size_t(k) * block.element_count];
  for (int k = always; k < all; ++k) values.of[k] = R(0);
  if (images)
    for (int k = always; k < all; ++k) values.of[k] = from[std::size_t(k) * block.element_count];
  return std::bit_cast<Constants>(values);
}

/// What the phases share.
template <class R, class E, class L>
struct ShellPatchBody : PatchBody<R, E> {
  PlaneHistory<R, R> history;
  L law;
  bool wrinkling;

  /// Whether some side has no neighbour: its image names the triangle's own node once more.
  GLISSON_HD bool has_images(int e) const {
    bool any = false;
    for (int a = 3; a < E::node_count; ++a) any = any || this->place(e, a) == this->place(e, a - 3);
    return any;
  }
  GLISSON_HD auto constants(int e) const { return constants_of<R, E>(this->patches.block, e, has_images(e)); }
};

template <class R, class E, class L>
struct ShellPatchForces : ShellPatchBody<R, E, L> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    const auto memory = patch_memory(this->patches, values);
    Vec3<R> u_e[E::node_count], f_e[E::node_count];
    this->gather(e, memory, u_e);
    const auto stress = [&](const Plane<R>& c) {
      const Plane<R> S = this->wrinkling ? tension_field_stress(this->law, c) : this->law.second_pk(c);
      return relaxed(this->history, e, S, this->step.store);
    };
    E::forces(this->constants(e), u_e, stress, f_e);
    this->put(t, f_e, memory);
  }
};

/// W of the law and of bending.
template <class R, class E, class L>
struct ShellPatchEnergy : ShellPatchBody<R, E, L> {
  GLISSON_HD void evaluate(int p, int t, R* values) const {
    const int e = this->element(p, t);
    if (e < 0) return;
    Vec3<R> u_e[E::node_count];
    this->gather(e, patch_memory(this->patches, values), u_e);
    const auto constants = this->constants(e);
    const Plane<R> c = E::plane_strain(constants, u_e);
    const R W = this->law.energy(this->wrinkling ? tension_field(this->law, c).c : c);
    this->patches.block.energy[e] =
        double(constants.volume) * double(W) + double(E::bending_energy(constants, u_e));
  }
  GLISSON_HD void sum(int, int, R*) const {}
};

}  // namespace glisson::shells
