// Which of the facets that a node may meet is the nearest, and which are as near: the part of the narrow
// phase that looks at every candidate.
#pragma once

#include <glisson/contact/deformable/surface_view.hpp>
#include <glisson/contact/geometry/closest_points.hpp>

namespace glisson::contact {

/// A point among facets of the surface; `bias` is added to the distance of each [m].
template <class R>
struct FacetsNear {
  const SurfaceView<R>& surface;
  Vec3<R> p;
  const int* facets;  ///< [count]
  const R* bias;      ///< [count]
  int count;

  GLISSON_HD Vec3<R> corner(int i, int k) const {
    return surface.position(surface.triangles[facets[i]].n[k]);
  }
  GLISSON_HD TrianglePoint<R> foot(int i) const {
    return closest_on_triangle(p, corner(i, 0), corner(i, 1), corner(i, 2));
  }
  /// False where the facet's box is farther than `most`, which spares most of the distances.
  GLISSON_HD bool near_box(int i, R most) const {
    const Vec3<R> a = corner(i, 0), b = corner(i, 1), c = corner(i, 2);
    return near_range(p.x, a.x, b.x, c.x, most) && near_range(p.y, a.y, b.y, c.y, most) &&
           near_range(p.z, a.z, b.z, c.z, most);
  }
  /// Outward, unit.
  GLISSON_HD Vec3<R> normal(int i) const {
    const Vec3<R> a = corner(i, 0);
    return unit_or(cross(corner(i, 1) - a, corner(i, 2) - a), Vec3<R>{});
  }

 private:
  GLISSON_HD static bool near_range(R p, R a, R b, R c, R most) {
    const R low = a < b ? (a < c ? a : c) : (b < c ? b : c);
    const R high = a > b ? (a > c ? a : c) : (b > c ? b : c);
    return p > low - most && p < high + most;
  }
};

/// The facet with the least sum of distance and bias among those nearer than `reach`; of equal ones the
/// first.
template <class R>
struct NearestFacet {
  static constexpr int most_kept = 12;
  int place = -1;  ///< in the list; -1: none is near
  R away = R(0);   ///< distance and bias [m]
  TrianglePoint<R> foot{{R(0), R(0), R(0)}, R(0)};
  /// Those that are away by less than `slack` more, and maybe others, in the order of the list.
  int kept[most_kept];
  R kept_away[most_kept];
  int kept_count = 0;
  bool complete = true;  ///< false: there are more

  /// guess: place of a facet that is probably near. It is met first, so that few others pass the test of
  /// their boxes, and does not change the result.
  GLISSON_HD void find(const FacetsNear<R>& group, int guess, R reach, R slack) {
    R best = R(2) * reach, bound = best;  // no facet that counts is farther than `bound`
    TrianglePoint<R> guessed{{R(0), R(0), R(0)}, R(0)};
    for (int j = -1; j < group.count; ++j) {
      const int i = j < 0 ? guess : j;
      const bool again = j >= 0 && i == guess;
      if (j >= 0 && !again && !group.near_box(i, bound + slack - group.bias[i])) continue;
      const TrianglePoint<R> point = again ? guessed : group.foot(i);
      const R d = square_root(point.distance_squared), its = d + group.bias[i];
      if (j < 0) {
        guessed = point;
        if (d < reach && its < bound) bound = its;
        continue;
      }
      if (d < reach && d < best - group.bias[i]) {
        place = i;
        foot = point;
        best = away = its;
        bound = best < bound ? best : bound;
      }
      if (its < bound + slack) keep(i, its, bound + slack);
    }
  }

 private:
  GLISSON_HD void keep(int i, R its, R most) {
    if (kept_count == most_kept) {
      kept_count = 0;
      for (int k = 0; k < most_kept; ++k)
        if (kept_away[k] < most) move(k);
    }
    complete = complete && kept_count < most_kept;
    if (!complete) return;
    kept[kept_count] = i;
    kept_away[kept_count++] = its;
  }
  GLISSON_HD void move(int k) {
    kept[kept_count] = kept[k];
    kept_away[kept_count++] = kept_away[k];
  }
};

/// Mean normal of the facets that are as near as the nearest one, up to `slack`: at an edge or a vertex of
/// the surface the force then does not depend on which of them is found first.
template <class R>
GLISSON_HD Vec3<R> mean_normal(const FacetsNear<R>& group, const NearestFacet<R>& nearest, R slack) {
  Vec3<R> sum;
  const int count = nearest.complete ? nearest.kept_count : group.count;
  for (int k = 0; k < count; ++k) {
    const int i = nearest.complete ? nearest.kept[k] : k;
    const R away =
        nearest.complete ? nearest.kept_away[k] : square_root(group.foot(i).distance_squared) + group.bias[i];
    const R weight = R(1) - (away - nearest.away) / slack;
    if (weight > R(0)) sum = sum + weight * group.normal(i);
  }
  return unit_or(sum, Vec3<R>{});
}

}  // namespace glisson::contact
