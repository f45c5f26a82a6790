// A triangle surface at rest in its own frame, and how a point that moves in a step meets it. The tree is
// walked without a stack: its nodes lie in depth-first order and each knows what follows its subtree.
#pragma once

#include <glisson/contact/analytic/shapes.hpp>
#include <glisson/contact/geometry/smooth_normal.hpp>

namespace glisson::contact {

template <class R>
struct SurfaceNode {
  Vec3<R> low, high;  ///< [m]
  int skip;           ///< the next node when the box is missed
  int facet;          ///< of a leaf; -1 elsewhere
};

template <class R>
struct SurfaceFacet {
  SmoothTriangle<R> smooth;
  Vec3<R> edge_normal[3];  ///< of the edge opposite corner k: mean of both sides
  bool border_edge[3];     ///< nothing across the edge opposite corner k
  bool border_corner[3];   ///< a border passes through corner k
};

/// Where a path went through the surface from front to back first.
template <class R>
struct Crossing {
  R at = R(2);  ///< share of the path; above 1: nowhere
  Vec3<R> point, normal;
};

/// What a way through the surroundings of a surface has near it.
template <class R>
struct Surroundings {
  /// No facet is so near to the way that a point anywhere on it could be in contact.
  bool far = true;
  /// Points that are nearer to the way's end than this, less the offset, are not in contact, nor does a way
  /// between them cross the surface [m].
  R clear = R(0);
  R closest = R(0);  ///< distance of the closest facet from the way's end, 0 where none was found [m]
};

template <class R>
struct SurfaceShape {
  const SurfaceNode<R>* nodes;
  const SurfaceFacet<R>* facets;
  int node_count;
  R reach;  ///< how deep behind the surface a point is still found when it stands still [m]

  /// Signed by the normal of the closest feature (Baerentzen & Aanaes 2005); pushed along the smooth normal.
  /// A point whose path crossed the surface goes back to where it crossed, unless the closest facet is of the
  /// same side: so it may cross a whole thin body in one step. The search grows with the path.
  /// offset: how far from the surface the point is held, along the smooth normal [m]
  GLISSON_HD Penetration<R> operator()(const Vec3<R>& from, const Vec3<R>& to, R offset = R(0)) const {
    Surroundings<R> around;
    return penetration(from, to, offset, around);
  }
  /// known: a facet lies nearer to the way's end than this, 0 if nobody knows one [m]
  GLISSON_HD Penetration<R> penetration(const Vec3<R>& from, const Vec3<R>& to, R offset,
                                        Surroundings<R>& around, R known = R(0)) const {
    around = {};
    const Vec3<R> path = to - from;
    const R length = square_root(dot(path, path)), radius = reach + offset + length;
    R within = known > R(0) && known < radius ? known : radius, nearest = within * within;
    within = within > length ? within : length;  // so far the path may cross
    int closest = -1;
    Crossing<R> crossing;
    for (int n = 0; n < node_count;) {
      const SurfaceNode<R>& node = nodes[n];
      if (!near(node, to, within)) {
        n = node.skip;
        continue;
      }
      ++n;
      if (node.facet < 0) continue;
      around.far = false;
      const SmoothTriangle<R>& t = facets[node.facet].smooth;
      const R d = closest_on_triangle(to, t.x[0], t.x[1], t.x[2]).distance_squared;
      if (d < nearest) {
        nearest = d;
        closest = node.facet;
        within = nearest > length * length ? square_root(nearest) : length;
      }
      cross_facet(t, from, path, crossing);
    }
    if (closest < 0) around.clear = distance_of_boxes(to, R(2) * (radius + reach)) - reach;
    bool in_front = false;
    const Penetration<R> behind =
        closest >= 0 ? behind_facet(facets[closest], to, offset, in_front) : Penetration<R>{};
    if (closest >= 0) around.closest = square_root(nearest);
    if (in_front) around.clear = around.closest;
    if (!(crossing.at <= R(1)) || (behind.depth > R(0) && dot(behind.out, crossing.normal) > R(0)))
      return behind;
    return {dot(crossing.point - to, crossing.normal) + offset, crossing.normal};
  }

  /// How far p is behind the facet that is the closest one to it, or nearer in front of it than the offset.
  GLISSON_HD Penetration<R> behind_facet(const SurfaceFacet<R>& facet, const Vec3<R>& p,
                                         R offset = R(0)) const {
    bool in_front;
    return behind_facet(facet, p, offset, in_front);
  }
  GLISSON_HD Penetration<R> behind_facet(const SurfaceFacet<R>& facet, const Vec3<R>& p, R offset,
                                         bool& in_front) const {
    const SmoothTriangle<R>& t = facet.smooth;
    const TrianglePoint<R> foot = closest_on_triangle(p, t.x[0], t.x[1], t.x[2]);
    Vec3<R> side = t.facet_normal();
    bool border = false;
    for (int k = 0; k < 3; ++k)
      if (foot.b[k] < R(1e-5)) {
        side = facet.edge_normal[k];
        border = border || facet.border_edge[k];
      }
    for (int k = 0; k < 3; ++k)
      if (foot.b[k] > R(1) - R(2e-5)) {
        side = t.n[k];
        border = border || facet.border_corner[k];
      }
    in_front = !(dot(p - t.point(foot.b), side) < R(0));
    if (in_front && !(foot.distance_squared < offset * offset)) return {};
    const SmoothGap<R> gap = smooth_gap(t, p);
    // beside an open surface is not behind it
    if (border && gap.miss > R(1e-3) * reach) return {};
    return {gap.gap < offset ? offset - gap.gap : R(0), gap.normal};
  }

 private:
  GLISSON_HD static bool near(const SurfaceNode<R>& node, const Vec3<R>& p, R radius) {
    return node.low.x <= p.x + radius && p.x - radius <= node.high.x && node.low.y <= p.y + radius &&
           p.y - radius <= node.high.y && node.low.z <= p.z + radius && p.z - radius <= node.high.z;
  }
  /// Least distance along an axis to a facet's box, or less: boxes farther than `most` are not opened.
  GLISSON_HD R distance_of_boxes(const Vec3<R>& p, R most) const {
    R least = R(3e38);
    for (int n = 0; n < node_count;) {
      const R distance = box_distance(nodes[n], p);
      const bool opened = distance < most && distance < least && nodes[n].facet < 0;
      if (!opened && distance < least) least = distance;
      n = opened ? n + 1 : nodes[n].skip;
    }
    return least;
  }
  GLISSON_HD static R box_distance(const SurfaceNode<R>& node, const Vec3<R>& p) {
    const R x = beyond(node.low.x, p.x, node.high.x), y = beyond(node.low.y, p.y, node.high.y),
            z = beyond(node.low.z, p.z, node.high.z);
    return x > y ? (x > z ? x : z) : (y > z ? y : z);
  }
  GLISSON_HD static R beyond(R low, R at, R high) { return low - at > at - high ? low - at : at - high; }
  GLISSON_HD void cross_facet(const SmoothTriangle<R>& t, const Vec3<R>& from, const Vec3<R>& path,
                              Crossing<R>& crossing) const {
    const R slack = R(1e-3) * reach;
    const Vec3<R> n = t.facet_normal();
    const R before = dot(from - t.x[0], n), way = dot(path, n);
    // a node that rests on the facet lies behind it by rounding
    if (!(way < R(0) && before >= R(0) - slack && before + way < R(0))) return;
    const R at = (before > R(0) ? before : R(0)) / (R(0) - way);
    if (!(at < crossing.at)) return;
    const Vec3<R> p = from + at * path;
    const TrianglePoint<R> foot = closest_on_triangle(p, t.x[0], t.x[1], t.x[2]);
    const Vec3<R> edge = t.x[1] - t.x[0];
    if (foot.distance_squared <= R(1e-8) * dot(edge, edge) + slack * slack)
      crossing = {at, p, n};  // edges leave no gap
  }
};

}  // namespace glisson::contact
