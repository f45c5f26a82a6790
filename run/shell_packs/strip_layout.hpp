// Which nodes of a lane belong to which triangle of its strip.
#pragma once

namespace glisson::shells {

/// Membranes: triangle j has the nodes j, j + 1, j + 2.
constexpr int triangles_per_strip = 3, corners_of_strip = triangles_per_strip + 2;

/// Shells: three corners and the nodes across the sides, of which neighbours in the strip are two; a strip
/// of one has the first 6, of two the first 8.
constexpr int nodes_of_shell_strip = 10;
constexpr int shell_strip_nodes[triangles_per_strip][6] = {
    {0, 1, 2, 3, 4, 5}, {1, 2, 3, 6, 7, 0}, {2, 3, 6, 8, 9, 1}};

}  // namespace glisson::shells
