// The stable step of single elements, in closed form: with lumped mass the largest frequency of a mesh is
// never above the largest of its elements' (Belytschko et al. 2014, ch. 6), so this is a safe step at rest.
#pragma once

#include <functional>
#include <limits>

#include <glisson/core/model.hpp>

namespace glisson {

struct StableStep {
  /// 2 / omega_max of the element [s]: exact for T4 and parallelepiped H8, a bound from below for others.
  double dt = std::numeric_limits<double>::infinity();
  int element = -1;   ///< user's number; -1: none, or a triangle
  int triangle = -1;  ///< of membranes and shells, when it is the one that bounds the step
  double smallest_size =
      std::numeric_limits<double>::infinity();  ///< of any element: V / largest facet-like area [m]
};

/// visit(element, its stable step [s], its volume [m^3], its size [m], its density) for all elements of all
/// sections, by section.
void visit_element_steps(const Model& model,
                         const std::function<void(int, double, double, double, double)>& visit);

/// The smallest of them.
StableStep element_stable_step(const Model& model);

}  // namespace glisson
