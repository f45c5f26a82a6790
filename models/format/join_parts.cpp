#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glisson/models/format/join_parts.hpp>
#include <limits>
#include <unordered_map>

namespace glisson::detail {
namespace {

/// Calls on_nodes(list) for every list of nodes of loads and constraints, on_facets(list) for every list of
/// facets.
template <class Nodes, class Facets>
void for_each_list(Model& model, Nodes on_nodes, Facets on_facets) {
  for (auto& c : model.fixed) on_nodes(c.nodes);
  for (auto& c : model.displacements) on_nodes(c.nodes);
  for (auto& c : model.forces) on_nodes(c.nodes);
  for (auto& c : model.gravity) on_nodes(c.nodes);
  for (auto& c : model.springs) on_nodes(c.nodes);
  for (auto& c : model.planes) on_nodes(c.nodes);
  for (auto& c : model.initial_velocities) on_nodes(c.nodes);
  for (auto& c : model.pressures) on_facets(c.facets);
  for (auto& c : model.tractions) on_facets(c.facets);
}

template <class T>
void move_to_end(std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

void shift(Part& part, int node_offset, int element_offset) {
  Model& model = part.model;
  for (auto& n : model.mesh.nodes) n += node_offset;
  for (auto& section : model.sections)
    for (auto& e : section.elements) e += element_offset;
  for (auto& gravity : model.gravity)  // "all" means all of this part
    if (gravity.nodes.empty())
      for (int n = 0; n < model.mesh.node_count(); ++n) gravity.nodes.push_back(n);
  for_each_list(
      model,
      [&](std::vector<int>& nodes) {
        for (auto& n : nodes) n += node_offset;
      },
      [&](std::vector<Facet>& facets) {
        for (auto& facet : facets) {
          for (int a = facet.node_count() - 1; a >= 0; --a)
            facet.nodes[static_cast<std::size_t>(a)] += node_offset;
          if (facet.element >= 0) facet.element += element_offset;
        }
      });
}

using Arrays = std::map<std::string, NamedArray>;

/// An array that only one of the parts has is 0 on the other.
void append_arrays(Arrays& to, const Arrays& from, std::size_t old_count, std::size_t added) {
  for (const auto& [name, array] : from)
    if (to.find(name) == to.end())
      to[name] = {array.components,
                  std::vector<double>(old_count * static_cast<std::size_t>(array.components), 0.0)};
  for (auto& [name, array] : to) {
    const auto found = from.find(name);
    if (found != from.end() && found->second.components == array.components)
      array.values.insert(array.values.end(), found->second.values.begin(), found->second.values.end());
    array.values.resize((old_count + added) * static_cast<std::size_t>(array.components), 0.0);
  }
}

void append_mesh(Mesh& to, const Mesh& from) {
  const auto old_nodes = to.X.size(), old_elements = to.shape.size();
  if (!to.label.empty() || !from.label.empty()) {
    to.label.resize(old_elements, 0);
    to.label.insert(to.label.end(), from.label.begin(), from.label.end());
    to.label.resize(old_elements + from.shape.size(), 0);
  }
  append_arrays(to.cell_arrays, from.cell_arrays, old_elements, from.shape.size());
  append_arrays(to.point_arrays, from.point_arrays, old_nodes, from.X.size());
  to.X.insert(to.X.end(), from.X.begin(), from.X.end());
  for (int e = 0; e < from.element_count(); ++e)
    to.add_element(from.shape[static_cast<std::size_t>(e)], from.element(e));
}

/// Nodes in cells of the merging distance; a node's partners are in its own and the 26 cells around it.
class NodeGrid {
 public:
  explicit NodeGrid(double cell) : cell_(cell) {}

  void add(int n, const Vec3<double>& x) { cells_[key(cell_of(x))].push_back(n); }

  template <class Body>
  void for_each_near(const Vec3<double>& x, Body body) const {
    const auto centre = cell_of(x);
    for (std::int64_t k = -1; k <= 1; ++k)
      for (std::int64_t j = -1; j <= 1; ++j)
        for (std::int64_t i = -1; i <= 1; ++i) {
          const auto found = cells_.find(key({centre[0] + i, centre[1] + j, centre[2] + k}));
          if (found == cells_.end()) continue;
          for (const int n : found->second) body(n);
        }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(const Vec3<double>& x) const {
    return {std::llround(x.x / cell_), std::llround(x.y / cell_), std::llround(x.z / cell_)};
  }
  /// A hash: cells that share one are only slower, distances decide.
  static std::uint64_t key(const Cell& c) {
    const auto u = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
    return u(c[0]) * 0x9E3779B97F4A7C15U ^ u(c[1]) * 0xC2B2AE3D27D4EB4FU ^ u(c[2]) * 0x165667B19E3779F9U;
  }
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

void check_range(const std::vector<Vec3<double>>& X, double distance, const XmlElement& place) {
  for (const auto& x : X)
    if (std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}) / distance > 1e15)
      place.fail(
          "the distance is too small for coordinates of this size; no two different nodes could be that "
          "near");
}

/// Lists name a merged node once; values that belong to a dropped entry go with it.
template <class... Values>
void renumber(std::vector<int>& nodes, const std::vector<int>& number, std::vector<Values>&... values) {
  const std::size_t old_size = nodes.size();
  std::vector<char> seen(number.size(), 0);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < old_size; ++i) {
    const int n = number[static_cast<std::size_t>(nodes[i])];
    if (seen[static_cast<std::size_t>(n)] != 0) continue;
    seen[static_cast<std::size_t>(n)] = 1;
    ((values.size() == old_size ? void(values[kept] = values[i]) : void()), ...);
    nodes[kept++] = n;
  }
  ((values.size() == old_size && old_size > 1 ? values.resize(kept) : void()), ...);
  nodes.resize(kept);
}

void renumber_lists(Model& model, const std::vector<int>& number) {
  for (auto& c : model.fixed) renumber(c.nodes, number);
  for (auto& c : model.displacements) renumber(c.nodes, number, c.values);
  for (auto& c : model.forces) renumber(c.nodes, number, c.values);
  for (auto& c : model.gravity) renumber(c.nodes, number);
  for (auto& c : model.springs) renumber(c.nodes, number, c.targets, c.stiffness);
  for (auto& c : model.planes) renumber(c.nodes, number);
  for (auto& c : model.initial_velocities) renumber(c.nodes, number);
  const auto on_facets = [&](std::vector<Facet>& facets) {
    for (auto& facet : facets)
      for (int a = facet.node_count() - 1; a >= 0; --a) {
        auto& n = facet.nodes[static_cast<std::size_t>(a)];
        n = number[static_cast<std::size_t>(n)];
      }
  };
  for (auto& c : model.pressures) on_facets(c.facets);
  for (auto& c : model.tractions) on_facets(c.facets);
}

/// Moves the first node that got each number to its place; numbers grow with the nodes, so nothing is
/// overwritten early.
template <class T>
void keep_first(const std::vector<int>& number, std::size_t components, std::vector<T>& values) {
  int next = 0;
  for (std::size_t n = 0; n < number.size(); ++n) {
    if (number[n] != next) continue;
    for (std::size_t c = 0; c < components; ++c)
      values[static_cast<std::size_t>(next) * components + c] = values[n * components + c];
    ++next;
  }
  values.resize(static_cast<std::size_t>(next) * components);
}

void renumber_mesh(Mesh& mesh, const std::vector<int>& number, const XmlElement& place) {
  for (auto& n : mesh.nodes) n = number[static_cast<std::size_t>(n)];
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element(e);
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (nodes[a] == nodes[b])
          place.fail("the distance is larger than an edge of element " + std::to_string(e) +
                     ", which would collapse; make it smaller");
  }
  keep_first(number, 1, mesh.X);
  for (auto& [name, array] : mesh.point_arrays)
    keep_first(number, static_cast<std::size_t>(array.components), array.values);
}

}  // namespace

void append(Part& whole, Part part) {
  const std::int64_t nodes =
      static_cast<std::int64_t>(whole.model.mesh.X.size()) + part.model.mesh.node_count();
  if (nodes > std::numeric_limits<int>::max())
    throw Error(ErrorKind::input, "the sub-models have more nodes together than can be numbered");
  shift(part, whole.model.mesh.node_count(), whole.model.mesh.element_count());
  append_mesh(whole.model.mesh, part.model.mesh);
  move_to_end(part.formulation, whole.formulation);
  move_to_end(part.model.sections, whole.model.sections);
  move_to_end(part.model.fixed, whole.model.fixed);
  move_to_end(part.model.displacements, whole.model.displacements);
  move_to_end(part.model.forces, whole.model.forces);
  move_to_end(part.model.gravity, whole.model.gravity);
  move_to_end(part.model.pressures, whole.model.pressures);
  move_to_end(part.model.tractions, whole.model.tractions);
  move_to_end(part.model.springs, whole.model.springs);
  move_to_end(part.model.planes, whole.model.planes);
  move_to_end(part.model.initial_velocities, whole.model.initial_velocities);
}

std::vector<int> merged_numbers(const std::vector<Vec3<double>>& X, double distance) {
  NodeGrid grid(distance);
  std::vector<int> number(X.size());
  int kept = 0;
  for (std::size_t n = 0; n < X.size(); ++n) {
    int partner = -1;
    grid.for_each_near(X[n], [&](int other) {
      const auto d = X[n] - X[static_cast<std::size_t>(other)];
      if (dot(d, d) < distance * distance && (partner < 0 || other < partner)) partner = other;
    });
    if (partner < 0) grid.add(static_cast<int>(n), X[n]);
    number[n] = partner < 0 ? kept++ : number[static_cast<std::size_t>(partner)];
  }
  return number;
}

int merge_nodes(Part& part, double distance, const XmlElement& place) {
  Mesh& mesh = part.model.mesh;
  check_range(mesh.X, distance, place);
  const auto number = merged_numbers(mesh.X, distance);
  const std::size_t old_count = mesh.X.size();
  renumber_mesh(mesh, number, place);
  renumber_lists(part.model, number);
  return static_cast<int>(old_count - mesh.X.size());
}

}  // namespace glisson::detail
