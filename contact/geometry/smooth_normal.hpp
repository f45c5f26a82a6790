// Normals that are continuous over a triangle surface, and the gap along them: Johnsen 2016, eq. 5.10-5.12.
#pragma once

#include <glisson/contact/geometry/closest_points.hpp>
#include <glisson/core/numbers/functions.hpp>

namespace glisson::contact {

/// a / |a|; the fallback where a has no length.
template <class R>
GLISSON_HD Vec3<R> unit_or(const Vec3<R>& a, const Vec3<R>& fallback) {
  const R squared = dot(a, a);
  const R scale = R(1) / square_root(squared > R(0) ? squared : R(1));
  return squared > R(0) ? scale * a : fallback;
}

/// A triangle's corners and the unit normals of its vertices.
template <class R>
struct SmoothTriangle {
  Vec3<R> x[3];
  Vec3<R> n[3];

  GLISSON_HD Vec3<R> point(const R (&b)[3]) const { return b[0] * x[0] + b[1] * x[1] + b[2] * x[2]; }
  GLISSON_HD Vec3<R> facet_normal() const { return unit_or(cross(x[1] - x[0], x[2] - x[0]), n[0]); }
  /// n_m(xi, eta): the interpolated vertex normals, unit.
  GLISSON_HD Vec3<R> normal(const R (&b)[3]) const {
    return unit_or(b[0] * n[0] + b[1] * n[1] + b[2] * n[2], facet_normal());
  }
};

/// Where a point projects along the smooth normal, and how far it is in front (> 0) or behind (< 0).
template <class R>
struct SmoothGap {
  R b[3];
  Vec3<R> normal;  ///< unit, at b
  R gap;           ///< n_m . (p - x_m), eq. 5.10 [m]
  R miss;          ///< what of p - x_m is not along n_m [m]; 0 where the projection exists
};

constexpr int smooth_projections = 8;

/// Solves p = x_m(b) + g n_m(b) from the closest point by fixed-point steps: each shoots from p along the
/// last normal to the facet's plane and is brought back to the facet. The error shrinks by |g| / (radius of
/// curvature) a step; the steps fail where |g| exceeds that radius.
template <class R>
GLISSON_HD SmoothGap<R> smooth_gap(const SmoothTriangle<R>& triangle, const Vec3<R>& p) {
  const TrianglePoint<R> start = closest_on_triangle(p, triangle.x[0], triangle.x[1], triangle.x[2]);
  SmoothGap<R> result{{start.b[0], start.b[1], start.b[2]}, {}, R(0), R(0)};
  const Vec3<R> face = triangle.facet_normal();
  for (int i = 0; i < smooth_projections; ++i) {
    const Vec3<R> n = triangle.normal(result.b);
    const R slope = dot(n, face);
    const R height = dot(p - triangle.x[0], face);
    const R along = slope > R(0.1) ? height / slope : height;
    const TrianglePoint<R> next =
        closest_on_triangle(p - along * n, triangle.x[0], triangle.x[1], triangle.x[2]);
    for (int k = 0; k < 3; ++k) result.b[k] = next.b[k];
  }
  result.normal = triangle.normal(result.b);
  const Vec3<R> apart = p - triangle.point(result.b);
  result.gap = dot(result.normal, apart);
  const Vec3<R> aside = apart - result.gap * result.normal;
  result.miss = square_root(dot(aside, aside));
  return result;
}

}  // namespace glisson::contact
