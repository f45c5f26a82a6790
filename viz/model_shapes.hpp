// What of a simulation file is drawn beside the results: rigid bodies where they are at a time, and marks for
// boundary conditions.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::viz {

struct Body {
  std::string name;
  std::vector<Vec3<double>> X;  ///< [m]
  std::vector<std::array<int, 3>> triangles;
};
/// Analytic bodies, then surface meshes. Cylinders, and probes at their start, have a rim instead of a lid:
/// they are open.
std::vector<Body> bodies_at(const Model& model, double time);

enum class MarkKind { fixed, prescribed, force, pressure, sliding };
constexpr int mark_kinds = 5;
const char* name_of(MarkKind kind);

struct Mark {
  MarkKind kind = MarkKind::fixed;
  Vec3<double> at;         ///< [m]
  Vec3<double> direction;  ///< unit, or 0: none
};

/// x: current positions [m] [node_count]. Marks of a kind are thinned out to one per cube of edge `spacing`
/// [m].
std::vector<Mark> marks_of(const Model& model, std::span<const Vec3<double>> x, double spacing);

}  // namespace glisson::viz
