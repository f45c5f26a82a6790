// Narrow phase: loop bodies that find the contact of a node with the facets of one region, and of two edges,
// at the predicted positions.
#pragma once

#include <glisson/contact/deformable/nearest_facet.hpp>
#include <glisson/contact/deformable/passage.hpp>
#include <glisson/contact/deformable/touch.hpp>

namespace glisson::contact {

/// A node with the facets of one region that may meet it: the nearest that it faces counts (Johnsen 2016,
/// section 5.3.4.4), or the one that it went through in the step.
/// L: a few facets are looked at together.
template <class R, class L = FacetLanes<R>>
struct FindFacetTouch {
  static constexpr int cost = 200;
  SurfaceView<R> surface;
  const int *group_node, *group_begin, *facets;
  const R *bias, *friction, *entry;
  Touch<R>* touches;
  unsigned char* used;  ///< whether something has to be done about a touch
  TouchLimits<R> limits;
  R swept;  ///< what went through a facet in this step is at most so far from it now; 0 where no node moves
            ///< so far that it could pass one unseen [m]

  /// The same with other lanes.
  template <class Other>
  FindFacetTouch<R, Other> with_lanes() const {
    return {surface, group_node, group_begin, facets, bias, friction, entry, touches, used, limits, swept};
  }
  /// In facets: what belongs to the node takes as long as some three.
  int work_before(int g) const { return group_begin[g] + 3 * g; }
  GLISSON_HD void operator()(int g) const {
    Touch<R>& t = touches[g];
    const int node = group_node[g], first = group_begin[g];
    const FacetsNear<R> group{surface, surface.position(node), facets + first, bias + first,
                              group_begin[g + 1] - first};
    NearestFacet<R, L> nearest;
    nearest.find(group, limits.reach, limits.slack);
    const Passage<R> passage = passed(group, node);
    t.friction = friction[g];
    bool use = false;
    if (passage.facet >= 0 && t.came != came_from_behind)
      use = touch_passed(t, g, passage);
    else if (nearest.place >= 0)
      use = touch_nearest(t, g, group, nearest);
    else
      t.came = came_from_nowhere;
    if (!use) t.pressing = R(0);
    used[g] = use;
  }

 private:
  /// The facet that the node went through first in this step.
  GLISSON_HD Passage<R> passed(const FacetsNear<R>& group, int node) const {
    Passage<R> passage;
    if (!(swept > R(0))) return passage;
    for (int i = 0; i < group.count; ++i)
      if (group.near(i, swept)) find_passage(surface, node, group.facets[i], limits.slack, passage);
    return passage;
  }
  GLISSON_HD void set_nodes(Touch<R>& t, int node, int facet, const R (&b)[3]) const {
    const Corners& c = surface.triangles[facet];
    const bool whole = c.n[2] < surface.corner_count;  // otherwise a quarter of a quad about its centre
    int count = 0;
    add_node(t, count, surface.node_of(node), R(1));
    if (!whole) {
      const Quad& quad = surface.quads[c.n[2] - surface.corner_count];
      for (int k = 0; k < 4; ++k) add_node(t, count, surface.node_of(quad.n[k]), R(-0.25) * b[2]);
    }
    for (int k = 0; k < (whole ? 3 : 2); ++k) add_node(t, count, surface.node_of(c.n[k]), -b[k]);
    end_nodes(t, count);
  }
  /// From the node to the point b of the facet.
  GLISSON_HD static Vec3<R> to_point(const FacetsNear<R>& group, int place, const R (&b)[3]) {
    return b[0] * group.corner(place, 0) + b[1] * group.corner(place, 1) + b[2] * group.corner(place, 2) -
           group.p;
  }
  /// In front of the facet the gap is the distance and its normal the shortest way, which turns round edges
  /// without a jump.
  GLISSON_HD bool touch_nearest(Touch<R>& t, int g, const FacetsNear<R>& group,
                                const NearestFacet<R, L>& nearest) const {
    const TrianglePoint<R>& foot = nearest.foot;
    const Vec3<R> way = to_point(group, nearest.place, foot.b);
    const R out = dot(way, nearest.normal), distance = square_root(foot.distance_squared);
    const bool inside = foot.b[0] > R(1e-4) && foot.b[1] > R(1e-4) && foot.b[2] > R(1e-4);
    // beside the border of the facets that it faces a node is still held up to here, so that flush sides
    // that slip a little stay on each other
    const bool beside = !inside && (out < R(0) ? -out : out) < R(0.5) * distance;
    if (beside && distance > R(5) * limits.slack) {
      t.came = came_from_nowhere;
      return false;
    }
    const bool near = beside || distance < R(0.1) * limits.slack;
    set_nodes(t, group_node[g], group.facets[nearest.place], foot.b);
    t.normal = near || out > R(0) ? mean_normal(group, nearest, limits.slack) : (R(-1) / distance) * way;
    t.gap = -dot(t.normal, way) - limits.offset;
    return complete_touch(t, surface.motion, surface.guess, limits, entry[g]);
  }
  GLISSON_HD bool touch_passed(Touch<R>& t, int g, const Passage<R>& passage) const {
    const int node = group_node[g];
    const R bias_of_it = R(0);
    const FacetsNear<R> its{surface, surface.position(node), &passage.facet, &bias_of_it, 1};
    t.came = came_from_front;
    set_nodes(t, node, passage.facet, passage.b);
    t.normal = its.normal(0);
    t.gap = -dot(t.normal, to_point(its, 0, passage.b)) - limits.offset;
    return complete_touch(t, surface.motion, surface.guess, limits, entry[g]);
  }
};

struct EdgeCorners {
  int node[2], opposite[2];
};

/// Two edges that cross, neither in a valley of its surface. The gap is measured along their common normal
/// (for Johnsen 2016, eq. 5.12, along the smooth normal of one of them), so that the forces have no moment.
template <class R>
struct FindEdgeTouch {
  static constexpr int cost = 60;
  SurfaceView<R> surface;
  const EdgeCorners* edges;
  const int* pairs;  ///< [2 pair_count]
  const R *friction, *entry;
  Touch<R>* touches;
  unsigned char* used;
  TouchLimits<R> limits;

  GLISSON_HD void operator()(int i) const {
    Touch<R>& t = touches[i];
    const int came = t.came;
    t.came = came_from_nowhere;
    used[i] = touch(t, i, came);
    if (!used[i]) t.pressing = R(0);
  }

 private:
  GLISSON_HD bool touch(Touch<R>& t, int i, int came) const {
    const EdgeCorners &a = edges[pairs[2 * i]], &b = edges[pairs[2 * i + 1]];
    const Vec3<R> a0 = surface.position(a.node[0]), b0 = surface.position(b.node[0]);
    const Vec3<R> along_a = surface.position(a.node[1]) - a0, along_b = surface.position(b.node[1]) - b0;
    const Vec3<R> across = cross(along_a, along_b), from = b0 - a0;
    const R area = dot(across, across);
    // nearly parallel edges meet at their ends, and those meet facets
    if (!(area > R(1e-3) * dot(along_a, along_a) * dot(along_b, along_b))) return false;
    const R s = dot(cross(from, along_b), across) / area, q = dot(cross(from, along_a), across) / area;
    if (!inside(s) || !inside(q)) return false;
    Vec3<R> n = (R(1) / square_root(area)) * across;
    const Vec3<R> apart = s * along_a - from - q * along_b;
    if (!(dot(apart, apart) < limits.reach * limits.reach)) return false;
    const R facing = dot(n, out_of(b, b0, along_b) - out_of(a, a0, along_a));
    if (facing < R(0)) n = R(-1) * n;
    // along n no triangle of b may stand in front of its edge, none of a behind its own
    if (rises(b, n, b0) || rises(a, R(-1) * n, a0)) return false;
    int count = 0;
    add_node(t, count, surface.node_of(a.node[0]), R(1) - s);
    add_node(t, count, surface.node_of(a.node[1]), s);
    add_node(t, count, surface.node_of(b.node[0]), q - R(1));
    add_node(t, count, surface.node_of(b.node[1]), -q);
    end_nodes(t, count);
    t.came = came;
    t.normal = n;
    t.friction = friction[i];
    t.gap = dot(n, apart) - limits.offset;
    return complete_touch(t, surface.motion, surface.guess, limits, entry[i]);
  }
  GLISSON_HD static bool inside(R s) { return s > R(1e-3) && s < R(1) - R(1e-3); }
  /// Sum of the normals of both triangles of an edge, of any length.
  GLISSON_HD Vec3<R> out_of(const EdgeCorners& e, const Vec3<R>& p, const Vec3<R>& along) const {
    return cross(along, surface.position(e.opposite[0]) - p) -
           cross(along, surface.position(e.opposite[1]) - p);
  }
  GLISSON_HD bool rises(const EdgeCorners& e, const Vec3<R>& n, const Vec3<R>& p) const {
    for (int k = 0; k < 2; ++k) {
      const Vec3<R> x = surface.position(e.opposite[k]) - p;
      const R height = dot(n, x);
      if (height > R(0) && height * height > R(1e-3) * dot(x, x)) return true;  // slope 0.03
    }
    return false;
  }
};

}  // namespace glisson::contact
