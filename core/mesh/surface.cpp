#include <glisson/core/mesh/surface.hpp>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/triangles.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson {
namespace {

// Local nodes of the facets, counter-clockwise seen from outside.
constexpr int tetrahedron_facets[4][4] = {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}};
constexpr int hexahedron_facets[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                         {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
constexpr int facets_per_slot = 6;  // room for either shape in a facet id

int facet_count_of(Shape shape) { return shape == Shape::tetrahedron ? 4 : 6; }

Facet facet_of(const Mesh& mesh, int e, int k) {
  const bool tetrahedron = mesh.shape[static_cast<std::size_t>(e)] == Shape::tetrahedron;
  const int* local = tetrahedron ? tetrahedron_facets[k] : hexahedron_facets[k];
  const auto nodes = mesh.element(e);
  Facet facet;
  facet.element = e;
  for (int a = 0; a < (tetrahedron ? 3 : 4); ++a)
    facet.nodes[static_cast<std::size_t>(a)] = nodes[static_cast<std::size_t>(local[a])];
  return facet;
}

Facet facet_of(const Mesh& mesh, std::uint32_t id) {
  return facet_of(mesh, static_cast<int>(id / facets_per_slot), static_cast<int>(id % facets_per_slot));
}

std::size_t lowest_node(const Facet& facet) {
  return static_cast<std::size_t>(
      *std::min_element(facet.nodes.begin(), facet.nodes.begin() + facet.node_count()));
}

/// The same for both owners of a facet, whatever its orientation.
struct Key {
  std::array<int, 4> nodes;
  std::uint32_t id;
};

Key key_of(const Mesh& mesh, std::uint32_t id) {
  Key key{facet_of(mesh, id).nodes, id};
  std::sort(key.nodes.begin(), key.nodes.end());
  return key;
}

/// Appends the ids of the facets that occur once among those that share their lowest node.
void append_single(const Mesh& mesh, std::span<const std::uint32_t> bucket, std::vector<Key>& keys,
                   std::vector<std::uint32_t>& single) {
  keys.clear();
  for (const auto id : bucket) keys.push_back(key_of(mesh, id));
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.nodes < b.nodes; });
  for (std::size_t i = 0; i < keys.size();) {
    std::size_t end = i + 1;
    while (end < keys.size() && keys[end].nodes == keys[i].nodes) ++end;
    if (end == i + 1) single.push_back(keys[i].id);
    i = end;
  }
}

template <class Body>
void for_each_facet(const Mesh& mesh, Body body) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    const int count = facet_count_of(mesh.shape[static_cast<std::size_t>(e)]);
    for (int k = 0; k < count; ++k)
      body(static_cast<std::uint32_t>(e) * facets_per_slot + static_cast<std::uint32_t>(k));
  }
}

}  // namespace

// Facets are put into buckets by their lowest node (a counting sort of ids); twins meet within a bucket.
std::vector<Facet> outer_surface(const Mesh& mesh) {
  if (static_cast<std::uint32_t>(mesh.element_count()) >
      std::numeric_limits<std::uint32_t>::max() / facets_per_slot)
    throw Error(ErrorKind::input, "the mesh has too many elements for its surface to be found");
  std::vector<std::uint32_t> begin(mesh.X.size() + 1, 0);
  for_each_facet(mesh, [&](std::uint32_t id) { ++begin[lowest_node(facet_of(mesh, id)) + 1]; });
  for (std::size_t n = 1; n < begin.size(); ++n) begin[n] += begin[n - 1];
  std::vector<std::uint32_t> ids(begin.back());
  for_each_facet(mesh, [&](std::uint32_t id) { ids[begin[lowest_node(facet_of(mesh, id))]++] = id; });

  std::vector<std::uint32_t> single;
  std::vector<Key> keys;
  std::uint32_t first = 0;  // after the fill, begin[n] is the end of bucket n
  for (std::size_t n = 0; n < mesh.X.size(); ++n) {
    append_single(mesh, {ids.data() + first, begin[n] - first}, keys, single);
    first = begin[n];
  }
  std::sort(single.begin(), single.end());
  std::vector<Facet> facets;
  facets.reserve(single.size());
  for (const auto id : single) facets.push_back(facet_of(mesh, id));
  return facets;
}

Vec3<double> area_vector(const Facet& facet, std::span<const Vec3<double>> X) {
  const auto at = [&](int a) {
    return X[static_cast<std::size_t>(facet.nodes[static_cast<std::size_t>(a)])];
  };
  if (facet.node_count() == 3) return 0.5 * cross(at(1) - at(0), at(2) - at(0));
  return 0.5 * cross(at(2) - at(0), at(3) - at(1));
}

Vec3<double> facet_normal(const Facet& facet, std::span<const Vec3<double>> X) {
  const auto area = area_vector(facet, X);
  const double length = std::sqrt(dot(area, area));
  return length > 0 ? (1 / length) * area : Vec3<double>{};
}

Vec3<double> facet_centre(const Facet& facet, std::span<const Vec3<double>> X) {
  Vec3<double> sum;
  const int count = facet.node_count();
  for (int a = 0; a < count; ++a)
    sum = sum + X[static_cast<std::size_t>(facet.nodes[static_cast<std::size_t>(a)])];
  return (1.0 / count) * sum;
}

std::vector<int> nodes_of(std::span<const Facet> facets) {
  std::vector<int> nodes;
  for (const auto& facet : facets)
    nodes.insert(nodes.end(), facet.nodes.begin(), facet.nodes.begin() + facet.node_count());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<int> outer_nodes(const Mesh& mesh) {
  auto facets = outer_surface(mesh);
  const auto triangles = facets_of(mesh.triangles);
  facets.insert(facets.end(), triangles.begin(), triangles.end());
  return nodes_of(facets);
}

}  // namespace glisson
