// Divides a connected patch of triangles into two connected halves.
#pragma once

#include <utility>
#include <vector>

#include <glisson/contact/bvh/hierarchy.hpp>

namespace glisson::contact::detail {

/// What the division looks at, of all triangles.
struct PatchData {
  std::vector<Box> box;  ///< inflated, so that flat patches have a volume
  std::vector<NormalCone> cone;
  std::vector<Vec3<double>> centre;  ///< [m]
  std::vector<std::array<int, 3>> neighbours;
  HierarchySettings settings;
};

/// Grows two halves from triangles that lie far apart; in turn each takes the unassigned neighbour that makes
/// it cheapest (Johnsen 2016, eq. 5.7). The seed takes the farthest pair of centroids; here it is found by
/// two sweeps, which costs O(n) and may give a pair that is a little closer. `mark` is scratch, -1
/// everywhere, of one entry per triangle. The patch has two triangles at least.
std::pair<std::vector<int>, std::vector<int>> split_patch(const PatchData& data,
                                                          const std::vector<int>& patch,
                                                          std::vector<int>& mark);

}  // namespace glisson::contact::detail
