// Narrow phase: loop bodies that find the contact of a node with the facets of one region, and of two edges,
// at the predicted positions.
#pragma once

#include <glisson/contact/deformable/surface_view.hpp>
#include <glisson/contact/deformable/touch.hpp>

namespace glisson::contact {

/// Where the path of a point went through a triangle that moves as well, from front to back.
template <class R>
struct Passage {
  R at = R(2);  ///< share of the step; above 1: nowhere
  int facet = -1;
  R b[3] = {R(0), R(0), R(0)};
};

/// Node and triangle at a share t of the step.
template <class R>
struct MovingTriangle {
  Vec3<R> start[4], motion[4];  ///< of the node and the corners

  GLISSON_HD MovingTriangle(const SurfaceView<R>& s, int node, const Corners& c) {
    const int k[4] = {node, c.n[0], c.n[1], c.n[2]};
    for (int i = 0; i < 4; ++i) start[i] = s.position_before(k[i]), motion[i] = xyz(s.motion[k[i]]);
  }
  GLISSON_HD Vec3<R> at(int i, R t) const { return start[i] + t * motion[i]; }
  /// Height of the node over the plane times twice the triangle's area.
  GLISSON_HD R volume(R t, Vec3<R>& area) const {
    const Vec3<R> a = at(1, t);
    area = cross(at(2, t) - a, at(3, t) - a);
    return dot(at(0, t) - a, area);
  }
  /// A root between `front`, where the volume is positive, and `back`: the chord's, where the end that stays
  /// counts half the second time (Dowell & Jarratt 1971), at most to the rounding of t.
  GLISSON_HD R crossing(R front, R volume_front, R back, R volume_back) const {
    Vec3<R> area;
    for (int i = 0, side = 0; i < 30 && back - front > R(1e-7); ++i) {
      const R t = front + (back - front) * (volume_front / (volume_front - volume_back));
      const R here = volume(t, area);
      if (here > R(0)) {
        front = t, volume_front = here;
        if (side == 1) volume_back *= R(0.5);
        side = 1;
      } else {
        if (!(t < back) || here == R(0)) return t;
        back = t, volume_back = here;
        if (side == 2) volume_front *= R(0.5);
        side = 2;
      }
    }
    return back;
  }
};

/// The point is in front of the triangle's plane at the beginning of the step and behind it at the end: the
/// time in between (the coplanarity cubic of Provot 1997 has one or three roots then).
template <class R>
GLISSON_HD void find_passage(const SurfaceView<R>& s, int node, int facet, R slack, Passage<R>& passage) {
  const MovingTriangle<R> moving(s, node, s.triangles[facet]);
  Vec3<R> area;
  const R after = moving.volume(R(1), area);
  if (!(after < R(0))) return;
  const R before = moving.volume(R(0), area);
  if (!(before > -slack * square_root(dot(area, area)))) return;
  const R t = before > R(0) ? moving.crossing(R(0), before, R(1), after) : R(0);
  const TrianglePoint<R> foot =
      closest_on_triangle(moving.at(0, t), moving.at(1, t), moving.at(2, t), moving.at(3, t));
  if (foot.distance_squared > slack * slack || !(t < passage.at)) return;
  passage.at = t;
  passage.facet = facet;
  for (int k = 0; k < 3; ++k) passage.b[k] = foot.b[k];
}

/// A node with the facets of one region that may meet it: the nearest that it faces counts (Johnsen 2016,
/// section 5.3.4.4), or the one that it went through in the step.
template <class R>
struct FindFacetTouch {
  static constexpr int cost = 200;
  SurfaceView<R> surface;
  const int *group_node, *group_begin, *facets;
  const R *bias, *friction, *entry;
  Touch<R>* touches;
  TouchLimits<R> limits;
  R swept;  ///< what went through a facet in this step is at most so far from it now; 0 where no node moves
            ///< so far that it could pass one unseen [m]

  GLISSON_HD void operator()(int g) const {
    Touch<R>& t = touches[g];
    t.used = false;
    const int node = group_node[g];
    const Vec3<R> p = surface.position(node);
    Passage<R> passage;
    R best = R(2) * limits.reach;
    int facet = -1;
    for (int i = group_begin[g]; i < group_begin[g + 1]; ++i) {
      const int f = facets[i];
      const R most = limits.reach < best - bias[i] ? limits.reach : best - bias[i];
      if (near_box(p, f, most)) {
        const R d = distance_to(p, f);
        if (d < most) {
          best = d + bias[i];
          facet = f;
        }
      }
      if (swept > R(0) && near_box(p, f, swept)) find_passage(surface, node, f, limits.slack, passage);
    }
    t.friction = friction[g];
    const bool passed = passage.facet >= 0 && t.came != came_from_behind;
    if (passed)
      t.used = touch_passed(t, g, passage);
    else if (facet >= 0)
      t.used = touch_nearest(t, g, facet, best);
    else
      t.came = came_from_nowhere;
    if (!t.used) t.pressing = R(0);
  }

 private:
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
  GLISSON_HD Vec3<R> corner(int facet, int k) const {
    return surface.position(surface.triangles[facet].n[k]);
  }
  /// False where the facet's box is farther than `most`, which spares most of the distances.
  GLISSON_HD bool near_box(const Vec3<R>& p, int facet, R most) const {
    const Vec3<R> a = corner(facet, 0), b = corner(facet, 1), c = corner(facet, 2);
    return near_range(p.x, a.x, b.x, c.x, most) && near_range(p.y, a.y, b.y, c.y, most) &&
           near_range(p.z, a.z, b.z, c.z, most);
  }
  GLISSON_HD static bool near_range(R p, R a, R b, R c, R most) {
    const R low = a < b ? (a < c ? a : c) : (b < c ? b : c);
    const R high = a > b ? (a > c ? a : c) : (b > c ? b : c);
    return p > low - most && p < high + most;
  }
  GLISSON_HD R distance_to(const Vec3<R>& p, int facet) const {
    return square_root(
        closest_on_triangle(p, corner(facet, 0), corner(facet, 1), corner(facet, 2)).distance_squared);
  }
  GLISSON_HD Vec3<R> normal_of(int facet) const {
    const Vec3<R> a = corner(facet, 0);
    return unit_or(cross(corner(facet, 1) - a, corner(facet, 2) - a), Vec3<R>{});
  }
  /// From the node to the point b of the facet.
  GLISSON_HD Vec3<R> to_point(int node, int facet, const R (&b)[3]) const {
    return b[0] * corner(facet, 0) + b[1] * corner(facet, 1) + b[2] * corner(facet, 2) -
           surface.position(node);
  }
  /// Mean normal of the facets that are as near as the nearest one, up to `slack`: at an edge or a vertex of
  /// the surface the force then does not depend on which of them is found first.
  GLISSON_HD Vec3<R> mean_normal(int g, R best) const {
    const Vec3<R> p = surface.position(group_node[g]);
    Vec3<R> sum;
    for (int i = group_begin[g]; i < group_begin[g + 1]; ++i) {
      const int f = facets[i];
      if (!near_box(p, f, best + limits.slack - bias[i])) continue;
      const R weight = R(1) - (distance_to(p, f) + bias[i] - best) / limits.slack;
      if (weight > R(0)) sum = sum + weight * normal_of(f);
    }
    return unit_or(sum, Vec3<R>{});
  }
  /// In front of the facet the gap is the distance and its normal the shortest way, which turns round edges
  /// without a jump.
  GLISSON_HD bool touch_nearest(Touch<R>& t, int g, int facet, R best) const {
    const int node = group_node[g];
    const TrianglePoint<R> foot =
        closest_on_triangle(surface.position(node), corner(facet, 0), corner(facet, 1), corner(facet, 2));
    const Vec3<R> way = to_point(node, facet, foot.b);
    const R out = dot(way, normal_of(facet)), distance = square_root(foot.distance_squared);
    const bool inside = foot.b[0] > R(1e-4) && foot.b[1] > R(1e-4) && foot.b[2] > R(1e-4);
    // beside the border of the facets that it faces a node is still held up to here, so that flush sides
    // that slip a little stay on each other
    const bool beside = !inside && (out < R(0) ? -out : out) < R(0.5) * distance;
    if (beside && distance > R(5) * limits.slack) {
      t.came = came_from_nowhere;
      return false;
    }
    const bool near = beside || distance < R(0.1) * limits.slack;
    set_nodes(t, node, facet, foot.b);
    t.normal = near || out > R(0) ? mean_normal(g, best) : (R(-1) / distance) * way;
    t.gap = -dot(t.normal, way) - limits.offset;
    return complete_touch(t, surface.motion, surface.guess, limits, entry[g]);
  }
  GLISSON_HD bool touch_passed(Touch<R>& t, int g, const Passage<R>& passage) const {
    const int node = group_node[g];
    t.came = came_from_front;
    set_nodes(t, node, passage.facet, passage.b);
    t.normal = normal_of(passage.facet);
    t.gap = -dot(t.normal, to_point(node, passage.facet, passage.b)) - limits.offset;
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
  TouchLimits<R> limits;

  GLISSON_HD void operator()(int i) const {
    Touch<R>& t = touches[i];
    const int came = t.came;
    t.came = came_from_nowhere;
    t.used = touch(t, i, came);
    if (!t.used) t.pressing = R(0);
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
