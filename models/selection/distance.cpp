#include <glisson/models/selection/distance.hpp>

#include <glisson/core/base/error.hpp>

#include <algorithm>
#include <cmath>

namespace glisson {
namespace {

constexpr int cells_along_longest = 48;

template <class Choose>
Vec3<double> componentwise(const Vec3<double>& a, const Vec3<double>& b, Choose choose) {
  return {choose(a.x, b.x), choose(a.y, b.y), choose(a.z, b.z)};
}
Vec3<double> lower(const Vec3<double>& a, const Vec3<double>& b) {
  return componentwise(a, b, [](double x, double y) { return std::min(x, y); });
}
Vec3<double> upper(const Vec3<double>& a, const Vec3<double>& b) {
  return componentwise(a, b, [](double x, double y) { return std::max(x, y); });
}

}  // namespace

Vec3<double> closest_point(const Vec3<double>& p, const Vec3<double>& a, const Vec3<double>& b,
                           const Vec3<double>& c) {
  const auto ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 > d3 ? d1 / (d1 - d3) : 0.0) * ab;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 > d6 ? d2 / (d2 - d6) : 0.0) * ac;
  const double va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0)
    return b + (along + back > 0 ? along / (along + back) : 0.0) * (c - b);
  const double sum = va + vb + vc;
  return a + (vb / sum) * ab + (vc / sum) * ac;
}

SurfaceDistance::SurfaceDistance(const SurfaceMesh& surface, double reach) : reach_(reach) {
  if (surface.facets.empty() || surface.X.empty())
    throw Error(ErrorKind::input, "the surface has no facets, so nothing has a distance to it");
  add_triangles(surface);
  const Vec3<double> margin{reach, reach, reach};
  low_ = low_ - margin;
  high_ = high_ + margin;
  const Vec3<double> extent = high_ - low_;
  cell_ = std::max(std::max({extent.x, extent.y, extent.z}) / cells_along_longest, reach);
  while (!fill_cells()) cell_ *= 2;
}

void SurfaceDistance::add_triangles(const SurfaceMesh& surface) {
  low_ = high_ = surface.X.at(static_cast<std::size_t>(surface.facets[0].nodes[0]));
  for (const auto& facet : surface.facets) {
    const auto at = [&](std::size_t a) { return surface.X.at(static_cast<std::size_t>(facet.nodes[a])); };
    triangles_.push_back({at(0), at(1), at(2)});
    if (facet.node_count() == 4) triangles_.push_back({at(0), at(2), at(3)});
    for (std::size_t a = 0; a < static_cast<std::size_t>(facet.node_count()); ++a) {
      low_ = lower(low_, at(a));
      high_ = upper(high_, at(a));
    }
  }
}

SurfaceDistance::Range SurfaceDistance::cells_near(const Triangle& t) const {
  const Vec3<double> margin{reach_, reach_, reach_};
  const auto from = lower(lower(t[0], t[1]), t[2]) - margin - low_;
  const auto to = upper(upper(t[0], t[1]), t[2]) + margin - low_;
  const auto cell = [&](double offset, int axis) {
    return static_cast<int>(std::clamp(offset / cell_, 0.0, count_[static_cast<std::size_t>(axis)] - 1.0));
  };
  return {{cell(from.x, 0), cell(from.y, 1), cell(from.z, 2)}, {cell(to.x, 0), cell(to.y, 1), cell(to.z, 2)}};
}

// False when the lists would be long for the number of triangles: the cells are too small.
bool SurfaceDistance::fill_cells() {
  const Vec3<double> extent = high_ - low_;
  const std::array<double, 3> lengths{extent.x, extent.y, extent.z};
  for (std::size_t i = 0; i < 3; ++i)
    count_[i] = std::clamp(static_cast<int>(std::ceil(lengths[i] / cell_)), 1, cells_along_longest);
  const auto for_each_cell = [&](const Triangle& triangle, auto body) {
    const Range range = cells_near(triangle);
    for (int k = range.low[2]; k <= range.high[2]; ++k)
      for (int j = range.low[1]; j <= range.high[1]; ++j)
        for (int i = range.low[0]; i <= range.high[0]; ++i)
          body(static_cast<std::size_t>(cell_index(i, j, k)));
  };
  begin_.assign(static_cast<std::size_t>(cell_index(0, 0, count_[2])) + 1, 0);
  const std::size_t most = 200 * triangles_.size() + 100'000;
  std::size_t entries = 0;
  const bool single = count_ == std::array<int, 3>{1, 1, 1};
  for (const auto& triangle : triangles_) {
    for_each_cell(triangle, [&](std::size_t c) { ++begin_[c + 1], ++entries; });
    if (entries > most && !single) return false;
  }
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  near_.resize(static_cast<std::size_t>(begin_.back()));
  auto next = begin_;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for_each_cell(triangles_[t], [&](std::size_t c) {
      near_[static_cast<std::size_t>(next[c]++)] = static_cast<std::int32_t>(t);
    });
  return true;
}

bool SurfaceDistance::within(const Vec3<double>& x, double reach) const {
  if (x.x < low_.x || x.y < low_.y || x.z < low_.z || x.x > high_.x || x.y > high_.y || x.z > high_.z)
    return false;
  const auto cell = [&](double offset, int axis) {
    return static_cast<int>(std::clamp(offset / cell_, 0.0, count_[static_cast<std::size_t>(axis)] - 1.0));
  };
  const auto c = static_cast<std::size_t>(
      cell_index(cell(x.x - low_.x, 0), cell(x.y - low_.y, 1), cell(x.z - low_.z, 2)));
  for (auto i = begin_[c]; i < begin_[c + 1]; ++i) {
    const auto& t = triangles_[static_cast<std::size_t>(near_[static_cast<std::size_t>(i)])];
    const auto d = x - closest_point(x, t[0], t[1], t[2]);
    if (dot(d, d) <= reach * reach) return true;
  }
  return false;
}

}  // namespace glisson
