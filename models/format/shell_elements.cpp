// ShellElements: triangles that are listed, cut from the outer surface of the solids, or read from a file.
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/core/validation/checks.hpp>
#include <glisson/models/format/join_parts.hpp>
#include <glisson/models/mesh/raw_mesh.hpp>

#include <algorithm>
#include <numeric>

namespace glisson::detail {
namespace {

/// What triangles are cut from, with a label and rows of arrays for each facet.
struct ShellFacets {
  std::vector<Facet> facets;
  std::vector<int> label;
  std::map<std::string, NamedArray> arrays;
};

std::map<std::string, NamedArray> rows_of(const std::map<std::string, NamedArray>& arrays,
                                          const std::vector<std::size_t>& rows) {
  std::map<std::string, NamedArray> chosen;
  for (const auto& [name, array] : arrays) chosen[name] = chosen_rows(array, rows);
  return chosen;
}

ShellFacets chosen_facets(const ShellFacets& all, const std::vector<char>& mask) {
  ShellFacets chosen;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    rows.push_back(i);
    chosen.facets.push_back(all.facets[i]);
    chosen.label.push_back(all.label[i]);
  }
  chosen.arrays = rows_of(all.arrays, rows);
  return chosen;
}

void cut(const ShellFacets& from, Part& part) {
  Mesh& mesh = part.model.mesh;
  const std::size_t old_count = mesh.triangles.size();
  std::vector<std::size_t> row;  // facet of each new triangle
  for (std::size_t i = 0; i < from.facets.size(); ++i) {
    append_triangles(from.facets[i], mesh.X, mesh.triangles);
    row.resize(mesh.triangles.size() - old_count, i);
  }
  for (const std::size_t i : row) part.triangle_label.push_back(from.label[i]);
  append_arrays(part.triangle_arrays, rows_of(from.arrays, row), old_count, row.size());
}

void restrict(const Reader& reader, const XmlElement& element, const Mesh& mesh, ShellFacets& all) {
  const auto filter = facet_filter(read_choice(reader, element, mesh));
  if (filter.parts.empty()) return;
  all = chosen_facets(all, SelectionMesh(mesh, all.facets, all.label).facet_mask(filter));
  if (all.facets.empty())
    element.fail(
        "no facet is in the selection, so there is no shell; check the direction, the region and the "
        "units of its numbers");
}

/// The outer surface of the elements that the mask has; facets keep their element.
std::vector<Facet> surface_of(const Mesh& mesh, const std::vector<int>& elements) {
  Mesh some;
  some.X = mesh.X;
  for (const int e : elements) some.add_element(mesh.shape[static_cast<std::size_t>(e)], mesh.element(e));
  auto facets = outer_surface(some);
  for (auto& facet : facets) facet.element = elements[static_cast<std::size_t>(facet.element)];
  return facets;
}

/// With a Label the surface of that part alone, which faces other parts too (a tumour in a liver).
ShellFacets facets_of_solids(const XmlElement& element, const Mesh& mesh) {
  if (mesh.element_count() == 0)
    element.fail(
        "Type=\"SURFACE\" is the surface of solid elements, but there are none here; list the triangles "
        "with Type=\"T3\", or read them with Type=\"FILE\"");
  if (element.has_text()) element.fail("a shell of Type=\"SURFACE\" holds no list; remove the list");
  ShellFacets all;
  const auto label = element.attribute("Label");
  all.facets = label == nullptr
                   ? outer_surface(mesh)
                   : surface_of(mesh, labelled(element, *label, mesh.label, mesh.element_count(), "element"));
  std::vector<std::size_t> rows;
  for (const Facet& facet : all.facets) {
    rows.push_back(static_cast<std::size_t>(facet.element));
    all.label.push_back(mesh.label.empty() ? 0 : mesh.label[rows.back()]);
  }
  all.arrays = rows_of(mesh.cell_arrays, rows);
  for (auto& facet : all.facets) facet.element = -1;
  return all;
}

ShellFacets with_label(const XmlElement& element, ShellFacets all) {
  const auto label = element.attribute("Label");
  if (label == nullptr) return all;
  std::vector<char> mask(all.facets.size(), 0);
  for (const int i : labelled(element, *label, all.label, static_cast<int>(all.label.size()), "facet"))
    mask[static_cast<std::size_t>(i)] = 1;
  return chosen_facets(all, mask);
}

ShellFacets facets_in(const Reader& reader, const XmlElement& element, const XmlElement& file,
                      std::vector<Vec3<double>>& X) {
  auto found = labelled_surface_from_file(reader, file);
  if (found.surface.facets.empty())
    element.fail(
        "the file '" + file.required_text() +
        "' has no triangles and no quadrilaterals, which shells are made of; export the surface cells");
  X = std::move(found.surface.X);
  return {std::move(found.surface.facets), std::move(found.label), std::move(found.arrays)};
}

/// Facets of the mesh file, on the nodes of the solids.
ShellFacets facets_of_mesh(const Reader& reader, const XmlElement& level, const XmlElement& element,
                           const Mesh& mesh) {
  const auto file = mesh_file_of(level);
  if (file == nullptr)
    element.fail(
        "Type=\"MESH\" takes the triangles of the mesh file, but this level has none; use Type=\"T3\" or "
        "Type=\"FILE\"");
  if (element.has_text()) element.fail("a shell of Type=\"MESH\" holds no list; remove the list");
  std::vector<Vec3<double>> X;
  ShellFacets all = facets_in(reader, element, *file, X);
  if (X.size() != mesh.X.size())
    element.fail("the nodes of the mesh file's facets are not those of its solids");
  return with_label(element, std::move(all));
}

/// Facets of a file of their own; its nodes are numbered after those of the level.
ShellFacets facets_of_file(const Reader& reader, const XmlElement& element, Mesh& mesh) {
  std::vector<Vec3<double>> X;
  ShellFacets all = with_label(element, facets_in(reader, element, element, X));
  transform_as_told(element, X);
  std::vector<int> number(X.size(), -1);
  for (const int n : nodes_of(all.facets)) number[static_cast<std::size_t>(n)] = 0;
  const std::size_t old_count = mesh.X.size();
  for (std::size_t n = 0; n < X.size(); ++n) {
    if (number[n] < 0) continue;
    number[n] = mesh.node_count();
    mesh.X.push_back(X[n]);
  }
  append_arrays(mesh.point_arrays, {}, old_count, mesh.X.size() - old_count);
  for (auto& facet : all.facets)
    for (int a = facet.node_count() - 1; a >= 0; --a) {
      auto& n = facet.nodes[static_cast<std::size_t>(a)];
      n = number[static_cast<std::size_t>(n)];
    }
  return all;
}

ShellFacets facets_for(const Reader& reader, const XmlElement& level, const XmlElement& element, Part& part) {
  const auto& type = element.required_attribute("Type");
  Mesh& mesh = part.model.mesh;
  if (type != "FILE")
    for (const auto name : {"Translation", "Rotation", "ScaleFactor"})
      if (const auto child = element.child(name)) child->fail("only shells of Type=\"FILE\" can be moved");
  if (type == "SURFACE") return facets_of_solids(element, mesh);
  if (type == "MESH") return facets_of_mesh(reader, level, element, mesh);
  if (type == "FILE") return facets_of_file(reader, element, mesh);
  if (const auto label = element.attribute("Label"))
    element.fail(label->line, "listed triangles have no labels; remove the attribute Label");
  ShellFacets listed{facet_list(element, mesh.node_count()), {}, {}};
  listed.label.resize(listed.facets.size(), 0);
  return listed;
}

/// What the checks of a model refuse, said of the element that it comes from.
template <class Check>
void at(const XmlElement& element, Check check) {
  try {
    check();
  } catch (const Error& error) {
    element.fail(error.what());
  }
}

}  // namespace

void check_shell_mesh(const Reader& reader, const XmlElement& place, Part& part) {
  at(place, [&] { check_triangles(part.model.mesh); });
  const int turned = orient(part.model.mesh.triangles);
  if (turned < 0)
    place.fail(
        "the surface has one side only (a Moebius strip), so its triangles cannot get one orientation; cut "
        "it along a line and give the two sides nodes of their own");
  if (turned > 0)
    reader.warn(place, std::to_string(turned) +
                           " shell triangles were turned, so that neighbours have one orientation; each part "
                           "follows its first triangle");
  at(place, [&] { check_shell_edges(part.model); });
}

void read_shell_elements(const Reader& reader, const XmlElement& level, Part& part) {
  for (const auto element : level.all("ShellElements")) {
    ShellFacets facets = facets_for(reader, level, *element, part);
    restrict(reader, *element, part.model.mesh, facets);
    cut(facets, part);
    check_shell_mesh(reader, *element, part);
  }
}

}  // namespace glisson::detail
