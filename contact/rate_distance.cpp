#include <glisson/contact/rate_distance.hpp>

#include <glisson/contact/geometry/triangles.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/mesh/triangles.hpp>

namespace glisson::contact {

double rate_distance_of(const Model& model) {
  std::vector<Facet> facets = outer_surface(model.mesh);
  for (const Facet& facet : facets_of(model.mesh.triangles)) facets.push_back(facet);
  if (facets.empty()) return 0;
  const TriangleSizes sizes = triangle_sizes(split_facets(facets, model.mesh.X), model.mesh.X);
  return rate_distance(sizes.smallest, sizes.largest);
}

}  // namespace glisson::contact
