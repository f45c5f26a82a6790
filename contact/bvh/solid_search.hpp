// Which closed surfaces a point lies in, by a ray along z through columns of triangles: made faster than a
// hierarchy, for a few questions.
#pragma once

#include <functional>
#include <vector>

#include <glisson/contact/geometry/triangles.hpp>

namespace glisson::contact {

class SolidSearch {
 public:
  /// solid: of each triangle; those of one are closed and face outwards.
  SolidSearch(std::vector<Triangle> triangles, std::vector<int> solid, std::vector<Vec3<double>> x);

  using Wanted = std::function<bool(int triangle)>;
  /// Those of the wanted triangles' solids that p lies in, rising. Rounding decides near a surface.
  std::vector<int> around(const Vec3<double>& p, const Wanted& wanted) const;
  struct Nearest {
    double distance;  ///< [m]
    double edge;      ///< the longest one of that triangle [m]
  };
  /// Triangle of a solid that has one.
  Nearest nearest(const Vec3<double>& p, int solid) const;

 private:
  void make_columns();
  int column_at(double from, double at, int count) const;
  /// use(triangle) for those over the columns around p, some more than once.
  template <class Use>
  void near_columns(const Vec3<double>& p, double radius, const Use& use) const;
  double distance(const Vec3<double>& p, int triangle) const;
  double longest_edge(int triangle) const;

  std::vector<Triangle> triangles_;
  std::vector<int> solid_;
  std::vector<Vec3<double>> x_;
  double width_ = 1;                        ///< of a column [m]
  Vec3<double> aside_;                      ///< keeps rays off the edges of regular meshes [m]
  Vec3<double> low_;                        ///< of all triangles [m]
  int across_ = 1, along_ = 1;              ///< columns in x and y
  std::vector<int> column_begin_, column_;  ///< triangles over each column
};

}  // namespace glisson::contact
