#include <glisson/contact/deformable/contact_mesh.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <glisson/contact/deformable/side_normal.hpp>
#include <glisson/contact/geometry/lower_quartile.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/triangles.hpp>

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

std::vector<int> solids_of(const Mesh& mesh, const ContactMesh& contact) {
  Joined joined(mesh.X.size());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const int n : mesh.element(e)) joined.join(mesh.element(e)[0], n);
  for (const Triangle& t : mesh.triangles)
    for (const int n : t) joined.join(t[0], n);
  std::vector<int> solid;
  for (int k = 0; k < contact.corner_count(); ++k)
    solid.push_back(joined.root(contact.nodes[at(contact.node_of(k))]));
  return solid;
}

/// Rest positions of the nodes, from the middle of their box.
void set_nodes(ContactMesh& mesh, const Model& model) {
  Vec3<double> low = model.mesh.X[at(mesh.nodes[0])], high = low;
  for (const int n : mesh.nodes) {
    const auto& X = model.mesh.X[at(n)];
    low = {std::min(low.x, X.x), std::min(low.y, X.y), std::min(low.z, X.z)};
    high = {std::max(high.x, X.x), std::max(high.y, X.y), std::max(high.z, X.z)};
  }
  mesh.centre = 0.5 * (low + high);
  for (const int n : mesh.nodes) mesh.X.push_back(model.mesh.X[at(n)] - mesh.centre);
  mesh.solid = solids_of(model.mesh, mesh);
}

/// Heights of the facets between their nodes; a rim has none there.
void set_sizes(ContactMesh& mesh, const std::vector<ContactFacet>& facets) {
  std::vector<Facet> at_nodes;
  for (const ContactFacet& facet : facets) {
    Facet its;
    for (int a = 0; a < facet.corner_count(); ++a) its.nodes[at(a)] = mesh.node_of(facet.point[at(a)]);
    const auto [a, b, c, d] = its.nodes;
    if (a != b && b != c && c != a) at_nodes.push_back(its);
  }
  const TriangleSizes sizes = triangle_sizes(split_facets(at_nodes, mesh.X), mesh.X);
  mesh.shortest = sizes.smallest;
  mesh.longest = sizes.largest;
}

void set_triangles(ContactMesh& mesh, const std::vector<ContactFacet>& facets) {
  for (const ContactFacet& facet : facets) {
    const auto& n = facet.point;
    if (facet.corner_count() == 3) {
      mesh.triangles.push_back({n[0], n[1], n[2]});
      mesh.sheet.push_back(facet.sheet);
      continue;
    }
    const int centre = mesh.point_count();
    mesh.quads.push_back(n);
    mesh.sheet.insert(mesh.sheet.end(), 4, facet.sheet);
    for (std::size_t a = 0; a < 4; ++a) mesh.triangles.push_back({n[a], n[(a + 1) % 4], centre});
  }
}

/// Regions are numbered in the order of their first triangle.
void set_regions(ContactMesh& mesh, const std::vector<ContactFacet>& facets) {
  Joined joined(mesh.nodes.size());
  std::vector<std::array<int, 2>> kind;  // of each triangle: body, side of a sheet
  for (const ContactFacet& facet : facets) {
    const int count = facet.corner_count(), first = mesh.node_of(facet.point[0]);
    for (int a = 1; a < count; ++a) joined.join(first, mesh.node_of(facet.point[at(a)]));
    kind.insert(kind.end(), count == 3 ? 1 : 4, {facet.body, facet.back ? 1 : 0});
  }
  std::map<std::array<int, 3>, int> numbers;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const std::array key{joined.root(mesh.node_of(mesh.triangles[at(t)][0])), kind[at(t)][0], kind[at(t)][1]};
    const auto [place, is_new] = numbers.try_emplace(key, static_cast<int>(numbers.size()));
    if (is_new) {
      mesh.part_of_region.push_back(key[0]);
      mesh.body_of_region.push_back(key[1]);
    }
    mesh.region.push_back(place->second);
  }
}

/// Nodes that are corners of one facet are near each other.
void set_near(ContactMesh& mesh) {
  std::vector<std::array<int, 2>> pairs;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto its = mesh.facet_nodes(t);
    for (const int a : its)
      for (const int b : its)
        if (a >= 0 && b >= 0) pairs.push_back({a, b});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  mesh.near_begin.assign(mesh.nodes.size() + 1, 0);
  for (const auto& [a, b] : pairs) {
    ++mesh.near_begin[at(a + 1)];
    mesh.near.push_back(b);
  }
  std::partial_sum(mesh.near_begin.begin(), mesh.near_begin.end(), mesh.near_begin.begin());
}

void set_around(ContactMesh& mesh) {
  mesh.around_begin.assign(at(mesh.point_count()) + 1, 0);
  for (const Triangle& t : mesh.triangles)
    for (const int n : t) ++mesh.around_begin[at(n + 1)];
  std::partial_sum(mesh.around_begin.begin(), mesh.around_begin.end(), mesh.around_begin.begin());
  mesh.around.resize(3 * mesh.triangles.size());
  auto fill = mesh.around_begin;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (const int n : mesh.triangles[at(t)]) mesh.around[at(fill[at(n)]++)] = t;
  for (int k = 0; k < mesh.corner_count(); ++k) {
    const int first = mesh.around_begin[at(k)];
    mesh.point_region.push_back(first < mesh.around_begin[at(k + 1)] ? mesh.region[at(mesh.around[at(first)])]
                                                                     : -1);
  }
}

/// A triangle at an edge, and its corner opposite to it.
using EdgeUse = std::array<int, 2>;

void add_edge(ContactMesh& mesh, const std::array<int, 2>& node, const EdgeUse& one, const EdgeUse& other) {
  for (const auto& [t, opposite] : {one, other}) {
    const Triangle& c = mesh.triangles[at(t)];
    const std::size_t k = c[0] == opposite ? 1 : c[1] == opposite ? 2 : 0;  // corner where the edge starts
    mesh.triangle_edges[at(t)][k] = static_cast<int>(mesh.edges.size());
  }
  const Triangle& first = mesh.triangles[at(one[0])];
  const bool forward = first[0] == node[0]   ? first[1] == node[1]
                       : first[1] == node[0] ? first[2] == node[1]
                                             : first[0] == node[1];
  const EdgeUse &a = forward ? one : other, &b = forward ? other : one;
  mesh.edges.push_back({node, {a[1], b[1]}, {a[0], b[0]}});
}

/// "0, 3": the elements around an edge, at most six of them.
std::string elements_at(const Mesh& mesh, int a, int b) {
  std::string text;
  int count = 0;
  for (int e = 0; e < mesh.element_count() && count < 6; ++e) {
    const auto nodes = mesh.element(e);
    if (std::count(nodes.begin(), nodes.end(), a) == 0 || std::count(nodes.begin(), nodes.end(), b) == 0)
      continue;
    text += (count++ > 0 ? ", " : "") + std::to_string(e);
  }
  return text;
}

[[noreturn]] void refuse_edge(const Mesh& mesh, int a, int b, std::size_t facets) {
  throw Error(ErrorKind::input,
              "it needs surfaces with an inside, but the edge between the nodes " + std::to_string(a) +
                  " and " + std::to_string(b) + " has " + std::to_string(facets) +
                  " outer facets: elements touch there at an edge only (there are " +
                  elements_at(mesh, a, b) +
                  "). Remove an element at it or add one, or switch the contact off",
              {"", 0, contact_place});
}

/// Where sheets branch or stand on a solid, both sides of each are taken as neighbours.
void set_edges(ContactMesh& mesh, const Mesh& model) {
  mesh.triangle_edges.resize(mesh.triangles.size());
  std::map<std::array<int, 2>, std::vector<EdgeUse>> uses;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& c = mesh.triangles[at(t)];
      const int a = c[k], b = c[(k + 1) % 3];
      uses[{std::min(a, b), std::max(a, b)}].push_back({t, c[(k + 2) % 3]});
    }
  const auto sheet_of = [&](const EdgeUse& use) { return mesh.sheet[at(use[0])]; };
  for (auto& [node, its] : uses) {
    if (its.size() > 2)
      std::stable_sort(its.begin(), its.end(),
                       [&](const EdgeUse& a, const EdgeUse& b) { return sheet_of(a) < sheet_of(b); });
    const auto of_solids =
        std::count_if(its.begin(), its.end(), [&](const auto& u) { return sheet_of(u) < 0; });
    if (its.size() % 2 == 1 || of_solids > 2)
      refuse_edge(model, mesh.nodes[at(mesh.node_of(node[0]))], mesh.nodes[at(mesh.node_of(node[1]))],
                  its.size());
    for (std::size_t i = 0; i < its.size(); i += 2) add_edge(mesh, node, its[i], its[i + 1]);
  }
}

/// At an edge at rest a point stands off the planes of its facets, up to twice as far from its node.
void lengthen_at_edges(ContactMesh& mesh) {
  for (int p = mesh.node_count(); p < mesh.corner_count(); ++p) {
    const auto normal = mesh.mean_normal(p, mesh.X);
    mesh.beside[at(p - mesh.node_count())].distance /= std::max(std::sqrt(dot(normal, normal)), 0.5);
  }
}

void set_edge_length(ContactMesh& mesh) {
  std::vector<double> lengths;
  for (const ContactEdge& e : mesh.edges) {
    if (!mesh.is_corner(e.node[1]) || mesh.node_of(e.node[0]) == mesh.node_of(e.node[1])) continue;
    const auto d = mesh.X[at(e.node[1])] - mesh.X[at(e.node[0])];
    lengths.push_back(std::sqrt(dot(d, d)));
  }
  mesh.edge_length = lower_quartile(std::move(lengths));
}

void set_touching_nodes(ContactMesh& mesh, const Model& model) {
  const std::vector<int>& listed = model.contact.nodes;
  mesh.may_touch.assign(mesh.nodes.size(), listed.empty());
  std::vector<int> place(listed.empty() ? 0 : model.mesh.X.size(), -1);
  for (std::size_t k = 0; k < mesh.nodes.size() && !place.empty(); ++k)
    place[at(mesh.nodes[k])] = static_cast<int>(k);
  for (const int n : listed) {
    if (place[at(n)] < 0)
      throw Error(ErrorKind::input,
                  "node " + std::to_string(n) +
                      " is listed as one that may touch, but it is neither on the outer surface of the "
                      "solids nor a node of a membrane or shell. Take it off the list",
                  {"", 0, contact_place});
    mesh.may_touch[at(place[at(n)])] = true;
  }
}

ContactMesh mesh_of(const Model& model, ContactFacets its) {
  if (its.facets.empty())
    throw Error(ErrorKind::input, "it needs elements, but there are none", {"", 0, contact_place});
  ContactMesh mesh;
  mesh.nodes = std::move(its.nodes);
  mesh.beside = std::move(its.beside);
  set_nodes(mesh, model);
  set_sizes(mesh, its.facets);
  set_triangles(mesh, its.facets);
  set_regions(mesh, its.facets);
  set_around(mesh);
  set_near(mesh);
  lengthen_at_edges(mesh);
  mesh.append_points(mesh.X);
  set_edges(mesh, model.mesh);
  set_edge_length(mesh);
  set_touching_nodes(mesh, model);
  return mesh;
}

}  // namespace

std::array<int, 4> ContactMesh::facet_nodes(int triangle) const {
  const Triangle& c = triangles[at(triangle)];
  if (is_corner(c[2])) return {node_of(c[0]), node_of(c[1]), node_of(c[2]), -1};
  const auto& q = quads[at(c[2] - corner_count())];
  return {node_of(q[0]), node_of(q[1]), node_of(q[2]), node_of(q[3])};
}

double ContactMesh::largest_offset() const {
  double largest = 0;
  for (const SidePoint& p : beside) largest = std::max(largest, p.distance);
  return largest;
}

bool ContactMesh::on_sheet(int corner) const {
  for (int i = around_begin[at(corner)]; i < around_begin[at(corner + 1)]; ++i)
    if (sheet[at(around[at(i)])] >= 0) return true;
  return false;
}

Vec3<double> ContactMesh::mean_normal(int p, const std::vector<Vec3<double>>& x) const {
  const auto place = [&](int k) {
    if (is_corner(k)) return x[at(node_of(k))];
    const auto& q = quads[at(k - corner_count())];
    return 0.25 *
           ((x[at(node_of(q[0]))] + x[at(node_of(q[1]))]) + (x[at(node_of(q[2]))] + x[at(node_of(q[3]))]));
  };
  const auto corner = [&](int t, int k) { return place(triangles[at(t)][at(k)]); };
  const auto which = [&](int t) { return triangles[at(t)][0] == p ? 0 : triangles[at(t)][1] == p ? 1 : 2; };
  const int first = around_begin[at(p)], count = around_begin[at(p + 1)] - first;
  return mean_side_normal<double>(around.data() + first, count, corner, which);
}

void ContactMesh::append_points(std::vector<Vec3<double>>& x) const {
  for (int p = node_count(); p < corner_count(); ++p)
    x.push_back(x[at(node_of(p))] + offset_of(p) * unit_or(mean_normal(p, x), Vec3<double>{}));
  for (const auto& q : quads) x.push_back(0.25 * ((x[at(q[0])] + x[at(q[1])]) + (x[at(q[2])] + x[at(q[3])])));
}

ContactMesh contact_mesh(const Model& model) { return mesh_of(model, contact_facets(model)); }
ContactMesh contact_mesh(const Model& model, const Numbering& numbering) {
  return mesh_of(model, contact_facets(model, numbering));
}

}  // namespace glisson::contact
