#include <glisson/contact/shortest_edge.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson::contact {

double shortest_edge_around(const Mesh& mesh, int node) {
  double shortest = std::numeric_limits<double>::infinity();
  const auto at = [&](int n) { return mesh.X[static_cast<std::size_t>(n)]; };
  const auto take = [&](const auto& nodes) {
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) return;
    for (const int n : nodes) {
      const auto d = at(n) - at(node);
      if (n != node) shortest = std::min(shortest, std::sqrt(dot(d, d)));
    }
  };
  for (int e = 0; e < mesh.element_count(); ++e) take(mesh.element(e));
  for (const auto& triangle : mesh.triangles) take(triangle);
  return shortest;
}

}  // namespace glisson::contact
