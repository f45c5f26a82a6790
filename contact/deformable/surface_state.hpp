// The surface of the deformable bodies in a backend's memory.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <glisson/contact/deformable/candidates.hpp>
#include <glisson/contact/deformable/contact_mesh.hpp>
#include <glisson/contact/deformable/surface_view.hpp>
#include <glisson/contact/free_axes.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson::contact {

template <Backend B, class R>
class SurfaceState {
 public:
  /// The mesh must outlive it.
  SurfaceState(B& backend, const ContactMesh& mesh, const Model& model, const Numbering& numbering)
      : backend_(backend),
        mesh_(mesh),
        count_(mesh.node_count()),
        nodes_(detail::upload(backend, internal_nodes(mesh, numbering))),
        X_(detail::upload(backend, rest(mesh))),
        free_axes_(detail::upload(backend, free_axes_of(mesh.nodes, model, numbering))),
        triangles_(detail::upload(backend, corners(mesh.triangles))),
        quads_(detail::upload(backend, corners(mesh.quads))),
        side_nodes_(detail::upload(backend, side_nodes(mesh))),
        side_distances_(detail::upload(backend, side_distances(mesh))),
        side_around_begin_(detail::upload(backend, side_around_begin(mesh))),
        side_around_(detail::upload(backend, side_around(mesh))),
        to_(detail::zeros<Vec4<R>>(backend, mesh.X.size())),
        motion_(detail::zeros<Vec4<R>>(backend, mesh.X.size())),
        guess_(detail::zeros<Vec4<R>>(backend, mesh.nodes.size())),
        reference_(detail::zeros<Vec4<R>>(backend, mesh.nodes.size())),
        wanted_(detail::zeros<unsigned char>(backend, mesh.nodes.size())),
        extents_(detail::zeros<Extent<R>>(backend, std::size_t(chunk_count()))),
        host_extents_(std::size_t(chunk_count())),
        host_(mesh.nodes.size()) {}

  int count() const { return count_; }
  const int* nodes() const { return nodes_.get(); }
  SurfaceView<R> view() const {
    return {nodes_.get(), X_.get(),          free_axes_.get(), triangles_.get(),
            quads_.get(), side_nodes_.get(), count_,           mesh_.corner_count(),
            to_.get(),    motion_.get(),     guess_.get()};
  }

  /// Takes the positions of a step that starts with last step's contact forces; all_points: of all points,
  /// not only of those that the candidates are made of.
  void place(const StepView<R>& step, const Vec4<R>* force, bool all_points) {
    backend_.for_each(chunk_count(), PlaceSurface<R>{view(), step.u, step.u_predicted, step.v, force,
                                                     reference_.get(), extents_.get(), step.advance_per_force,
                                                     all_points ? nullptr : wanted_.get(), afresh_});
    backend_.for_each(
        static_cast<int>(mesh_.beside.size()),
        PlaceSidePoints<R>{view(), side_distances_.get(), side_around_begin_.get(), side_around_.get()});
    backend_.for_each(static_cast<int>(mesh_.quads.size()), PlaceCentres<R>{view()});
  }
  /// Whether place() may leave points out. Those beside nodes and in facets follow nodes around them, and
  /// devices have a thread for each.
  bool may_leave_points() const {
    return B::space == Space::host && mesh_.beside.empty() && mesh_.quads.empty();
  }
  /// listed: nodes that contact pushes, or did last; the corners beside edges are looked at too.
  void want(const std::vector<int>& listed, const Candidates& found) {
    if (!may_leave_points()) return;
    std::vector<unsigned char> wanted(mesh_.nodes.size(), 0);
    for (const int node : listed) wanted[std::size_t(node)] = 1;
    for (const auto& pair : found.edge_pairs)
      for (const int e : pair)
        for (const int node : mesh_.edges[std::size_t(e)].opposite) wanted[std::size_t(node)] = 1;
    backend_.copy_in(wanted.data(), wanted_.get(), wanted.size());
  }
  /// Largest squares of drift and motion in the steps since forget_extent(), NaN if any is. Waits for a
  /// device.
  Extent<R> extent() const {
    std::vector<Extent<R>>& parts = host_extents_;
    backend_.copy_out(extents_.get(), parts.data(), parts.size());
    Extent<R> all;
    for (const Extent<R>& part : parts) all.widen(part);
    return all;
  }
  /// The next place() begins anew.
  void forget_extent() { afresh_ = true; }
  /// Later ones go on; evaluations that leave no trace do not call it.
  void keep_extent() { afresh_ = false; }
  /// From now on drift is measured from the present predicted positions.
  void mark() {
    backend_.copy_out(to_.get(), host_.data(), host_.size());
    set_reference();
  }
  void save(detail::ByteWriter& out) const {
    out.buffer(backend_, reference_, host_.size()).value(afresh_ ? Extent<R>{} : extent());
  }
  void load(detail::ByteReader& in) {
    in.buffer(backend_, reference_, host_.size());
    backend_.copy_out(reference_.get(), host_.data(), host_.size());
    std::fill(host_extents_.begin(), host_extents_.end(), Extent<R>{});
    Extent<R> kept;
    in.value(kept);
    if (!host_extents_.empty()) host_extents_[0] = kept;
    backend_.copy_in(host_extents_.data(), extents_.get(), host_extents_.size());
    afresh_ = false;
  }
  /// Positions that drift is measured from, on the host  [point_count]
  void reference_to(std::vector<Vec3<double>>& x) const {
    x.clear();
    for (const Vec4<R>& p : host_) x.push_back({double(p.x), double(p.y), double(p.z)});
    mesh_.append_points(x);
  }

 private:
  int chunk_count() const { return chunks_of(count_, PlaceSurface<R>::chunk); }
  void set_reference() { backend_.copy_in(host_.data(), reference_.get(), host_.size()); }
  static std::vector<int> internal_nodes(const ContactMesh& mesh, const Numbering& numbering) {
    std::vector<int> result;
    for (const int n : mesh.nodes) result.push_back(detail::internal_node(numbering, n));
    return result;
  }
  static std::vector<Vec4<R>> rest(const ContactMesh& mesh) {
    std::vector<Vec4<R>> result;
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k) result.push_back(detail::narrow<R>(mesh.X[k]));
    return result;
  }
  static std::vector<int> side_nodes(const ContactMesh& mesh) {
    std::vector<int> result;
    for (const SidePoint& p : mesh.beside) result.push_back(p.node);
    return result;
  }
  static std::vector<R> side_distances(const ContactMesh& mesh) {
    std::vector<R> result;
    for (const SidePoint& p : mesh.beside) result.push_back(R(p.distance));
    return result;
  }
  static std::vector<int> side_around_begin(const ContactMesh& mesh) {
    std::vector<int> result;
    const int first = mesh.around_begin[std::size_t(mesh.node_count())];
    for (int p = mesh.node_count(); p <= mesh.corner_count(); ++p)
      result.push_back(mesh.around_begin[std::size_t(p)] - first);
    return result;
  }
  static std::vector<int> side_around(const ContactMesh& mesh) {
    const auto first = mesh.around.begin();
    return {first + mesh.around_begin[std::size_t(mesh.node_count())],
            first + mesh.around_begin[std::size_t(mesh.corner_count())]};
  }
  static std::vector<Corners> corners(const std::vector<std::array<int, 3>>& from) {
    std::vector<Corners> result;
    for (const auto& c : from) result.push_back({{c[0], c[1], c[2]}});
    return result;
  }
  static std::vector<Quad> corners(const std::vector<std::array<int, 4>>& from) {
    std::vector<Quad> result;
    for (const auto& q : from) result.push_back({{q[0], q[1], q[2], q[3]}});
    return result;
  }

  B& backend_;
  const ContactMesh& mesh_;
  int count_;
  Buffer<int> nodes_;
  Buffer<Vec4<R>> X_;
  Buffer<int> free_axes_;
  Buffer<Corners> triangles_;
  Buffer<Quad> quads_;
  Buffer<int> side_nodes_;
  Buffer<R> side_distances_;
  Buffer<int> side_around_begin_, side_around_;
  Buffer<Vec4<R>> to_, motion_, guess_, reference_;
  Buffer<unsigned char> wanted_;
  Buffer<Extent<R>> extents_;
  mutable std::vector<Extent<R>> host_extents_;
  bool afresh_ = true;         ///< what extents_ holds is of no use any more
  std::vector<Vec4<R>> host_;  ///< copy of reference_
};

}  // namespace glisson::contact
