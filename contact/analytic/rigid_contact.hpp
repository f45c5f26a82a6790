// Frictionless contact of nodes with an analytic rigid body, by the force that ends each step on its surface.
#pragma once

#include <algorithm>
#include <vector>

#include <glisson/contact/analytic/rigid_motion.hpp>
#include <glisson/core/loads/list_forces.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson::contact {

/// State of a contact pair at the last step of a run with energies.
struct ContactReport {
  double depth = 0;          ///< largest penetration of the nodes [m]
  double largest_depth = 0;  ///< the same over the run [m]
  int node_count = 0;        ///< nodes that were pushed
  Vec3<double> force;        ///< of the body on the nodes [N]
};
/// What reports contact; every provider of make_rigid_bodies does (dynamic_cast).
class ContactSource {
 public:
  virtual ~ContactSource() = default;
  virtual ContactReport report() const = 0;
};

/// With u(t + dt) = u_predicted + advance_per_force f / m, the force f = m depth out / advance_per_force ends
/// the step on the surface of the body at t + dt (the kinematic correction of Johnsen 2016, section 4.5.8.1,
/// written as a force).
template <class R, class Shape>
struct ContactForce : LastForces<R> {
  Shape shape;
  Vec3<R> shift;        ///< of the body [m]
  const Vec4<R>* X;     ///< rest position relative to the body's reference point [m]  [entry_count]
  const Vec4<R>* u;     ///< displacement [m]                                          [node_count]
  const Vec4<R>* v;     ///< w: 1/mass [1/kg]                                          [node_count]
  R advance_per_force;  ///< [s^2]

  GLISSON_HD Penetration<R> penetration(int i, int n) const { return shape(xyz(X[i]) + xyz(u[n]) - shift); }
  GLISSON_HD Vec3<R> force(int i, int n) const {
    const Penetration<R> p = penetration(i, n);
    const R mobility = advance_per_force * v[n].w;
    return p.depth > R(0) && mobility > R(0) ? (p.depth / mobility) * p.out : Vec3<R>{};
  }
};

/// Part of a report from one chunk of nodes.
struct ContactPart {
  double depth = 0, largest_depth = 0;
  int node_count = 0;
  Vec3<double> force;
};
template <class R, class Shape>
struct CollectReport {
  ContactForce<R, Shape> now;   ///< body and nodes at t
  ContactForce<R, Shape> next;  ///< as predicted for t + dt
  const int* nodes;             ///< [entry_count]
  int entry_count;
  ContactPart* parts;  ///< [ceil(entry_count / entries_per_sum)]

  GLISSON_HD void operator()(int c) const {
    const int end = entry_count < (c + 1) * entries_per_sum ? entry_count : (c + 1) * entries_per_sum;
    ContactPart part;
    part.largest_depth = parts[c].largest_depth;
    for (int i = c * entries_per_sum; i < end; ++i) {
      const double depth = double(now.penetration(i, nodes[i]).depth);
      if (depth > part.depth) part.depth = depth;
      const Vec3<R> f = next.force(i, nodes[i]);
      part.force = part.force + Vec3<double>{double(f.x), double(f.y), double(f.z)};
      part.node_count += f.x != R(0) || f.y != R(0) || f.z != R(0);
    }
    if (part.depth > part.largest_depth) part.largest_depth = part.depth;
    parts[c] = part;
  }
};

template <Backend B, class R, class Shape>
class RigidContact final : public ForceProvider<R>, public ContactSource {
 public:
  RigidContact(B& backend, const RigidBody& body, const Mesh& mesh, const Numbering& numbering)
      : RigidContact(backend, RigidMotion(body), entries_of(RigidMotion(body), mesh, numbering)) {}

  std::string_view name() const override { return motion_.body().name; }
  Space space() const override { return B::space; }
  bool needs_prediction() const override { return true; }
  void add_forces(const StepView<R>& step) override {
    if (count_ == 0) return;
    // a caller that leaves t_next at 0 means t + dt
    const ContactForce<R, Shape> next =
        rule(step, step.t_next >= step.t ? step.t_next : step.t + step.dt, step.u_predicted);
    if (work_.counts(step))
      backend_.for_each(work_.chunk_count(), CollectReport<R, Shape>{rule(step, step.t, step.u), next,
                                                                     nodes_.get(), count_, parts_.get()});
    work_.run(step, nodes_.get(), next);
  }
  double work() const override { return work_.total(); }
  ContactReport report() const override {
    std::vector<ContactPart> parts(std::size_t(work_.chunk_count()));
    if (!parts.empty()) backend_.copy_out(parts_.get(), parts.data(), parts.size());
    ContactReport sum;
    for (const ContactPart& part : parts) {
      sum.depth = std::max(sum.depth, part.depth);
      sum.largest_depth = std::max(sum.largest_depth, part.largest_depth);
      sum.node_count += part.node_count;
      sum.force = sum.force + part.force;
    }
    return sum;
  }
  std::vector<std::byte> save() const override {
    detail::ByteWriter out;
    out.buffer(backend_, last_, std::size_t(count_))
        .buffer(backend_, parts_, std::size_t(work_.chunk_count()));
    work_.save(out);
    return out.take();
  }
  void load(std::span<const std::byte> bytes) override {
    detail::ByteReader in(bytes, motion_.body().name);
    in.buffer(backend_, last_, std::size_t(count_));
    in.buffer(backend_, parts_, std::size_t(work_.chunk_count()));
    work_.load(in);
    in.end();
  }

 private:
  using Entries = std::map<int, Vec4<R>>;
  static Entries entries_of(const RigidMotion& motion, const Mesh& mesh, const Numbering& numbering) {
    const std::vector<int> nodes = candidate_nodes(motion.body(), mesh);
    return detail::by_node<Vec4<R>>(
        numbering, nodes,
        [&](std::size_t k) { return detail::narrow<R>(mesh.X[std::size_t(nodes[k])] - motion.reference()); },
        [](Vec4<R>&, const Vec4<R>&) {});
  }
  static std::vector<Vec4<R>> values(const Entries& entries) {
    std::vector<Vec4<R>> result;
    for (const auto& [node, value] : entries) result.push_back(value);
    return result;
  }
  RigidContact(B& backend, RigidMotion motion, const Entries& entries)
      : backend_(backend),
        motion_(std::move(motion)),
        count_(static_cast<int>(entries.size())),
        nodes_(detail::upload(backend, detail::keys(entries))),
        X_(detail::upload(backend, values(entries))),
        last_(detail::zeros<Vec4<R>>(backend, entries.size())),
        work_(backend, count_),
        parts_(detail::zeros<ContactPart>(backend, std::size_t(work_.chunk_count()))) {}

  ContactForce<R, Shape> rule(const StepView<R>& step, double t, const Vec4<R>* u) const {
    ContactForce<R, Shape> result{
        {last_.get()}, {}, narrowed<R>(motion_.shift(t)), X_.get(), u, step.v, step.advance_per_force};
    shape_at(motion_, t, result.shape);
    return result;
  }

  B& backend_;
  RigidMotion motion_;
  int count_;
  Buffer<int> nodes_;
  Buffer<Vec4<R>> X_, last_;
  ListWork<B, R> work_;
  Buffer<ContactPart> parts_;
};

}  // namespace glisson::contact
