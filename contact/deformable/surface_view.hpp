// Loop body that follows the surface: where its nodes go in a step.
#pragma once

#include <glisson/contact/deformable/side_normal.hpp>
#include <glisson/core/loads/list_forces.hpp>

namespace glisson::contact {

struct Corners {
  int n[3];
};

struct Quad {
  int n[4];
};

/// The surface on the backend; points are numbered as in ContactMesh.
template <class R>
struct SurfaceView {
  const int* nodes;          ///< internal node                              [node_count]
  const Vec4<R>* X;          ///< rest position [m]                          [node_count]
  const int* free_axes;      ///< bit mask of axes that are not constrained  [node_count]
  const Corners* triangles;  ///< points                                     [triangle_count]
  const Quad* quads;         ///< corners of the points from corner_count on
  const int* side_node;      ///< node of the points from node_count to corner_count
  int node_count, corner_count;
  /// Position at the end of the step if contact pushes as in the last one [m]: near the true one, so that
  /// feet and normals are those of surfaces that touch; w: what a force moves the node by [m/N].
  Vec4<R>* to;      ///<                                              [point_count]
  Vec4<R>* motion;  ///< from the beginning of the step to there [m]  [point_count]
  Vec4<R>* guess;   ///< what of it contact does [m]                  [node_count]

  GLISSON_HD int node_of(int corner) const {
    return corner < node_count ? corner : side_node[corner - node_count];
  }
  GLISSON_HD Vec3<R> position(int k) const { return xyz(to[k]); }
  GLISSON_HD Vec3<R> position_before(int k) const { return xyz(to[k]) - xyz(motion[k]); }
  /// Motion of a node by a contact force.
  GLISSON_HD Vec3<R> moved_by(int k, const Vec4<R>& force) const {
    const int free = free_axes[k];
    const R mobility = to[k].w;
    return {free & 1 ? mobility * force.x : R(0), free & 2 ? mobility * force.y : R(0),
            free & 4 ? mobility * force.z : R(0)};
  }
};

/// Over a chunk of nodes, and over the steps since somebody looked.
template <class R>
struct Extent {
  /// Range of the displacements since the candidates were found, at both ends of the step [m]. What all nodes
  /// have in common brings nothing nearer to anything.
  Vec3<R> low{R(3e38), R(3e38), R(3e38)}, high{R(-3e38), R(-3e38), R(-3e38)};
  R motion = R(0);  ///< largest square of the motion in the step [m^2]; NaN and infinite motions leave NaN

  GLISSON_HD void widen(const Extent& other) {
    low = {least(low.x, other.low.x), least(low.y, other.low.y), least(low.z, other.low.z)};
    high = {most(high.x, other.high.x), most(high.y, other.high.y), most(high.z, other.high.z)};
    // without a branch, which a core could not guess
    motion = most(motion, other.motion) + R(0) * (motion + other.motion);
  }
  /// No node is farther than this from a displacement that is the same for all [m].
  double drift() const {
    const double x = half(low.x, high.x), y = half(low.y, high.y), z = half(low.z, high.z);
    return std::sqrt(x * x + y * y + z * z);
  }

 private:
  GLISSON_HD static R least(R a, R b) { return a < b ? a : b; }
  GLISSON_HD static R most(R a, R b) { return a > b ? a : b; }
  static double half(R low, R high) { return low < high ? 0.5 * (double(high) - double(low)) : 0; }
};

template <class R>
struct PlaceSurface {
  static constexpr int chunk = 64, cost = 4 * chunk;
  SurfaceView<R> surface;
  const Vec4<R>*u, *u_predicted, *v;  ///< w of v: 1/mass  [node_count]
  const Vec4<R>* force;               ///< of contact in the last step [N]
  const Vec4<R>* reference;           ///< positions that the candidates were found at [m]
  Extent<R>* extents;                 ///< [ceil(node_count / chunk)]
  R advance_per_force;                ///< [s^2]
  const unsigned char* wanted;        ///< nodes whose place somebody asks for; null: all  [node_count]
  bool afresh;                        ///< nobody wants the extents of the steps before

  using Sum = Extent<R>;
  GLISSON_HD int entry_count() const { return surface.node_count; }
  GLISSON_HD void add(int k, Sum& extent) const {
    const int n = surface.nodes[k];
    Vec3<R> d = xyz(u_predicted[n]) - xyz(u[n]), p = xyz(surface.X[k]) + xyz(u_predicted[n]);
    if (!wanted || wanted[k]) {  // contact pushes no others
      surface.to[k].w = advance_per_force * v[n].w;
      const Vec3<R> push = surface.moved_by(k, force[k]);
      d = d + push;
      p = p + push;
      surface.to[k] = {p.x, p.y, p.z, surface.to[k].w};
      surface.motion[k] = {d.x, d.y, d.z, R(0)};
      surface.guess[k] = {push.x, push.y, push.z, R(0)};
    }
    const Vec3<R> drift = p - xyz(reference[k]), before = drift - d;
    extent.widen({drift, drift, dot(d, d)});
    extent.widen({before, before, R(0)});
  }
  GLISSON_HD static void join(Sum& a, const Sum& b) { a.widen(b); }
  GLISSON_HD void leave(int c, const Sum& extent) const {
    Sum all = afresh ? Sum{} : extents[c];
    all.widen(extent);
    extents[c] = all;
  }
  GLISSON_HD void operator()(int c) const { run_chunk(*this, c); }
};

/// Points beside nodes follow the normal of the facets around them.
template <class R>
struct PlaceSidePoints {
  static constexpr int cost = 60;
  SurfaceView<R> surface;
  const R* distance;        ///< [side points]
  const int* around_begin;  ///< [side points + 1]
  const int* around;        ///< triangles

  GLISSON_HD void operator()(int i) const {
    const int k = surface.node_count + i, n = surface.side_node[i];
    const Vec3<R> out = distance[i] * normal(i, [&](int m) { return surface.position(m); });
    const Vec3<R> before = distance[i] * normal(i, [&](int m) { return surface.position_before(m); });
    const Vec3<R> p = surface.position(n) + out, d = xyz(surface.motion[n]) + (out - before);
    surface.to[k] = {p.x, p.y, p.z, R(0)};
    surface.motion[k] = {d.x, d.y, d.z, R(0)};
  }

 private:
  template <class At>
  GLISSON_HD Vec3<R> normal(int i, At at) const {
    const int point = surface.node_count + i, first = around_begin[i];
    const auto place = [&](int p) {
      if (p < surface.corner_count) return at(surface.node_of(p));
      const Quad& q = surface.quads[p - surface.corner_count];
      return R(0.25) * ((at(surface.node_of(q.n[0])) + at(surface.node_of(q.n[1]))) +
                        (at(surface.node_of(q.n[2])) + at(surface.node_of(q.n[3]))));
    };
    return side_normal<R>(
        around + first, around_begin[i + 1] - first,
        [&](int t, int corner) { return place(surface.triangles[t].n[corner]); },
        [&](int t) {
          const Corners& c = surface.triangles[t];
          return c.n[0] == point ? 0 : c.n[1] == point ? 1 : 2;
        });
  }
};

/// The centres of the quads follow their corners.
template <class R>
struct PlaceCentres {
  static constexpr int cost = 10;
  SurfaceView<R> surface;

  GLISSON_HD void operator()(int q) const {
    const int k = surface.corner_count + q;
    surface.to[k] = mean(surface.to, surface.quads[q]);
    surface.motion[k] = mean(surface.motion, surface.quads[q]);
  }

 private:
  GLISSON_HD static Vec4<R> mean(const Vec4<R>* of, const Quad& q) {
    const Vec3<R> m = R(0.25) * ((xyz(of[q.n[0]]) + xyz(of[q.n[1]])) + (xyz(of[q.n[2]]) + xyz(of[q.n[3]])));
    return {m.x, m.y, m.z, R(0)};
  }
};

}  // namespace glisson::contact
