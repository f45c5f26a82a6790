// All rigid surfaces of a model as contact providers of a backend. Include it only where a backend is
// instantiated.
#pragma once

#include <memory>
#include <vector>

#include <glisson/contact/bvh/box.hpp>
#include <glisson/contact/rate_distance.hpp>
#include <glisson/contact/shell_thickness.hpp>
#include <glisson/contact/surface/surface_contact.hpp>
#include <glisson/contact/surface/surface_overlap.hpp>

namespace glisson::contact {

/// Of the box around the nodes at rest [m].
inline Vec3<double> middle_of(const std::vector<int>& nodes, const Mesh& mesh) {
  if (nodes.empty()) return {};
  Box box;
  for (const int n : nodes) box = united(box, mesh.X[static_cast<std::size_t>(n)]);
  return 0.5 * (box.low + box.high);
}

/// Appends them; the backend must outlive them. Throws Error(input) when nodes start behind a surface.
template <Backend B, class R>
void add_rigid_surfaces(B& backend, const Model& model, const Numbering& numbering,
                        std::vector<std::unique_ptr<ForceProvider<R>>>& to) {
  if (model.surfaces.empty()) return;
  const std::vector<double> half = half_thickness_at_nodes(model);
  const std::vector<double> close = rate_distances(model);
  for (std::size_t s = 0; s < model.surfaces.size(); ++s) {
    const RigidSurface& surface = model.surfaces[s];
    const std::vector<int> nodes = candidate_nodes(surface.nodes, model.mesh);
    const SurfaceData data = surface_data(surface.surface, middle_of(nodes, model.mesh));
    StartRelease<B, R> start(backend, start_depths(surface, data, nodes, half, model.mesh), nodes, numbering,
                             model.time);
    to.push_back(std::make_unique<SurfaceContact<B, R>>(backend, surface, data, nodes, half, std::move(start),
                                                        model.mesh, numbering, close[s]));
  }
}

}  // namespace glisson::contact
