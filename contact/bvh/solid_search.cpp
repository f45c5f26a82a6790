#include <glisson/contact/bvh/solid_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glisson/contact/bvh/pairs.hpp>
#include <glisson/contact/geometry/closest_points.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// 1 where the ray from p along z leaves through the triangle, -1 where it enters, else 0.
int ray_crosses(const Vec3<double>& p, const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  const auto side = [&](const Vec3<double>& u, const Vec3<double>& v) {
    return (v.x - u.x) * (p.y - u.y) - (v.y - u.y) * (p.x - u.x);
  };
  const double s = side(a, b), t = side(b, c), w = side(c, a), area = s + t + w;
  const bool up = s > 0 && t > 0 && w > 0, down = s < 0 && t < 0 && w < 0;
  if (!up && !down) return 0;
  if (!((t * a.z + w * b.z + s * c.z) / area > p.z)) return 0;
  return up ? 1 : -1;
}

}  // namespace

SolidSearch::SolidSearch(std::vector<Triangle> triangles, std::vector<int> solid, std::vector<Vec3<double>> x)
    : triangles_(std::move(triangles)),
      solid_(std::move(solid)),
      x_(std::move(x)),
      hierarchy_(build_hierarchy(triangles_, x_, {})) {
  const double size = triangle_sizes(triangles_, x_).smallest;
  aside_ = {3.7e-5 * size, 2.3e-5 * size, 0};
}

std::vector<int> SolidSearch::around(const Vec3<double>& point, const Wanted& wanted) {
  const Vec3<double> p = point + aside_;
  Vec3<double> end = p;
  end.z = std::numeric_limits<double>::infinity();
  triangles_near(hierarchy_, Box{p, end}, found_, stack_);
  std::map<int, int> turns;
  for (const int t : found_) {
    const Triangle& c = triangles_[at(t)];
    if (const int way = ray_crosses(p, x_[at(c[0])], x_[at(c[1])], x_[at(c[2])]); way != 0 && wanted(t))
      turns[solid_[at(t)]] += way;
  }
  std::vector<int> result;
  for (const auto& [solid, sum] : turns)
    if (sum > 0) result.push_back(solid);
  return result;
}

bool SolidSearch::is_near(const Vec3<double>& p, int solid, double distance) {
  triangles_near(hierarchy_, inflated(Box{p, p}, distance), found_, stack_);
  return std::any_of(found_.begin(), found_.end(), [&](int t) {
    return solid_[at(t)] == solid && distance_squared(p, t) <= distance * distance;
  });
}

double SolidSearch::distance(const Vec3<double>& p, int solid) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
    if (solid_[at(t)] == solid) nearest = std::min(nearest, distance_squared(p, t));
  return std::sqrt(nearest);
}

double SolidSearch::distance_squared(const Vec3<double>& p, int triangle) const {
  const Triangle& c = triangles_[at(triangle)];
  return closest_on_triangle(p, x_[at(c[0])], x_[at(c[1])], x_[at(c[2])]).distance_squared;
}

}  // namespace glisson::contact
