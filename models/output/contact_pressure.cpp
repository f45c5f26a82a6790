#include <glisson/models/output/contact_pressure.hpp>

#include <cmath>

#include <glisson/core/mesh/surface.hpp>

namespace glisson {

std::vector<double> nodal_pressure(const Mesh& mesh, std::span<const Vec3<double>> displacement,
                                   std::span<const Vec3<double>> force) {
  std::vector<Vec3<double>> x(mesh.X), area(mesh.X.size());
  for (std::size_t n = 0; n < x.size(); ++n) x[n] = x[n] + displacement[n];
  for (const Facet& facet : outer_surface(mesh)) {
    const auto share = (1.0 / facet.node_count()) * area_vector(facet, x);
    for (int k = 0; k < facet.node_count(); ++k) {
      auto& its = area[static_cast<std::size_t>(facet.nodes[static_cast<std::size_t>(k)])];
      its = its + share;
    }
  }
  std::vector<double> pressure(x.size(), 0.0);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double squared = dot(area[n], area[n]);
    if (squared > 0) pressure[n] = -dot(force[n], area[n]) / squared;
  }
  return pressure;
}

}  // namespace glisson
