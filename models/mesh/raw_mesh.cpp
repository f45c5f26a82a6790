#include <glisson/models/mesh/raw_mesh.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson::detail {
namespace {

[[noreturn]] void fail_at(const std::string& file, std::size_t cell, const std::string& message) {
  throw Error(ErrorKind::input, message, {file, 0, "cell " + std::to_string(cell)});
}

void check_nodes(const RawMesh& raw, std::size_t c, const std::string& file) {
  for (const int n : raw.cell(c))
    if (n < 0 || static_cast<std::size_t>(n) >= raw.X.size())
      fail_at(file, c,
              "node " + std::to_string(n) + " does not exist; there are " + std::to_string(raw.X.size()) +
                  ", numbered from 0");
  const int wanted = nodes_of_cell(raw.code[c]);
  if (wanted != 0 && raw.cell(c).size() != static_cast<std::size_t>(wanted))
    fail_at(file, c,
            "a " + name_of_cell(raw.code[c]) + " has " + std::to_string(wanted) + " nodes, but " +
                std::to_string(raw.cell(c).size()) + " are listed");
}

void add_solid(const RawMesh& raw, std::size_t c, Mesh& mesh) {
  const auto nodes = raw.cell(c);
  if (raw.code[c] == cell_tetrahedron) return mesh.add_element(Shape::tetrahedron, nodes);
  if (raw.code[c] == cell_hexahedron) return mesh.add_element(Shape::hexahedron, nodes);
  // A voxel lists its nodes with x fastest, then y, then z.
  mesh.add_element(Shape::hexahedron, std::array{nodes[0], nodes[1], nodes[3], nodes[2], nodes[4], nodes[5],
                                                 nodes[7], nodes[6]});
}

/// Material parameters must not come from holes, and results with a NaN are never written: such arrays are
/// left out.
void keep_array(const std::string& name, NamedArray array, const char* kind,
                std::map<std::string, NamedArray>& kept, std::vector<std::string>& warnings) {
  const auto hole =
      std::find_if_not(array.values.begin(), array.values.end(), [](double v) { return std::isfinite(v); });
  if (hole == array.values.end()) {
    kept[name] = std::move(array);
    return;
  }
  const auto row = (hole - array.values.begin()) / array.components;
  warnings.push_back("array " + quoted(name) + " has no finite value at " + kind + " " + std::to_string(row) +
                     " and was left out");
}

bool is_label(const NamedArray& array) {
  constexpr double most = std::numeric_limits<int>::max();
  return array.components == 1 && std::all_of(array.values.begin(), array.values.end(), [](double v) {
           return v == std::nearbyint(v) && std::fabs(v) <= most;
         });
}

/// Takes the first of the usual names whose values are whole numbers out of the arrays.
void take_label(std::map<std::string, NamedArray>& arrays, std::vector<int>& label) {
  constexpr const char* names[] = {
      "label",          "labels",        "region",     "regions",         "material",        "materials",
      "material_id",    "material_ids",  "materialid", "materialids",     "physicalids",     "gmsh:physical",
      "celldata:label", "cellentityids", "medit:ref",  "elementblockids", "gmsh:geometrical"};
  for (const auto wanted : names)
    for (auto array = arrays.begin(); array != arrays.end(); ++array) {
      if (!same_word(array->first, wanted) || !is_label(array->second)) continue;
      for (const double v : array->second.values) label.push_back(static_cast<int>(v));
      arrays.erase(array);
      return;
    }
}

void turn_tetrahedra(Mesh& mesh, std::vector<std::string>& warnings) {
  int turned = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.shape[static_cast<std::size_t>(e)] != Shape::tetrahedron) continue;
    const auto nodes = mesh.element(e);
    const auto at = [&](std::size_t a) { return mesh.X[static_cast<std::size_t>(nodes[a])]; };
    if (!(dot(cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) < 0)) continue;
    auto* first = mesh.nodes.data() + mesh.begin[static_cast<std::size_t>(e)];
    std::swap(first[2], first[3]);
    ++turned;
  }
  if (turned > 0)
    warnings.push_back(std::to_string(turned) +
                       " tetrahedra have their nodes in the inverted order and were turned");
}

/// "3 triangles, 1 line": what a file without solids has instead.
std::string inventory(const RawMesh& raw) {
  std::array<std::size_t, 256> counts{};
  for (const auto code : raw.code) ++counts[code];
  std::string text;
  for (std::size_t code = 0; code < counts.size(); ++code)
    if (counts[code] > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(counts[code]) + " x " +
              name_of_cell(static_cast<int>(code));
  return text.empty() ? "no cells at all" : text;
}

std::vector<std::size_t> add_solids(const RawMesh& raw, const std::string& file, Mesh& mesh) {
  std::vector<std::size_t> chosen;
  for (std::size_t c = 0; c < raw.cell_count(); ++c) {
    const auto use = use_of(raw.code[c]);
    if (use == CellUse::other_solid || use == CellUse::unknown)
      fail_at(
          file, c,
          "a " + name_of_cell(raw.code[c]) +
              " is not supported. Convert the mesh to linear tetrahedra (4 nodes) or hexahedra (8 nodes)");
    if (use != CellUse::solid) continue;
    check_nodes(raw, c, file);
    if (mesh.nodes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()) - 8)
      fail_at(file, c, "the mesh is too large: all elements together may list 2147483647 nodes");
    add_solid(raw, c, mesh);
    chosen.push_back(c);
  }
  if (chosen.empty())
    throw Error(ErrorKind::input,
                "there is no tetrahedron and no hexahedron in it (" + inventory(raw) +
                    "), but a solid is needed. Export the volume elements, or use the file as a surface",
                {file, 0, {}});
  return chosen;
}

/// Cuts a polygon, or a strip, into facets; true when one was dropped because it has a node twice.
bool add_facets(std::span<const int> nodes, int code, std::vector<Facet>& facets) {
  bool dropped = false;
  const auto add = [&](int a, int b, int c, int d) {
    if (a == b || b == c || c == a || (d >= 0 && (d == a || d == b || d == c)))
      dropped = true;
    else
      facets.push_back({{a, b, c, d}, -1});
  };
  if (code == cell_pixel)
    add(nodes[0], nodes[1], nodes[3], nodes[2]);
  else if (code == cell_strip)
    for (std::size_t i = 0; i + 2 < nodes.size(); ++i)
      i % 2 == 0 ? add(nodes[i], nodes[i + 1], nodes[i + 2], -1)
                 : add(nodes[i + 1], nodes[i], nodes[i + 2], -1);
  else if (nodes.size() == 4)
    add(nodes[0], nodes[1], nodes[2], nodes[3]);
  else
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) add(nodes[0], nodes[i], nodes[i + 1], -1);
  return dropped;
}

/// Facets that the file lists; which cell each came from. True when there are solids too.
bool listed_facets(RawMesh& raw, const std::string& file, std::vector<Facet>& facets,
                   std::vector<std::size_t>& cells) {
  std::size_t dropped = 0;
  bool solids = false;
  for (std::size_t c = 0; c < raw.cell_count(); ++c) {
    const auto use = use_of(raw.code[c]);
    solids |= use == CellUse::solid;
    if (use == CellUse::curved_facet || use == CellUse::unknown)
      fail_at(file, c,
              "a " + name_of_cell(raw.code[c]) + " is not supported. Convert the surface to triangles");
    if (use != CellUse::facet) continue;
    check_nodes(raw, c, file);
    if (raw.cell(c).size() < 3) fail_at(file, c, "a facet needs at least 3 nodes");
    dropped += add_facets(raw.cell(c), raw.code[c], facets);
    cells.resize(facets.size(), c);
  }
  if (dropped > 0)
    raw.warnings.push_back(std::to_string(dropped) + " facets have the same vertex twice and were left out");
  return solids;
}

}  // namespace

NamedArray chosen_rows(const NamedArray& array, const std::vector<std::size_t>& chosen) {
  NamedArray result{array.components, {}};
  const auto components = static_cast<std::size_t>(array.components);
  result.values.reserve(chosen.size() * components);
  for (const auto c : chosen)
    for (std::size_t i = 0; i < components; ++i) result.values.push_back(array.values[c * components + i]);
  return result;
}

LabelledSurface labelled_surface(RawMesh& raw, const std::string& file) {
  LabelledSurface result;
  std::vector<std::size_t> cells;
  listed_facets(raw, file, result.surface.facets, cells);
  if (!raw.label.empty())
    for (const auto c : cells) result.label.push_back(raw.label[c]);
  for (const auto& [name, array] : raw.cell_arrays)
    if (array.values.size() == raw.cell_count() * static_cast<std::size_t>(array.components))
      keep_array(name, chosen_rows(array, cells), "facet", result.arrays, raw.warnings);
  if (result.label.empty()) take_label(result.arrays, result.label);
  result.label.resize(cells.size(), 0);
  result.surface.X = std::move(raw.X);
  return result;
}

Mesh solid_mesh(RawMesh& raw, const std::string& file) {
  Mesh mesh;
  const auto chosen = add_solids(raw, file, mesh);
  if (!raw.label.empty())
    for (const auto c : chosen) mesh.label.push_back(raw.label[c]);
  for (const auto& [name, array] : raw.cell_arrays)
    keep_array(name, chosen_rows(array, chosen), "cell", mesh.cell_arrays, raw.warnings);
  for (auto& [name, array] : raw.point_arrays)
    keep_array(name, std::move(array), "point", mesh.point_arrays, raw.warnings);
  mesh.X = std::move(raw.X);
  if (mesh.label.empty()) take_label(mesh.cell_arrays, mesh.label);
  turn_tetrahedra(mesh, raw.warnings);
  return mesh;
}

SurfaceMesh surface_mesh(RawMesh& raw, const std::string& file) {
  SurfaceMesh surface;
  std::vector<std::size_t> cells;
  const bool solids = listed_facets(raw, file, surface.facets, cells);
  if (!surface.facets.empty()) {
    surface.X = std::move(raw.X);
    return surface;
  }
  if (!solids)
    throw Error(ErrorKind::input, "there is no facet in it (" + inventory(raw) + "), but a surface is needed",
                {file, 0, {}});
  Mesh mesh = solid_mesh(raw, file);
  surface.facets = outer_surface(mesh);
  surface.X = std::move(mesh.X);
  return surface;
}

}  // namespace glisson::detail
