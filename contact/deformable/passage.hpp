// Where the path of a point goes through a triangle that moves as well: what a fast node passes in a step.
#pragma once

#include <glisson/contact/deformable/surface_view.hpp>
#include <glisson/contact/geometry/closest_points.hpp>

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

}  // namespace glisson::contact
