// Which of the facets that a node may meet is the nearest, and which are as near: the part of the narrow
// phase that looks at every candidate.
#pragma once

#include <glisson/contact/deformable/surface_view.hpp>
#include <glisson/contact/geometry/closest_points.hpp>
#include <glisson/contact/geometry/lanes.hpp>

namespace glisson::contact {

/// Whether p is nearer than `most` to the box of the triangle a b c along each axis; a mask for lanes.
template <class L>
GLISSON_HD auto near_box(const Vec3<L>& p, const Vec3<L>& a, const Vec3<L>& b, const Vec3<L>& c, L most) {
  const auto near = [&](L at, L x, L y, L z) {
    const L low = select(x < y, x, y), high = select(x > y, x, y);
    return (at > select(low < z, low, z) - most) & (at < select(high > z, high, z) + most);
  };
  return near(p.x, a.x, b.x, c.x) & near(p.y, a.y, b.y, c.y) & near(p.z, a.z, b.z, c.z);
}

/// A point among facets of the surface; `bias` is added to the distance of each [m].
template <class R>
struct FacetsNear {
  const SurfaceView<R>& surface;
  Vec3<R> p;
  const int* facets;  ///< [count]
  const R* bias;      ///< [count]
  int count;

  GLISSON_HD const Vec4<R>* row(int i, int k) const { return surface.to + surface.triangles[facets[i]].n[k]; }
  GLISSON_HD Vec3<R> corner(int i, int k) const { return xyz(*row(i, k)); }
  GLISSON_HD TrianglePoint<R> foot(int i) const {
    return closest_on_triangle(p, corner(i, 0), corner(i, 1), corner(i, 2));
  }
  /// False where the facet's box is farther than `most`, which spares most of the distances.
  GLISSON_HD bool near(int i, R most) const {
    return near_box(p, corner(i, 0), corner(i, 1), corner(i, 2), most);
  }
  /// Outward, unit.
  GLISSON_HD Vec3<R> normal(int i) const {
    const Vec3<R> a = corner(i, 0);
    return unit_or(cross(corner(i, 1) - a, corner(i, 2) - a), Vec3<R>{});
  }
};

/// Some facets of a list, one for each lane.
template <class R, class L>
struct FacetFeet {
  static constexpr int width = lane_count<L>;
  Vec3<L> corner[3];
  L bias;  ///< beyond all distances where the list has ended [m]
  TrianglePoint<L> foot;
  L distance;  ///< [m]
  Vec3<L> normal;

  GLISSON_HD FacetFeet(const FacetsNear<R>& group, int first) {
    const auto place = [&](int l) { return first + l < group.count ? first + l : first; };
    for (int k = 0; k < 3; ++k) {
      const Vec4<R>* row[width];
      for (int l = 0; l < width; ++l) row[l] = group.row(place(l), k);
      corner[k] = turned_rows<L, R>(row);
    }
    bias = each_lane<L>([&](int l) { return first + l < group.count ? group.bias[first + l] : R(1e30); });
  }
  /// Whether a facet's box is as near to p as `most`, less its bias.
  GLISSON_HD bool any_near(const Vec3<R>& p, R most) const {
    return bits_of(near_box({L(p.x), L(p.y), L(p.z)}, corner[0], corner[1], corner[2], L(most) - bias)) != 0;
  }
  GLISSON_HD void measure(const Vec3<R>& from) {
    const Vec3<L> p{L(from.x), L(from.y), L(from.z)};
    foot = closest_on_triangle(p, corner[0], corner[1], corner[2]);
    distance = square_root(foot.distance_squared);
    const Vec3<L> n = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const L zero(R(0)), one(R(1)), squared = dot(n, n);
    const L scale = one / square_root(select(squared > zero, squared, one));
    normal = select(squared > zero, scale, zero) * n;
  }
};

/// The facet with the least sum of distance and bias among those nearer than `reach`; of equal ones the
/// first.
template <class R, class L = FacetLanes<R>>
struct NearestFacet {
  static constexpr int width = lane_count<L>, most_kept = 32;
  int place = -1;  ///< in the list; -1: none is near
  R away = R(0);   ///< distance and bias [m]
  TrianglePoint<R> foot{{R(0), R(0), R(0)}, R(0)};
  Vec3<R> normal;
  /// Those that may be away by less than `slack` more, and others beside them, in the order of the list.
  R kept_away[most_kept], kept_normal[3][most_kept];
  int kept_count = 0;
  bool complete = true;  ///< false: there are more

  GLISSON_HD void find(const FacetsNear<R>& group, R reach, R slack) {
    Best best{L(R(2) * reach), L(R(-1)), {{L(R(0)), L(R(0)), L(R(0))}, L(R(0))}, {L(R(0)), L(R(0)), L(R(0))}};
    const bool few = group.count <= 2 * width;  // a look at each box would take longer
    R bound = R(2) * reach;                     // no facet that counts is farther
    for (int first = 0; first < group.count; first += width) {
      FacetFeet<R, L> feet(group, first);
      if (!few && !feet.any_near(group.p, bound + slack)) continue;
      feet.measure(group.p);
      const L its = feet.distance + feet.bias;
      best.take(feet, its, (feet.distance < L(reach)) & (its < best.away), R(first));
      if (!few) bound = least(best.away);
      if (bits_of(its < L(bound + slack))) keep(its, feet.normal);
    }
    choose(best, R(2) * reach);
  }

 private:
  /// In each lane.
  struct Best {
    L away, first;
    TrianglePoint<L> foot;
    Vec3<L> normal;

    template <class Mask>
    GLISSON_HD void take(const FacetFeet<R, L>& feet, const L& its, const Mask& better, R its_first) {
      away = select(better, its, away);
      first = select(better, L(its_first), first);
      foot = replaced(foot, better, feet.foot);
      normal = {select(better, feet.normal.x, normal.x), select(better, feet.normal.y, normal.y),
                select(better, feet.normal.z, normal.z)};
    }
  };
  GLISSON_HD static R least(const L& a) {
    R result = lane(a, 0);
    for (int l = 1; l < width; ++l) result = lane(a, l) < result ? lane(a, l) : result;
    return result;
  }
  GLISSON_HD void choose(const Best& best, R most) {
    int from = -1;
    away = most;
    for (int l = 0; l < width; ++l) {
      const int its = static_cast<int>(lane(best.first, l)) + l;
      if (!(lane(best.away, l) < away) && !(lane(best.away, l) == away && from >= 0 && its < place)) continue;
      away = lane(best.away, l);
      place = its;
      from = l;
    }
    if (from < 0) return;
    foot = {{lane(best.foot.b[0], from), lane(best.foot.b[1], from), lane(best.foot.b[2], from)},
            lane(best.foot.distance_squared, from)};
    normal = {lane(best.normal.x, from), lane(best.normal.y, from), lane(best.normal.z, from)};
  }
  GLISSON_HD void keep(const L& its, const Vec3<L>& its_normal) {
    complete = complete && kept_count < most_kept;
    if (!complete) return;
    put_lanes(its, kept_away + kept_count);
    put_lanes(its_normal.x, kept_normal[0] + kept_count);
    put_lanes(its_normal.y, kept_normal[1] + kept_count);
    put_lanes(its_normal.z, kept_normal[2] + kept_count);
    kept_count += width;
  }
};

/// Mean normal of the facets that are as near as the nearest one, up to `slack`: at an edge or a vertex of
/// the surface the force then does not depend on which of them is found first.
template <class R, class L>
GLISSON_HD Vec3<R> mean_normal(const FacetsNear<R>& group, const NearestFacet<R, L>& nearest, R slack) {
  Vec3<R> sum;
  const auto add = [&](R weight, const Vec3<R>& normal) {
    if (weight > R(0)) sum = sum + weight * normal;
  };
  if (nearest.complete) {
    for (int first = 0; first < nearest.kept_count; first += lane_count<L>) {
      const L weight = L(R(1)) - (lanes_at<L>(nearest.kept_away + first) - L(nearest.away)) / L(slack);
      for (int l = 0, k = first; l < lane_count<L>; ++l, ++k)
        add(lane(weight, l),
            {nearest.kept_normal[0][k], nearest.kept_normal[1][k], nearest.kept_normal[2][k]});
    }
  } else {
    for (int i = 0; i < group.count; ++i) {
      const R away = square_root(group.foot(i).distance_squared) + group.bias[i];
      add(R(1) - (away - nearest.away) / slack, group.normal(i));
    }
  }
  return unit_or(sum, Vec3<R>{});
}

}  // namespace glisson::contact
