// Contact of nodes with a rigid surface mesh.
#pragma once

#include <glisson/contact/analytic/rigid_motion.hpp>
#include <glisson/contact/list_contact.hpp>
#include <glisson/contact/rigid_response.hpp>
#include <glisson/contact/surface/surface_data.hpp>

namespace glisson::contact {

/// Where a node was, in the surface's frame, when the surface was last looked at for it, and what of
/// Surroundings holds there: so it need not be looked at again before the node leaves what is clear.
template <class R>
struct SeenSurface {
  Vec3<R> at;                      ///< [m]
  R clear = R(0), closest = R(0);  ///< [m]
};

/// All in the surface's frame, where it stands still: a node comes from q0 and would end the step at q1.
template <class R>
struct SurfaceForce : LastForces<R> {
  SurfaceShape<R> shape;
  Mat3<R> turn;         ///< of the surface at the end of the step
  Mat3<R> turned;       ///< turn less that at its beginning
  Vec3<R> shift;        ///< at the beginning [m]
  Vec3<R> shifted;      ///< during the step [m]
  const Vec4<R>* X;     ///< rest position from the data's centre, w: half thickness of a shell [m]
  const Vec4<R>* from;  ///< displacement at the beginning [m]                     [node_count]
  const Vec4<R>* to;    ///< and, as predicted, at the end [m]                     [node_count]
  const Vec4<R>* v;     ///< w: 1/mass [1/kg]                                      [node_count]
  R advance_per_force;  ///< [s^2]
  RigidResponse<R> response;
  AllowedDepth<R> allowed;
  /// Of forces that were asked for last: nothing was near on the way of the node, nor at its beginning, so
  /// that a report need not look there again  [entry_count]
  unsigned char* far_off;
  SeenSurface<R>* seen;  ///< [entry_count]

  /// Motion relative to the surface. Differences come first, so that float keeps a slow slip.
  GLISSON_HD Vec3<R> slip(int i, int n) const {
    const Vec3<R> before = xyz(X[i]) + xyz(from[n]) - shift;
    return transposed_times(turn, xyz(to[n]) - xyz(from[n]) - shifted) + transposed_times(turned, before);
  }
  /// Depth -gap in front of the surface, down to -response.close, from where on there is nothing.
  GLISSON_HD Penetration<R> penetration(int i, int n, const Vec3<R>& slipped, bool& far) const {
    const Vec3<R> q = transposed_times(turn, xyz(X[i]) + xyz(to[n]) - shift - shifted);
    const R offset = X[i].w + response.close;
    const Vec3<R> moved = q - seen[i].at;
    far = stays_clear(seen[i].clear - offset, q, moved, slipped);
    if (far) return none();
    // a facet lies nearer than this: a hint that spares looking at others
    const R known = seen[i].closest + square_root(dot(moved, moved)) + R(1e-3) * shape.reach;
    Surroundings<R> around;
    Penetration<R> p =
        shape.penetration(q - slipped, q, offset, around, seen[i].closest > R(0) ? known : R(0));
    seen[i] = {q, around.clear, around.closest};
    far = around.far;
    p.depth -= response.close;
    p.depth -= allowed(i);
    return p;
  }
  GLISSON_HD Penetration<R> penetration(int i, int n) const {
    bool far;
    return far_off[i] ? none() : penetration(i, n, slip(i, n), far);
  }
  GLISSON_HD Vec3<R> force(int i, int n) const {
    bool far = false;
    const Vec3<R> path = slip(i, n);
    const Penetration<R> p = penetration(i, n, path, far);
    far_off[i] = far;
    if (far) return {};
    const R mobility = advance_per_force * v[n].w;
    return mobility > R(0) ? (R(1) / mobility) * times(turn, response(p, path)) : Vec3<R>{};
  }

 private:
  GLISSON_HD Penetration<R> none() const {
    Penetration<R> nothing;
    nothing.depth = R(0) - response.close;
    return nothing;
  }
  /// All of the way to q lies in what is clear, by more than rounding.
  GLISSON_HD static bool stays_clear(R clear, const Vec3<R>& q, const Vec3<R>& moved,
                                     const Vec3<R>& slipped) {
    const R room = clear - sum_of_sizes(slipped) - R(1e-6) * (sum_of_sizes(q) + sum_of_sizes(moved));
    return room > R(0) && dot(moved, moved) < room * room;
  }
  GLISSON_HD static R sum_of_sizes(const Vec3<R>& a) { return size(a.x) + size(a.y) + size(a.z); }
  GLISSON_HD static R size(R a) { return a < R(0) ? -a : a; }
};

template <class R>
Mat3<R> narrowed(const Mat3<double>& a) {
  Mat3<R> result;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) result.m[i][k] = R(a.m[i][k]);
  return result;
}

template <Backend B, class R>
class SurfaceContact final : public ListContact<B, R> {
 public:
  /// half_thickness: of shells at the nodes of the mesh; close: gap below which an approach is slowed [m]
  SurfaceContact(B& backend, const RigidSurface& surface, const SurfaceData& data,
                 const std::vector<int>& nodes, const std::vector<double>& half_thickness,
                 StartRelease<B, R> start, const Mesh& mesh, const Numbering& numbering, double close)
      : ListContact<B, R>(backend, surface.name,
                          ListContact<B, R>::entries_of(nodes, data.centre, mesh, numbering, half_thickness),
                          std::move(start)),
        surface_(surface),
        centre_(data.centre),
        reach_(R(data.reach)),
        close_(R(close)),
        node_count_(static_cast<int>(data.nodes.size())),
        far_off_(detail::zeros<unsigned char>(backend, nodes.size())),
        seen_(detail::zeros<SeenSurface<R>>(backend, nodes.size())),
        nodes_(detail::upload(backend, nodes_of_tree(data))),
        facets_(detail::upload(backend, facets_of_surface(data))) {}

  void add_forces(const StepView<R>& step) override {
    if (this->count() == 0) return;
    SurfaceForce<R> next = rule(step, step.t, this->end_of(step), step.u_predicted);
    next.allowed = this->allowed_depth(this->end_of(step));
    this->touch(step, rule(step, step.t, step.t, step.u), next);
  }
  ContactReport report() const override {
    ContactReport report = ListContact<B, R>::report();
    report.search.volumes = node_count_;
    return report;
  }

 private:
  static std::vector<SurfaceNode<R>> nodes_of_tree(const SurfaceData& data) {
    std::vector<SurfaceNode<R>> result;
    for (const auto& n : data.nodes)
      result.push_back({narrowed<R>(n.low), narrowed<R>(n.high), n.skip, n.facet});
    return result;
  }
  static std::vector<SurfaceFacet<R>> facets_of_surface(const SurfaceData& data) {
    std::vector<SurfaceFacet<R>> result(data.facets.size());
    for (std::size_t f = 0; f < result.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const SurfaceFacet<double>& from = data.facets[f];
        result[f].smooth.x[k] = narrowed<R>(from.smooth.x[k]);
        result[f].smooth.n[k] = narrowed<R>(from.smooth.n[k]);
        result[f].edge_normal[k] = narrowed<R>(from.edge_normal[k]);
        result[f].border_edge[k] = from.border_edge[k];
        result[f].border_corner[k] = from.border_corner[k];
      }
    return result;
  }
  SurfaceForce<R> rule(const StepView<R>& step, double t, double t_end, const Vec4<R>* to) const {
    const SurfacePose begin = pose_about(centre_, surface_, t), end = pose_about(centre_, surface_, t_end);
    Mat3<double> turned;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) turned.m[i][k] = end.turn.m[i][k] - begin.turn.m[i][k];
    SurfaceForce<R> rule;
    rule.last = this->last();
    rule.shape = {nodes_.get(), facets_.get(), node_count_, reach_};
    rule.turn = narrowed<R>(end.turn);
    rule.turned = narrowed<R>(turned);
    rule.shift = narrowed<R>(begin.shift);
    rule.shifted = narrowed<R>(end.shift - begin.shift);
    rule.X = this->X();
    rule.from = step.u;
    rule.to = to;
    rule.v = step.v;
    rule.advance_per_force = step.advance_per_force;
    rule.response = {R(surface_.friction), R(surface_.penalty.value_or(1)), close_};
    rule.far_off = far_off_.get();
    rule.seen = seen_.get();
    return rule;
  }

  RigidSurface surface_;
  Vec3<double> centre_;  ///< of the nodes at rest, not of rotation: float keeps the digits of gaps [m]
  R reach_, close_;
  int node_count_;
  Buffer<unsigned char> far_off_;  ///< no state: set in each step before it is read
  Buffer<SeenSurface<R>> seen_;    ///< nor is this: it only spares looking where nothing can be
  Buffer<SurfaceNode<R>> nodes_;
  Buffer<SurfaceFacet<R>> facets_;
};

}  // namespace glisson::contact
