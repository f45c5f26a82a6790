// Cones that hold the surface normals of a patch: an edge-connected patch whose cone opens by less than pi
// does not touch itself, unless its border does (Volino & Magnenat-Thalmann 1994; Johnsen 2016, eq. 5.2-5.6).
#pragma once

#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

constexpr double full_turn = 6.283185307179586;

struct NormalCone {
  Vec3<double> axis;  ///< unit; of no meaning when the angle is a full turn or the cone is empty
  double angle = -1;  ///< opening angle, twice the largest angle to the axis [rad]; -1: empty
};

/// A cone that excludes nothing: of patches that are not connected or have facets without area.
constexpr NormalCone any_direction{{}, full_turn};

enum class ConeRule {
  narrowest,        ///< Johnsen 2016, eq. 5.4-5.6, or one of the two if it holds the other
  provot,           ///< axis: the mean of both axes (Provot 1997), for comparison
  provot_or_child,  ///< the same, or one of the two if it holds the other, for comparison
};

/// Holds both cones.
NormalCone merged(const NormalCone& a, const NormalCone& b, ConeRule rule = ConeRule::narrowest);

/// The cone of one facet with the normal n of any length.
NormalCone cone_of(const Vec3<double>& n);

}  // namespace glisson::contact
