// Distance from points to a surface of triangles and quadrilaterals, for choosing nodes near an organ's
// neighbour.
#pragma once

#include <glisson/core/mesh/mesh.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace glisson {

/// Closest point of triangle abc to p, by the regions of its vertices, edges and face (Ericson 2005,
/// section 5.1.5).
Vec3<double> closest_point(const Vec3<double>& p, const Vec3<double>& a, const Vec3<double>& b,
                           const Vec3<double>& c);

/// Answers "is x within `reach` of the surface" with a grid of cells that list the triangles near them.
class SurfaceDistance {
 public:
  /// `reach` [m] is the largest distance that will be asked for; > 0. Throws Error(input) for a surface
  /// without facets.
  SurfaceDistance(const SurfaceMesh& surface, double reach);

  /// distance <= reach
  bool within(const Vec3<double>& x, double reach) const;

 private:
  using Triangle = std::array<Vec3<double>, 3>;
  struct Range {
    std::array<int, 3> low, high;  ///< cells, inclusive
  };
  void add_triangles(const SurfaceMesh& surface);
  bool fill_cells();
  Range cells_near(const Triangle& triangle) const;
  std::int64_t cell_index(int i, int j, int k) const {
    return (static_cast<std::int64_t>(k) * count_[1] + j) * count_[0] + i;
  }

  double reach_, cell_ = 1;
  Vec3<double> low_, high_;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<Triangle> triangles_;
  std::vector<std::int64_t> begin_;  ///< first entry in near_ of each cell
  std::vector<std::int32_t> near_;   ///< triangles whose bounding box, grown by reach, meets the cell
};

}  // namespace glisson
