#include <glisson/contact/deformable/contact_mesh.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/surface.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Sets that are joined until their roots are asked for.
class Joined {
 public:
  explicit Joined(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) {
    while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
    return i;
  }
  void join(int a, int b) {
    const int x = root(a), y = root(b);
    parent_[at(std::max(x, y))] = std::min(x, y);
  }

 private:
  std::vector<int> parent_;
};

std::vector<int> solids_of(const Mesh& mesh, const std::vector<int>& nodes) {
  Joined joined(mesh.X.size());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const int n : mesh.element(e)) joined.join(mesh.element(e)[0], n);
  std::vector<int> solid;
  for (const int n : nodes) solid.push_back(joined.root(n));
  return solid;
}

std::vector<int> body_of_elements(const Model& model) {
  std::vector<int> body(at(model.mesh.element_count()), 0);
  for (std::size_t k = 0; k < model.bodies_by_name.size(); ++k) {
    const NamedElements& its = model.bodies_by_name[k];
    for (int e = std::max(its.first, 0); e < its.first + its.count && at(e) < body.size(); ++e)
      if (body[at(e)] == 0) body[at(e)] = static_cast<int>(k) + 1;  // the innermost name comes first
  }
  return body;
}

void set_geometry(ContactMesh& mesh, const Model& model, std::vector<Facet>& facets) {
  mesh.nodes = nodes_of(facets);
  std::vector<int> place(model.mesh.X.size(), -1);
  for (int k = 0; k < mesh.node_count(); ++k) place[at(mesh.nodes[at(k)])] = k;
  Vec3<double> low = model.mesh.X[at(mesh.nodes[0])], high = low;
  for (const int n : mesh.nodes) {
    const auto& X = model.mesh.X[at(n)];
    low = {std::min(low.x, X.x), std::min(low.y, X.y), std::min(low.z, X.z)};
    high = {std::max(high.x, X.x), std::max(high.y, X.y), std::max(high.z, X.z)};
  }
  mesh.centre = 0.5 * (low + high);
  for (const int n : mesh.nodes) mesh.X.push_back(model.mesh.X[at(n)] - mesh.centre);
  for (Facet& facet : facets)
    for (int a = facet.node_count() - 1; a >= 0; --a) facet.nodes[at(a)] = place[at(facet.nodes[at(a)])];
  const TriangleSizes sizes = triangle_sizes(split_facets(facets, mesh.X), mesh.X);
  mesh.shortest = sizes.smallest;
  mesh.longest = sizes.largest;
  mesh.solid = solids_of(model.mesh, mesh.nodes);
}

void set_triangles(ContactMesh& mesh, const std::vector<Facet>& facets) {
  for (const Facet& facet : facets) {
    const auto& n = facet.nodes;
    if (facet.node_count() == 3) {
      mesh.triangles.push_back({n[0], n[1], n[2]});
      continue;
    }
    const int centre = mesh.node_count() + static_cast<int>(mesh.quads.size());
    mesh.quads.push_back(n);
    for (std::size_t a = 0; a < 4; ++a) mesh.triangles.push_back({n[a], n[(a + 1) % 4], centre});
  }
  mesh.append_centres(mesh.X);
}

/// Regions are numbered in the order of their first triangle.
void set_regions(ContactMesh& mesh, const std::vector<Facet>& facets, const std::vector<int>& body) {
  Joined joined(mesh.nodes.size());
  std::vector<int> body_of;  // of each triangle
  for (const Facet& facet : facets) {
    for (int a = 1; a < facet.node_count(); ++a) joined.join(facet.nodes[0], facet.nodes[at(a)]);
    body_of.insert(body_of.end(), facet.node_count() == 3 ? 1 : 4, body[at(facet.element)]);
  }
  std::map<std::pair<int, int>, int> numbers;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const std::pair key{joined.root(mesh.triangles[at(t)][0]), body_of[at(t)]};
    const auto [place, is_new] = numbers.try_emplace(key, static_cast<int>(numbers.size()));
    if (is_new) {
      mesh.part_of_region.push_back(key.first);
      mesh.body_of_region.push_back(key.second);
    }
    mesh.region.push_back(place->second);
  }
}

void set_around(ContactMesh& mesh) {
  mesh.around_begin.assign(mesh.X.size() + 1, 0);
  for (const Triangle& t : mesh.triangles)
    for (const int n : t) ++mesh.around_begin[at(n + 1)];
  std::partial_sum(mesh.around_begin.begin(), mesh.around_begin.end(), mesh.around_begin.begin());
  mesh.around.resize(3 * mesh.triangles.size());
  auto fill = mesh.around_begin;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (const int n : mesh.triangles[at(t)]) mesh.around[at(fill[at(n)]++)] = t;
  for (int k = 0; k < mesh.node_count(); ++k)
    mesh.node_region.push_back(mesh.region[at(mesh.around[at(mesh.around_begin[at(k)])])]);
}

void set_edges(ContactMesh& mesh) {
  mesh.triangle_edges.resize(mesh.triangles.size());
  std::map<std::array<int, 2>, std::vector<std::array<int, 2>>> uses;  // {triangle, opposite corner}
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& c = mesh.triangles[at(t)];
      const int a = c[k], b = c[(k + 1) % 3];
      uses[{std::min(a, b), std::max(a, b)}].push_back({t, c[(k + 2) % 3]});
    }
  for (const auto& [node, its] : uses) {
    if (its.size() != 2)
      throw Error(ErrorKind::input,
                  "it needs surfaces with an inside, but the edge between the nodes " +
                      std::to_string(mesh.nodes[at(node[0])]) + " and " +
                      std::to_string(mesh.nodes[at(node[1])]) + " has " + std::to_string(its.size()) +
                      " outer facets: elements touch there at an edge only. Remove an element at it or add "
                      "one, or switch the contact off",
                  {"", 0, contact_place});
    for (const auto& [t, opposite] : its) {
      const Triangle& c = mesh.triangles[at(t)];
      const std::size_t k = c[0] == opposite ? 1 : c[1] == opposite ? 2 : 0;  // corner where the edge starts
      mesh.triangle_edges[at(t)][k] = static_cast<int>(mesh.edges.size());
    }
    const Triangle& first = mesh.triangles[at(its[0][0])];
    const bool forward = first[0] == node[0]   ? first[1] == node[1]
                         : first[1] == node[0] ? first[2] == node[1]
                                               : first[0] == node[1];
    const std::size_t k = forward ? 0 : 1;
    mesh.edges.push_back({node, {its[k][1], its[1 - k][1]}, {its[k][0], its[1 - k][0]}});
  }
}

void set_edge_length(ContactMesh& mesh) {
  std::vector<double> lengths;
  for (const ContactEdge& e : mesh.edges) {
    if (!mesh.is_node(e.node[1])) continue;
    const auto d = mesh.X[at(e.node[1])] - mesh.X[at(e.node[0])];
    lengths.push_back(std::sqrt(dot(d, d)));
  }
  const auto quarter = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 4);
  std::nth_element(lengths.begin(), quarter, lengths.end());
  mesh.edge_length = *quarter;
}

void set_touching_nodes(ContactMesh& mesh, const std::vector<int>& listed) {
  mesh.may_touch.assign(mesh.nodes.size(), listed.empty());
  for (const int n : listed) {
    const auto place = std::lower_bound(mesh.nodes.begin(), mesh.nodes.end(), n);
    if (place == mesh.nodes.end() || *place != n)
      throw Error(ErrorKind::input,
                  "node " + std::to_string(n) +
                      " is listed as one that may touch, but it is not on the outer surface of the solids. "
                      "Take it off the list",
                  {"", 0, contact_place});
    mesh.may_touch[static_cast<std::size_t>(place - mesh.nodes.begin())] = true;
  }
}

}  // namespace

std::array<int, 4> ContactMesh::facet_nodes(int triangle) const {
  const Triangle& c = triangles[at(triangle)];
  return is_node(c[2]) ? std::array{c[0], c[1], c[2], -1} : quads[at(c[2] - node_count())];
}

void ContactMesh::append_centres(std::vector<Vec3<double>>& x) const {
  for (const auto& q : quads) x.push_back(0.25 * ((x[at(q[0])] + x[at(q[1])]) + (x[at(q[2])] + x[at(q[3])])));
}

ContactMesh contact_mesh(const Model& model) {
  auto facets = outer_surface(model.mesh);
  if (facets.empty())
    throw Error(ErrorKind::input, "it needs solid elements, but there are none", {"", 0, contact_place});
  ContactMesh mesh;
  set_geometry(mesh, model, facets);
  set_triangles(mesh, facets);
  set_regions(mesh, facets, body_of_elements(model));
  set_around(mesh);
  set_edges(mesh);
  set_edge_length(mesh);
  set_touching_nodes(mesh, model.contact.nodes);
  return mesh;
}

double default_contact_distance(const ContactMesh& mesh) { return 2.5e-4 * (mesh.shortest + mesh.longest); }

}  // namespace glisson::contact
