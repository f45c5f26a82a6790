// Loads on facets of the current configuration X + u: follower pressure and traction.
#pragma once

#include <glisson/core/loads/facet_geometry.hpp>
#include <glisson/core/numbers/functions.hpp>

namespace glisson {

/// f = -p N / (2 corners), N = area vector of the current facet: positive pressure pushes against the outward
/// normal.
template <class R>
struct PressureOnFacets {
  const LoadFacet<R>* facets;  ///< [facet_count]
  const Vec4<R>* u;            ///< displacement [m]  [node_count]
  Vec4<R>* forces;             ///< on each corner [N]  [facet_count]
  R pressure;                  ///< [Pa]

  GLISSON_HD void operator()(int i) const {
    const LoadFacet<R> facet = facets[i];
    const R s = R(0) - pressure * facet.corner_share;
    const Vec3<R> g = s * facet.area_vector(u);
    forces[i] = {g.x, g.y, g.z, R(0)};
  }
};

/// f = t |N| / (2 corners): current area, direction fixed in space and as written.
template <class R>
struct TractionOnFacets {
  const LoadFacet<R>* facets;  ///< [facet_count]
  const Vec4<R>* u;            ///< displacement [m]  [node_count]
  Vec4<R>* forces;             ///< on each corner [N]  [facet_count]
  const Vec4<R>* traction;     ///< at amplitude 1 [Pa]  [facet_count]
  R amplitude;

  GLISSON_HD void operator()(int i) const {
    const LoadFacet<R> facet = facets[i];
    const Vec3<R> N = facet.area_vector(u);
    const R s = amplitude * facet.corner_share * square_root(dot(N, N));
    forces[i] = {s * traction[i].x, s * traction[i].y, s * traction[i].z, R(0)};
  }
};

/// What both have in common: facet forces, the sum per node, work and restart.
template <Backend B, class R>
class SurfaceLoad : public ForceProvider<R> {
 public:
  Space space() const override { return B::space; }
  void add_forces(const StepView<R>& step) override {
    if (facets_.facet_count() == 0) return;
    evaluate(step, curve_(step.t));
    work_.run(step, facets_.nodes(), facets_.gather());
  }
  double work() const override { return work_.total(); }
  std::vector<std::byte> save() const override {
    detail::ByteWriter out;
    out.buffer(backend_, facets_.last(), std::size_t(facets_.node_count()));
    work_.save(out);
    return out.take();
  }
  void load(std::span<const std::byte> bytes) override {
    detail::ByteReader in(bytes, std::string(this->name()));
    in.buffer(backend_, facets_.last(), std::size_t(facets_.node_count()));
    work_.load(in);
    in.end();
  }

 protected:
  SurfaceLoad(B& backend, const std::vector<Facet>& facets, LoadCurve curve, const Mesh& mesh,
              const Numbering& numbering)
      : backend_(backend),
        curve_(std::move(curve)),
        facets_(backend, facets, mesh.X, numbering),
        work_(backend, facets_.node_count()) {}
  /// Writes the forces on the corners of all facets.
  virtual void evaluate(const StepView<R>& step, double amplitude) = 0;

  B& backend_;
  LoadCurve curve_;
  FacetSet<B, R> facets_;
  ListWork<B, R> work_;
};

template <Backend B, class R>
class PressureLoad final : public SurfaceLoad<B, R> {
 public:
  PressureLoad(B& backend, const Pressure& load, const Mesh& mesh, const Numbering& numbering)
      : SurfaceLoad<B, R>(backend, load.facets, load.curve, mesh, numbering), magnitude_(load.magnitude) {}
  std::string_view name() const override { return "pressure"; }

 private:
  void evaluate(const StepView<R>& step, double amplitude) override {
    this->backend_.for_each(this->facets_.facet_count(),
                            PressureOnFacets<R>{this->facets_.facets(), step.u, this->facets_.forces(),
                                                R(amplitude * magnitude_)});
  }
  double magnitude_;  ///< [Pa]
};

template <Backend B, class R>
class TractionLoad final : public SurfaceLoad<B, R> {
 public:
  TractionLoad(B& backend, const Traction& load, const Mesh& mesh, const Numbering& numbering)
      : SurfaceLoad<B, R>(backend, load.facets, load.curve, mesh, numbering) {
    std::vector<Vec4<R>> values;
    for (std::size_t k = 0; k < load.facets.size(); ++k)
      values.push_back(detail::narrow<R>(detail::value_of(load.values, k, load.facets.size(), "tractions")));
    values_ = detail::upload(backend, values);
  }
  std::string_view name() const override { return "traction"; }

 private:
  void evaluate(const StepView<R>& step, double amplitude) override {
    this->backend_.for_each(this->facets_.facet_count(),
                            TractionOnFacets<R>{this->facets_.facets(), step.u, this->facets_.forces(),
                                                values_.get(), R(amplitude)});
  }
  Buffer<Vec4<R>> values_;
};

}  // namespace glisson
