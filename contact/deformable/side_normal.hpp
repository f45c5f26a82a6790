// The normal that side points stand on.
#pragma once

#include <glisson/contact/geometry/smooth_normal.hpp>

namespace glisson::contact {

/// The mean normal at a vertex of triangles, each weighted by the sine of its angle there over the lengths of
/// its sides: exact on spheres, no trigonometry (Max 1999). Its length is the cosine of their inclination to
/// it where all are alike inclined, 0 where they cancel.
/// Corner: (triangle, k) -> position of corner k; Place: triangle -> which corner the vertex is
template <class R, class Corner, class Place>
GLISSON_HD Vec3<R> mean_side_normal(const int* around, int count, Corner corner, Place place) {
  Vec3<R> sum;
  R weights = R(0);
  for (int i = 0; i < count; ++i) {
    const int t = around[i], k = place(t);
    const Vec3<R> x = corner(t, k), a = corner(t, (k + 1) % 3) - x, b = corner(t, (k + 2) % 3) - x;
    const R lengths = dot(a, a) * dot(b, b);
    if (!(lengths > R(0))) continue;
    const Vec3<R> normal = (R(1) / lengths) * cross(a, b);
    sum = sum + normal;
    weights += square_root(dot(normal, normal));
  }
  return weights > R(0) ? (R(1) / weights) * sum : sum;
}

template <class R, class Corner, class Place>
GLISSON_HD Vec3<R> side_normal(const int* around, int count, Corner corner, Place place) {
  return unit_or(mean_side_normal<R>(around, count, corner, place), Vec3<R>{});
}

}  // namespace glisson::contact
