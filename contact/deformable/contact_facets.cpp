#include <glisson/contact/deformable/contact_facets.hpp>

#include <algorithm>
#include <map>

#include <glisson/contact/shell_thickness.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/mesh/triangles.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::array<int, 3> sorted(std::array<int, 3> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Marks the triangles whose nodes all belong to one solid element.
void mark_inner(const Mesh& mesh, std::vector<bool>& used) {
  std::multimap<int, int> by_node;  // first node: triangle
  for (int t = 0; t < static_cast<int>(used.size()); ++t)
    if (!used[at(t)]) by_node.emplace(mesh.triangles[at(t)][0], t);
  for (int e = 0; e < mesh.element_count() && !by_node.empty(); ++e) {
    const auto its = mesh.element(e);
    const auto has = [&](int n) { return std::find(its.begin(), its.end(), n) != its.end(); };
    for (const int n : its) {
      const auto [first, last] = by_node.equal_range(n);
      for (auto place = first; place != last; ++place) {
        const auto& t = mesh.triangles[at(place->second)];
        if (has(t[1]) && has(t[2])) used[at(place->second)] = true;
      }
    }
  }
}

/// A mean over what is added.
struct Mean {
  double sum = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return count ? sum / count : 0; }
};

class FacetFinder {
 public:
  FacetFinder(const Model& model, const Numbering* numbering)
      : mesh_(model.mesh),
        numbering_(numbering),
        solids_(outer_surface(model.mesh)),
        half_(half_thicknesses(model)),
        no_sheet_(model.mesh.triangles.size()),
        skin_(model.mesh.X.size()),
        off_(model.mesh.X.size()),
        plain_(model.mesh.X.size()),
        body_(body_of_elements(model)),
        triangle_body_(body_of_triangles(model)) {}

  ContactFacets find() {
    find_skins();
    mark_inner(mesh_, no_sheet_);
    find_sheets();
    number_points();
    for (const Facet& facet : solids_) add_solid(facet);
    for (const int t : sheets_) add_side(t, false);
    for (const int t : sheets_) add_side(t, true);
    add_rims();
    return std::move(result_);
  }

 private:
  /// A quadrilateral is covered by two triangles, along either diagonal.
  void find_skins() {
    std::map<std::array<int, 3>, int> shells;
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t)
      shells.emplace(sorted(mesh_.triangles[at(t)]), t);
    if (shells.empty()) return;
    for (const Facet& facet : solids_) {
      const auto& n = facet.nodes;
      const int corners = facet.node_count();
      for (int left_out = corners == 3 ? 3 : 0; left_out < 4; ++left_out) {
        std::array<int, 3> key{};
        for (int a = 0, k = 0; a < corners; ++a)
          if (a != left_out) key[at(k++)] = n[at(a)];
        const auto found = shells.find(sorted(key));
        if (found == shells.end()) continue;
        no_sheet_[at(found->second)] = true;
        for (const int node : key) skin_[at(node)].add(half_[at(found->second)]);
      }
    }
  }
  void find_sheets() {
    std::vector<Triangle> triangles;
    for (int t = 0; t < static_cast<int>(no_sheet_.size()); ++t) {
      if (no_sheet_[at(t)]) continue;
      sheets_.push_back(t);
      triangles.push_back(mesh_.triangles[at(t)]);
      for (const int n : triangles.back()) off_[at(n)].add(half_[at(t)]);
    }
    for (const int n : mesh_.nodes) plain_[at(n)] = true;
    edges_ = edges_of(triangles);
    std::map<int, int> borders;
    for (const TriangleEdge& edge : edges_)
      for (const int n : {edge.a, edge.b}) {
        if (edge.sides.size() > 2) plain_[at(n)] = true;
        if (edge.sides.size() == 1 && ++borders[n] > 2) plain_[at(n)] = true;
      }
  }
  void number_points() {
    result_.nodes = nodes_of(solids_);
    for (const int t : sheets_)
      for (const int n : mesh_.triangles[at(t)]) result_.nodes.push_back(n);
    std::sort(result_.nodes.begin(), result_.nodes.end());
    result_.nodes.erase(std::unique(result_.nodes.begin(), result_.nodes.end()), result_.nodes.end());
    if (numbering_)
      std::sort(result_.nodes.begin(), result_.nodes.end(), [&](int a, int b) {
        return numbering_->internal_of_user[at(a)] < numbering_->internal_of_user[at(b)];
      });
    outer_.assign(mesh_.X.size(), -1);
    for (int k = 0; k < static_cast<int>(result_.nodes.size()); ++k) outer_[at(result_.nodes[at(k)])] = k;
    front_ = back_ = outer_;
    for (const int n : result_.nodes) {
      const int place = outer_[at(n)];
      if (skin_[at(n)].count) outer_[at(n)] = point_beside(place, skin_[at(n)].value());
      if (off_[at(n)].count == 0 || plain_[at(n)]) continue;
      front_[at(n)] = point_beside(place, off_[at(n)].value());
      back_[at(n)] = point_beside(place, off_[at(n)].value());
    }
  }
  int point_beside(int place, double distance) {
    result_.beside.push_back({place, distance});
    return static_cast<int>(result_.nodes.size() + result_.beside.size()) - 1;
  }
  void add_solid(const Facet& facet) {
    ContactFacet its;
    its.body = body_[at(facet.element)];
    for (int a = 0; a < facet.node_count(); ++a) its.point[at(a)] = outer_[at(facet.nodes[at(a)])];
    result_.facets.push_back(its);
  }
  void add_sheet_facet(int triangle, bool back, const std::array<int, 3>& points) {
    result_.facets.push_back(
        {{points[0], points[1], points[2], -1}, triangle_body_[at(triangle)], triangle, back});
  }
  void add_side(int triangle, bool back) {
    const auto& n = mesh_.triangles[at(triangle)];
    if (back)
      add_sheet_facet(triangle, true, {back_[at(n[0])], back_[at(n[2])], back_[at(n[1])]});
    else
      add_sheet_facet(triangle, false, {front_[at(n[0])], front_[at(n[1])], front_[at(n[2])]});
  }
  void add_rims() {
    for (const TriangleEdge& edge : edges_) {
      if (edge.sides.size() != 1) continue;
      const int triangle = sheets_[at(edge.sides[0] / 3)], side = edge.sides[0] % 3;
      const auto& n = mesh_.triangles[at(triangle)];
      const int a = n[at((side + 1) % 3)], b = n[at((side + 2) % 3)];
      if (!plain_[at(a)]) add_sheet_facet(triangle, false, {front_[at(b)], front_[at(a)], back_[at(a)]});
      if (!plain_[at(b)]) add_sheet_facet(triangle, false, {front_[at(b)], back_[at(a)], back_[at(b)]});
    }
  }

  const Mesh& mesh_;
  const Numbering* numbering_;  ///< order of the nodes; none: as they are
  std::vector<Facet> solids_;
  std::vector<double> half_;      ///< of each triangle [m]
  std::vector<bool> no_sheet_;    ///< the triangle lies on or in a solid
  std::vector<Mean> skin_, off_;  ///< half thickness at each node, of skins and of sheets
  std::vector<bool> plain_;       ///< a sheet has no thickness at the node
  std::vector<int> body_, triangle_body_, sheets_;
  std::vector<TriangleEdge> edges_;        ///< of the sheets; sides by place in sheets_
  std::vector<int> outer_, front_, back_;  ///< point of each node for solids and for both sides
  ContactFacets result_;
};

std::vector<int> bodies(const Model& model, std::size_t count, int NamedElements::*first,
                        int NamedElements::*its_count) {
  std::vector<int> body(count, 0);
  for (std::size_t k = 0; k < model.bodies_by_name.size(); ++k) {
    const NamedElements& its = model.bodies_by_name[k];
    for (int e = std::max(its.*first, 0); e < its.*first + its.*its_count && at(e) < count; ++e)
      if (body[at(e)] == 0) body[at(e)] = static_cast<int>(k) + 1;  // the innermost name comes first
  }
  return body;
}

}  // namespace

ContactFacets contact_facets(const Model& model) { return FacetFinder(model, nullptr).find(); }
ContactFacets contact_facets(const Model& model, const Numbering& numbering) {
  return FacetFinder(model, &numbering).find();
}

std::vector<int> body_of_elements(const Model& model) {
  return bodies(model, at(model.mesh.element_count()), &NamedElements::first, &NamedElements::count);
}
std::vector<int> body_of_triangles(const Model& model) {
  return bodies(model, model.mesh.triangles.size(), &NamedElements::first_triangle,
                &NamedElements::triangle_count);
}

int body_named(const Model& model, const std::string& name, const std::string& where) {
  for (std::size_t k = 0; k < model.bodies_by_name.size(); ++k)
    if (model.bodies_by_name[k].name == name) return static_cast<int>(k) + 1;
  throw Error(ErrorKind::input, "there is no sub-model with the name '" + name + "'", {"", 0, where});
}

}  // namespace glisson::contact
