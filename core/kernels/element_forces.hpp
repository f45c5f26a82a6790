// Loop bodies of the solid elements, plain form: one element per index, forces into a buffer per element,
// then one gather per node in a fixed order. Every backend can launch them; they are the definition that
// faster forms are compared with.
#pragma once

#include <glisson/core/materials/prony.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// Arrays of one block of elements with the same formulation, law and Prony terms. All in the backend's
/// memory.
template <class R>
struct BlockView {
  const void* constants = nullptr;  ///< E::Constants<R>                                  [element_count]
  const int* nodes = nullptr;       ///< internal node numbers [-] [element_count][node_count]
  const R* parameters =
      nullptr;  ///< of the law                                       [element_count or 1][parameter_count]
  const PronyCoefficients<R>* terms = nullptr;  ///< [isochoric + volumetric]
  R* history = nullptr;  ///< Y [Pa]                                           [point][term][6][element_count]
  Vec4<R>* f_element = nullptr;       ///< force of each element on its nodes [N] [element_count][node_count]
  R* volume_change = nullptr;         ///< T4ANP: kappa (J - 1) of the element [Pa]         [element_count]
  const R* nodal_pressure = nullptr;  ///< T4ANP: mean pressure of the node [Pa]            [mesh node_count]
  double* energy = nullptr;           ///< [J]                                              [element_count]
  int element_count = 0;
  int isochoric_count = 0, volumetric_count = 0;
  bool per_element = false;  ///< parameters differ between elements
};

/// What one evaluation needs of the step.
template <class R>
struct EvaluationView {
  const Vec4<R>* u = nullptr;  ///< [m]  [mesh node_count]
  bool store = true;           ///< advance the Prony history
};

template <class R, class E>
GLISSON_HD void gather(const int* nodes, int e, const Vec4<R>* u, Vec3<R> (&u_e)[E::node_count]) {
  for (int a = 0; a < E::node_count; ++a) {
    const Vec4<R> w = u[nodes[e * E::node_count + a]];
    u_e[a] = {w.x, w.y, w.z};
  }
}

template <class R, class L>
GLISSON_HD L law_of(const BlockView<R>& block, int e) {
  return L::load(block.parameters + (block.per_element ? e * L::parameter_count : 0));
}

/// P of a block's material at one point.
template <class R, class L, bool viscous>
struct PointStress {
  const BlockView<R>& block;
  const L& law;
  int e;
  bool store;
  GLISSON_HD Mat3<R> operator()(const Mat3<R>& H, int p) const {
    if constexpr (viscous) {
      const int count = block.isochoric_count + block.volumetric_count;
      const StridedHistory<R> history{block.history + std::size_t(p) * 6 * count * block.element_count + e,
                                      block.element_count};
      const PronyTerms<R> prony{block.terms, block.isochoric_count, block.volumetric_count};
      return first_pk_relaxed(law, H, prony, history, store);
    } else {
      return law.first_pk(H);
    }
  }
};

template <class R, class E, class L, bool viscous>
struct ElementForces {
  BlockView<R> block;
  EvaluationView<R> now;
  GLISSON_HD void operator()(int e) const {
    Vec3<R> u_e[E::node_count], f_e[E::node_count];
    gather<R, E>(block.nodes, e, now.u, u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = static_cast<const typename E::template Constants<R>*>(block.constants)[e];
    E::forces(c, u_e, PointStress<R, L, viscous>{block, law, e, now.store}, f_e);
    for (int a = 0; a < E::node_count; ++a)
      block.f_element[e * E::node_count + a] = {f_e[a].x, f_e[a].y, f_e[a].z, R(0)};
  }
};

template <class R, class E, class L>
struct ElementEnergy {
  BlockView<R> block;
  EvaluationView<R> now;
  GLISSON_HD void operator()(int e) const {
    Vec3<R> u_e[E::node_count];
    gather<R, E>(block.nodes, e, now.u, u_e);
    const L law = law_of<R, L>(block, e);
    const auto& c = static_cast<const typename E::template Constants<R>*>(block.constants)[e];
    double sum = 0;
    E::points(c, u_e,
              [&](const Mat3<R>& H, R weight, int) { sum += double(weight) * double(law.energy(H)); });
    block.energy[e] = sum;
  }
};

template <class R, class E>
struct ElementHourglassEnergy {
  BlockView<R> block;
  EvaluationView<R> now;
  GLISSON_HD void operator()(int e) const {
    Vec3<R> u_e[E::node_count];
    gather<R, E>(block.nodes, e, now.u, u_e);
    block.energy[e] = double(
        E::hourglass_energy(static_cast<const typename E::template Constants<R>*>(block.constants)[e], u_e));
  }
};

/// f += sum of element forces, in the order of the incidence list.
template <class R>
struct GatherForces {
  const int* begin;  ///< [mesh node_count + 1]
  const int* slot;   ///< places in f_element, by element [begin.back()]
  const Vec4<R>* f_element;
  Vec4<R>* f;
  GLISSON_HD void operator()(int n) const {
    Vec4<R> sum = f[n];
    for (int k = begin[n]; k < begin[n + 1]; ++k) {
      const Vec4<R> g = f_element[slot[k]];
      sum.x = sum.x + g.x, sum.y = sum.y + g.y, sum.z = sum.z + g.z;
    }
    f[n] = sum;
  }
};

}  // namespace glisson
