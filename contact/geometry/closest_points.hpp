// Closest points of a point and a triangle and of two segments, whatever degenerates: segments and triangles
// of no extent, needles, parallel and collinear edges. Each answer is the best of a few candidates that all
// lie on the features, so that a candidate spoilt by rounding can lose but never leave the feature. The
// distance of two convex sets is a convex quadratic over a triangle or a square: its minimum is the
// stationary point inside or lies on an edge of that domain, and the candidates are just these.
#pragma once

#include <glisson/core/numbers/functions.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

/// R may be a pack of numbers in this and the next functions: nothing branches.
template <class R>
GLISSON_HD R within_unit(const R& t) {
  const R low = select(t > R(0), t, R(0));  // NaN gives 0
  return select(low < R(1), low, R(1));
}

/// Parameter in [0, 1] of the point of a, a + d that is closest to p (w = p - a); 0 for a segment of no
/// length.
template <class R>
GLISSON_HD R closest_on_segment(const Vec3<R>& w, const Vec3<R>& d) {
  const R length_squared = dot(d, d);
  const R ratio = dot(w, d) / select(length_squared > R(0), length_squared, R(1));
  return select(length_squared > R(0), within_unit(ratio), R(0));
}

/// A point of a triangle as weights of its corners, which sum to 1, and how far it is.
template <class R>
struct TrianglePoint {
  R b[3];
  R distance_squared;  ///< [m^2]
};

/// ap, ab, ac: from corner a to the point and to the other corners; c: weights of b and c.
template <class R>
GLISSON_HD TrianglePoint<R> triangle_candidate(const Vec3<R>& ap, const Vec3<R>& ab, const Vec3<R>& ac, R b,
                                               R c) {
  const Vec3<R> q = ap - b * ab - c * ac;
  return {{R(1) - b - c, b, c}, dot(q, q)};
}
/// b where the mask says so.
template <class R, class Mask>
GLISSON_HD TrianglePoint<R> replaced(const TrianglePoint<R>& a, Mask mask, const TrianglePoint<R>& b) {
  return {{select(mask, b.b[0], a.b[0]), select(mask, b.b[1], a.b[1]), select(mask, b.b[2], a.b[2])},
          select(mask, b.distance_squared, a.distance_squared)};
}
template <class R>
GLISSON_HD TrianglePoint<R> nearer(const TrianglePoint<R>& a, const TrianglePoint<R>& b) {
  return replaced(a, b.distance_squared < a.distance_squared, b);
}

template <class R>
GLISSON_HD TrianglePoint<R> closest_on_triangle(const Vec3<R>& p, const Vec3<R>& a, const Vec3<R>& b,
                                                const Vec3<R>& c) {
  const Vec3<R> ab = b - a, ac = c - a, ap = p - a;
  const R on_ab = closest_on_segment(ap, ab), on_ac = closest_on_segment(ap, ac);
  const R on_bc = closest_on_segment(p - b, c - b);
  TrianglePoint<R> best = triangle_candidate(ap, ab, ac, on_ab, R(0));
  best = nearer(best, triangle_candidate(ap, ab, ac, R(0), on_ac));
  best = nearer(best, triangle_candidate(ap, ab, ac, R(1) - on_bc, on_bc));
  // inside: weights by areas; a foot outside is no candidate, a flat triangle has none
  const Vec3<R> n = cross(ab, ac);
  const R area = dot(n, n);
  const R scale = R(1) / select(area > R(0), area, R(1));
  const R weight_b = dot(cross(ap, ac), n) * scale, weight_c = dot(cross(ab, ap), n) * scale;
  const TrianglePoint<R> inner = triangle_candidate(ap, ab, ac, weight_b, weight_c);
  const auto inside = (area > R(0)) & (weight_b >= R(0)) & (weight_c >= R(0)) & (weight_b + weight_c <= R(1));
  return replaced(best, inside & (inner.distance_squared < best.distance_squared), inner);
}

/// Points p + s (p1 - p) and q + t (q1 - q) of two segments.
template <class R>
struct SegmentPoints {
  R s, t;              ///< [-] in [0, 1]
  R distance_squared;  ///< [m^2]
};

template <class R>
GLISSON_HD SegmentPoints<R> segment_candidate(const Vec3<R>& w, const Vec3<R>& d, const Vec3<R>& e, R s,
                                              R t) {
  const Vec3<R> q = w + t * e - s * d;
  return {s, t, dot(q, q)};
}
template <class R>
GLISSON_HD SegmentPoints<R> nearer(const SegmentPoints<R>& a, const SegmentPoints<R>& b) {
  return b.distance_squared < a.distance_squared ? b : a;
}

template <class R>
GLISSON_HD SegmentPoints<R> closest_of_segments(const Vec3<R>& p, const Vec3<R>& p1, const Vec3<R>& q,
                                                const Vec3<R>& q1) {
  const Vec3<R> d = p1 - p, e = q1 - q, w = q - p, zero = R(0) * d;
  SegmentPoints<R> best = segment_candidate(w, d, e, R(0), closest_on_segment(zero - w, e));
  best = nearer(best, segment_candidate(w, d, e, R(1), closest_on_segment(p1 - q, e)));
  best = nearer(best, segment_candidate(w, d, e, closest_on_segment(w, d), R(0)));
  best = nearer(best, segment_candidate(w, d, e, closest_on_segment(q1 - p, d), R(1)));
  // inside both: along the common normal; parallel edges have the minimum at an end as well
  const Vec3<R> n = cross(d, e);
  const R area = dot(n, n);
  const R scale = R(1) / (area > R(0) ? area : R(1));
  const R s = within_unit(dot(cross(w, e), n) * scale), t = within_unit(dot(cross(w, d), n) * scale);
  return area > R(0) ? nearer(best, segment_candidate(w, d, e, s, t)) : best;
}

}  // namespace glisson::contact
