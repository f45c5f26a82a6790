#include <glisson/contact/bvh/solid_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glisson/contact/bvh/box.hpp>
#include <glisson/contact/geometry/closest_points.hpp>
#include <glisson/core/mesh/triangles.hpp>

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
    : triangles_(std::move(triangles)), solid_(std::move(solid)), x_(std::move(x)) {
  const TriangleSizes sizes = triangle_sizes(triangles_, x_);
  if (sizes.largest > 0) width_ = sizes.largest;
  aside_ = {3.7e-5 * sizes.smallest, 2.3e-5 * sizes.smallest, 0};
  make_columns();
}

void SolidSearch::make_columns() {
  constexpr int most = 1000;  // across and along
  std::vector<Box> boxes(triangles_.size());
  Box all;
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    for (const int n : triangles_[t]) boxes[t] = united(boxes[t], x_[at(n)]);
    all = united(all, boxes[t]);
  }
  if (boxes.empty()) all = Box{{}, {}};
  low_ = all.low;
  const Vec3<double> size = all.high - all.low;
  width_ = std::max(width_, std::max(size.x, size.y) / most);
  across_ = static_cast<int>(size.x / width_) + 1;
  along_ = static_cast<int>(size.y / width_) + 1;
  std::vector<std::array<int, 2>> pairs;  // column, triangle
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (int j = column_at(low_.y, boxes[t].low.y, along_); j <= column_at(low_.y, boxes[t].high.y, along_);
         ++j)
      for (int i = column_at(low_.x, boxes[t].low.x, across_);
           i <= column_at(low_.x, boxes[t].high.x, across_); ++i)
        pairs.push_back({j * across_ + i, static_cast<int>(t)});
  std::sort(pairs.begin(), pairs.end());
  column_begin_.assign(at(across_ * along_) + 1, 0);
  for (const auto& [column, t] : pairs) {
    ++column_begin_[at(column) + 1];
    column_.push_back(t);
  }
  for (std::size_t c = 1; c < column_begin_.size(); ++c) column_begin_[c] += column_begin_[c - 1];
}

int SolidSearch::column_at(double from, double at, int count) const {
  return static_cast<int>(std::clamp(std::floor((at - from) / width_), 0.0, count - 1.0));
}

template <class Use>
void SolidSearch::near_columns(const Vec3<double>& p, double radius, const Use& use) const {
  const int i0 = column_at(low_.x, p.x - radius, across_), i1 = column_at(low_.x, p.x + radius, across_);
  const int j0 = column_at(low_.y, p.y - radius, along_), j1 = column_at(low_.y, p.y + radius, along_);
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i)
      for (int k = column_begin_[at(j * across_ + i)]; k < column_begin_[at(j * across_ + i + 1)]; ++k)
        use(column_[at(k)]);
}

std::vector<int> SolidSearch::around(const Vec3<double>& point, const Wanted& wanted) const {
  const Vec3<double> p = point + aside_;
  std::map<int, int> turns;
  near_columns(p, 0, [&](int t) {
    const Triangle& c = triangles_[at(t)];
    if (const int way = ray_crosses(p, x_[at(c[0])], x_[at(c[1])], x_[at(c[2])]); way != 0 && wanted(t))
      turns[solid_[at(t)]] += way;
  });
  std::vector<int> result;
  for (const auto& [solid, sum] : turns)
    if (sum > 0) result.push_back(solid);
  return result;
}

SolidSearch::Nearest SolidSearch::nearest(const Vec3<double>& p, int solid) const {
  const double all = width_ * (across_ + along_);
  for (double radius = width_;; radius *= 2) {
    double least = std::numeric_limits<double>::infinity();
    int closest = -1;
    near_columns(p, radius, [&](int t) {
      if (solid_[at(t)] != solid) return;
      if (const double d = distance(p, t); d < least) least = d, closest = t;
    });
    if (closest >= 0 && (least <= radius || radius > all)) return {least, longest_edge(closest)};
  }
}

double SolidSearch::distance(const Vec3<double>& p, int triangle) const {
  const Triangle& c = triangles_[at(triangle)];
  return std::sqrt(closest_on_triangle(p, x_[at(c[0])], x_[at(c[1])], x_[at(c[2])]).distance_squared);
}

double SolidSearch::longest_edge(int triangle) const {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto edge = x_[at(triangles_[at(triangle)][k])] - x_[at(triangles_[at(triangle)][(k + 1) % 3])];
    longest = std::max(longest, std::sqrt(dot(edge, edge)));
  }
  return longest;
}

}  // namespace glisson::contact
