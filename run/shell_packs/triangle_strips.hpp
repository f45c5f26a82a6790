// Which triangles share a lane, and how their constants follow.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glisson/shells/elements/membrane.hpp>
#include <glisson/shells/elements/rotation_free.hpp>

namespace glisson::shells {

/// A triangle of a strip: its number, and which of its corners is first, second, third there.
struct TurnedTriangle {
  int number = -1;  ///< -1: none
  std::array<int, 3> corner{};
};
using TriangleStrip = std::array<TurnedTriangle, 3>;

/// Each of `triangles` [nodes] in one strip, whose consecutive triangles share two nodes: strip nodes 1, 2
/// are the first two of triangle 1, and so on. Strips lie in the order of their first triangles.
std::vector<TriangleStrip> triangle_strips(std::span<const std::array<int, 3>> triangles);

/// Constants for corners in another order. The axes in the plane stay; the normal may turn over, and the
/// curvatures and moments with it.
Membrane::Constants<double> turned(const Membrane::Constants<double>& c, const std::array<int, 3>& corner);
ShellPatch<double> turned(const ShellPatch<double>& c, const std::array<int, 3>& corner);

}  // namespace glisson::shells
