// Loop bodies of membranes and shells: force per triangle, then a gather per node in a fixed order.
#pragma once

#include <glisson/shells/laws/tension_field.hpp>
#include <glisson/shells/relaxation.hpp>
#include <glisson/shells/shell_blocks.hpp>

namespace glisson::shells {

/// Arrays of one section in the backend's memory.
template <class R, class E, class L>
struct ShellView {
  const typename E::template Constants<R>* constants = nullptr;  ///< [element_count]
  const int* nodes = nullptr;    ///< internal [-]  [element_count][E::node_count]
  Vec4<R>* f_element = nullptr;  ///< [N]           [element_count][E::node_count]
  double* energy = nullptr;      ///< [J]           [element_count]
  PlaneHistory<R, R> history;
  L law;
  int element_count = 0;
  bool wrinkling = false;

  GLISSON_HD void gather(int e, const Vec4<R>* u, Vec3<R> (&u_e)[E::node_count]) const {
    for (int a = 0; a < E::node_count; ++a) {
      const Vec4<R> w = u[nodes[e * E::node_count + a]];
      u_e[a] = {w.x, w.y, w.z};
    }
  }
};

template <class R, class E, class L>
struct ShellForcesBody {
  ShellView<R, E, L> view;
  const Vec4<R>* u;  ///< [node_count]
  bool store;

  GLISSON_HD void operator()(int e) const {
    Vec3<R> u_e[E::node_count], f_e[E::node_count];
    view.gather(e, u, u_e);
    const auto stress = [&](const Plane<R>& c) {
      const Plane<R> S = view.wrinkling ? tension_field_stress(view.law, c) : view.law.second_pk(c);
      return relaxed(view.history, e, S, store);
    };
    E::forces(view.constants[e], u_e, stress, f_e);
    for (int a = 0; a < E::node_count; ++a)
      view.f_element[e * E::node_count + a] = {f_e[a].x, f_e[a].y, f_e[a].z, R(0)};
  }
};

/// W of the law and of bending.
template <class R, class E, class L>
struct ShellEnergyBody {
  ShellView<R, E, L> view;
  const Vec4<R>* u;

  GLISSON_HD void operator()(int e) const {
    Vec3<R> u_e[E::node_count];
    view.gather(e, u, u_e);
    const auto& constants = view.constants[e];
    const Plane<R> c = E::plane_strain(constants, u_e);
    const R W = view.law.energy(view.wrinkling ? tension_field(view.law, c).c : c);
    view.energy[e] = double(constants.volume) * double(W) + double(E::bending_energy(constants, u_e));
  }
};

/// f += sum over the slots of each node that shells push.
template <class R>
struct GatherShells {
  const int* nodes;  ///< internal                          [node_count]
  const int* begin;  ///< [node_count + 1]
  const int* slots;  ///< places in f_element, by element   [begin[node_count]]
  const Vec4<R>* f_element;
  Vec4<R>* f;
  GLISSON_HD void operator()(int i) const {
    Vec4<R> sum = f[nodes[i]];
    for (int k = begin[i]; k < begin[i + 1]; ++k) {
      const Vec4<R> g = f_element[slots[k]];
      sum.x = sum.x + g.x, sum.y = sum.y + g.y, sum.z = sum.z + g.z;
    }
    f[nodes[i]] = sum;
  }
};

}  // namespace glisson::shells
