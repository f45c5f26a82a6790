// Constraints of a model as one list of nodes in the engine's order; host data.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/numbering.hpp>

namespace glisson {

/// One prescribed value of a node: u_axis += amplitude(curve) value on each of the axes.
struct PrescribedValue {
  int curve = 0;  ///< index into ConstraintList::curves [-]
  Axes axes = 0;
  double value = 0;  ///< at amplitude 1 [m]
};

/// Removes the part of u along `normal` by a move along `direction` = d / (n . d), which keeps the
/// constraints that were applied before: d is the part of n in the directions that are still free.
struct PlaneProjection {
  Vec3<double> normal, direction;
};

/// Every constrained node once. Order of application on a node: constrained axes are zeroed, prescribed
/// values added (they beat a Fix and add up), then planes. A plane normal that no free direction is left for
/// is dropped.
struct ConstraintList {
  std::vector<int> nodes;        ///< internal, increasing [-]  [count]
  std::vector<unsigned> axes;    ///< fixed or prescribed axes  [count]
  std::vector<int> value_begin;  ///< [count + 1]
  std::vector<PrescribedValue> values;
  std::vector<int> plane_begin;  ///< [count + 1]
  std::vector<PlaneProjection> planes;
  std::vector<LoadCurve> curves;  ///< without duplicates

  int count() const { return static_cast<int>(nodes.size()); }
};

ConstraintList make_constraint_list(const Model& model, const Numbering& numbering);

/// Initial velocities [m/s] in internal order [node_count]; a node in several entries gets the last one.
std::vector<Vec3<double>> initial_velocity(const Model& model, const Numbering& numbering);

}  // namespace glisson
