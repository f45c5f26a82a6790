#include <glisson/contact/rate_distance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glisson/contact/geometry/lower_quartile.hpp>
#include <glisson/contact/geometry/triangles.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/mesh/triangles.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<Facet> facets_of_bodies(const Model& model) {
  std::vector<Facet> facets = outer_surface(model.mesh);
  for (const Facet& facet : facets_of(model.mesh.triangles)) facets.push_back(facet);
  return facets;
}

/// Lower quartile of the facets that have one of the nodes, or of all if none is listed; infinite without any
/// [m].
double edge_length_at(const std::vector<int>& nodes, const std::vector<Facet>& facets, const Mesh& mesh) {
  std::vector<bool> listed(mesh.X.size(), nodes.empty());
  for (const int n : nodes) listed[at(n)] = true;
  std::vector<double> lengths;
  for (const Facet& facet : facets) {
    const auto begin = facet.nodes.begin(), end = begin + facet.node_count();
    if (std::none_of(begin, end, [&](int n) { return listed[at(n)]; })) continue;
    for (auto n = begin; n != end; ++n) {
      const auto side = mesh.X[at(*n)] - mesh.X[at(n + 1 == end ? *begin : n[1])];
      lengths.push_back(std::sqrt(dot(side, side)));
    }
  }
  return lengths.empty() ? std::numeric_limits<double>::infinity() : lower_quartile(std::move(lengths));
}

void refuse_far(double distance, const RigidSurface& surface, double edge) {
  if (within_half_an_edge(distance, edge)) return;
  throw Error(ErrorKind::input,
              "it slows approaches below " + number_text(distance) + " (RateConstraintDistance" +
                  (surface.distance ? "" : " of SystemParams, by default ten times ContactSafetyMargin") +
                  "), too much for surface edges of " + number_text(edge) +
                  " of the body: it can be half of an edge. Make it smaller",
              {"", 0, surface.name});
}

/// 0 without facets [m]
double rate_distance_of(const std::vector<Facet>& facets, const Mesh& mesh) {
  if (facets.empty()) return 0;
  const TriangleSizes sizes = triangle_sizes(split_facets(facets, mesh.X), mesh.X);
  return rate_distance(sizes.smallest, sizes.largest);
}

}  // namespace

std::vector<double> rate_distances(const Model& model) {
  const std::vector<Facet> facets = facets_of_bodies(model);
  std::optional<double> of_mesh;
  std::vector<double> result;
  for (const RigidSurface& surface : model.surfaces) {
    const std::optional<double> told = surface.distance ? surface.distance : model.contact.distance;
    if (surface.penalty) {
      result.push_back(0);
    } else if (told) {
      refuse_far(*told, surface, edge_length_at(surface.nodes, facets, model.mesh));
      result.push_back(*told);
    } else {
      if (!of_mesh) of_mesh = rate_distance_of(facets, model.mesh);
      result.push_back(*of_mesh);
    }
  }
  return result;
}

}  // namespace glisson::contact
