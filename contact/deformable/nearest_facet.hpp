// Which of the facets that a node may meet is the nearest, and which are as near: the part of the narrow
// phase that looks at every candidate.
#pragma once

#include <glisson/contact/deformable/surface_view.hpp>
#include <glisson/contact/geometry/closest_points.hpp>
#include <glisson/contact/geometry/lanes.hpp>

namespace glisson::contact {

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

#ifdef __CUDACC__
template <class R>
constexpr int facets_together = 1;
#else
template <class R>
constexpr int facets_together = Lanes<R>::width;
#endif

/// Facets of a list, measured together.
template <class R, int most = facets_together<R>>
struct FacetFeet {
  int place[most];  ///< in the list
  int count = 0;
  TrianglePoint<R> foot[most];
  R distance[most];  ///< [m]
  R normal[most][3];

  GLISSON_HD void measure(const FacetsNear<R>& group) {
    if constexpr (most == 1) {
      foot[0] = group.foot(place[0]);
      distance[0] = square_root(foot[0].distance_squared);
      set_normal(0, group.normal(place[0]));
    }
#ifndef __CUDACC__
    if constexpr (most > 1) measure_lanes(group);
#endif
  }

 private:
  GLISSON_HD void set_normal(int l, const Vec3<R>& n) {
    normal[l][0] = n.x, normal[l][1] = n.y, normal[l][2] = n.z;
  }
#ifndef __CUDACC__
  void measure_lanes(const FacetsNear<R>& group) {
    using L = Lanes<R>;
    const Vec4<R>* corner[3][most];
    for (int l = 0; l < most; ++l)
      for (int k = 0; k < 3; ++k) corner[k][l] = group.row(place[l < count ? l : 0], k);
    const Vec3<L> x[3] = {turned_rows<R>(corner[0]), turned_rows<R>(corner[1]), turned_rows<R>(corner[2])};
    const Vec3<L> p{L(group.p.x), L(group.p.y), L(group.p.z)}, n = cross(x[1] - x[0], x[2] - x[0]);
    const TrianglePoint<L> feet = closest_on_triangle(p, x[0], x[1], x[2]);
    const L zero(R(0)), one(R(1)), squared = dot(n, n), away = square_root(feet.distance_squared);
    const L scale = one / square_root(select(squared > zero, squared, one));
    const Vec3<L> unit = select(squared > zero, scale, zero) * n;
    for (int l = 0; l < most; ++l) {
      foot[l] = {{feet.b[0].v[l], feet.b[1].v[l], feet.b[2].v[l]}, feet.distance_squared.v[l]};
      distance[l] = away.v[l];
      set_normal(l, {unit.x.v[l], unit.y.v[l], unit.z.v[l]});
    }
  }
#endif
};

/// The facet with the least sum of distance and bias among those nearer than `reach`; of equal ones the
/// first.
template <class R>
struct NearestFacet {
  static constexpr int most_kept = 12;
  int place = -1;  ///< in the list; -1: none is near
  R away = R(0);   ///< distance and bias [m]
  TrianglePoint<R> foot{{R(0), R(0), R(0)}, R(0)};
  Vec3<R> normal;
  /// Those that are away by less than `slack` more, and maybe others, in the order of the list.
  R kept_away[most_kept];
  R kept_normal[most_kept][3];
  int kept_count = 0;
  bool complete = true;  ///< false: there are more

  GLISSON_HD void find(const FacetsNear<R>& group, R reach, R slack) {
    constexpr int most = facets_together<R>;
    R bound = R(2) * reach;                    // no facet that counts is farther
    const bool few = group.count <= 2 * most;  // a look at each box would take longer
    FacetFeet<R> feet;
    for (int i = 0; i < group.count; ++i) {
      if (few || group.near_box(i, bound + slack - group.bias[i])) feet.place[feet.count++] = i;
      if (feet.count < (i + 1 < group.count ? most : 1)) continue;
      feet.measure(group);
      for (int l = 0; l < feet.count; ++l) take(group, feet, l, reach, slack, bound);
      feet.count = 0;
    }
  }

 private:
  GLISSON_HD void take(const FacetsNear<R>& group, const FacetFeet<R>& feet, int l, R reach, R slack,
                       R& bound) {
    const int i = feet.place[l];
    const R d = feet.distance[l], its = d + group.bias[i];
    if (d < reach && d < bound - group.bias[i]) {
      place = i;
      foot = feet.foot[l];
      normal = {feet.normal[l][0], feet.normal[l][1], feet.normal[l][2]};
      bound = away = its;
    }
    if (its < bound + slack) keep(its, feet.normal[l], bound + slack);
  }
  GLISSON_HD void keep(R its, const R (&its_normal)[3], R most) {
    if (kept_count == most_kept) {
      kept_count = 0;
      for (int k = 0; k < most_kept; ++k)
        if (kept_away[k] < most) put(kept_away[k], kept_normal[k]);
    }
    complete = complete && kept_count < most_kept;
    if (complete) put(its, its_normal);
  }
  GLISSON_HD void put(R its, const R (&its_normal)[3]) {
    kept_away[kept_count] = its;
    for (int k = 0; k < 3; ++k) kept_normal[kept_count][k] = its_normal[k];
    ++kept_count;
  }
};

/// Mean normal of the facets that are as near as the nearest one, up to `slack`: at an edge or a vertex of
/// the surface the force then does not depend on which of them is found first.
template <class R>
GLISSON_HD Vec3<R> mean_normal(const FacetsNear<R>& group, const NearestFacet<R>& nearest, R slack) {
  Vec3<R> sum;
  const int count = nearest.complete ? nearest.kept_count : group.count;
  for (int k = 0; k < count; ++k) {
    const R away =
        nearest.complete ? nearest.kept_away[k] : square_root(group.foot(k).distance_squared) + group.bias[k];
    const R weight = R(1) - (away - nearest.away) / slack;
    if (!(weight > R(0))) continue;
    const R* kept = nearest.kept_normal[k < nearest.most_kept ? k : 0];
    sum = sum + weight * (nearest.complete ? Vec3<R>{kept[0], kept[1], kept[2]} : group.normal(k));
  }
  return unit_or(sum, Vec3<R>{});
}

}  // namespace glisson::contact
