// Which closed surfaces a point lies in, by a ray through a hierarchy.
#pragma once

#include <functional>
#include <vector>

#include <glisson/contact/bvh/hierarchy.hpp>

namespace glisson::contact {

class SolidSearch {
 public:
  /// solid: of each triangle; those of one are closed and face outwards.
  SolidSearch(std::vector<Triangle> triangles, std::vector<int> solid, std::vector<Vec3<double>> x);

  using Wanted = std::function<bool(int triangle)>;
  /// Those of the wanted triangles' solids that p lies in, rising. Rounding decides near a surface.
  std::vector<int> around(const Vec3<double>& p, const Wanted& wanted);
  /// Whether a triangle of the solid is as near as this.
  bool is_near(const Vec3<double>& p, int solid, double distance);
  /// Distance to the nearest triangle of the solid; looks at all of them.
  double distance(const Vec3<double>& p, int solid) const;

 private:
  double distance_squared(const Vec3<double>& p, int triangle) const;

  std::vector<Triangle> triangles_;
  std::vector<int> solid_;
  std::vector<Vec3<double>> x_;
  Hierarchy hierarchy_;
  Vec3<double> aside_;  ///< keeps rays off the edges of regular meshes [m]
  std::vector<int> found_, stack_;
};

}  // namespace glisson::contact
