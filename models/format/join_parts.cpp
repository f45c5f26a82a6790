#include <glisson/models/format/join_parts.hpp>

#include <glisson/models/mesh/transform.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

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
  on_nodes(model.clamped_nodes);
  for (auto& c : model.pressures) on_facets(c.facets);
  for (auto& c : model.tractions) on_facets(c.facets);
}

template <class T>
void move_to_end(std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

void shift(Part& part, int node_offset, int element_offset, int triangle_offset) {
  Model& model = part.model;
  for (auto& n : model.mesh.nodes) n += node_offset;
  for (auto& triangle : model.mesh.triangles)
    for (auto& n : triangle) n += node_offset;
  for (auto& section : model.shells)
    for (auto& e : section.elements) e += triangle_offset;
  for (auto& section : model.sections)
    for (auto& e : section.elements) e += element_offset;
  for (auto& body : model.bodies_by_name) {
    body.first += element_offset;
    body.first_triangle += triangle_offset;
  }
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
  to.triangles.insert(to.triangles.end(), from.triangles.begin(), from.triangles.end());
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
  renumber(model.clamped_nodes, number);
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

}  // namespace

void append_arrays(std::map<std::string, NamedArray>& to, const std::map<std::string, NamedArray>& from,
                   std::size_t old_count, std::size_t added) {
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

void append(Part& whole, Part part) {
  const std::int64_t nodes =
      static_cast<std::int64_t>(whole.model.mesh.X.size()) + part.model.mesh.node_count();
  if (nodes > std::numeric_limits<int>::max())
    throw Error(ErrorKind::input, "the sub-models have more nodes together than can be numbered");
  const std::size_t old_triangles = whole.model.mesh.triangles.size();
  shift(part, whole.model.mesh.node_count(), whole.model.mesh.element_count(),
        static_cast<int>(old_triangles));
  append_mesh(whole.model.mesh, part.model.mesh);
  append_arrays(whole.triangle_arrays, part.triangle_arrays, old_triangles, part.model.mesh.triangles.size());
  move_to_end(part.triangle_label, whole.triangle_label);
  move_to_end(part.model.shells, whole.model.shells);
  move_to_end(part.model.clamped_nodes, whole.model.clamped_nodes);
  move_to_end(part.formulation, whole.formulation);
  move_to_end(part.model.sections, whole.model.sections);
  move_to_end(part.model.bodies_by_name, whole.model.bodies_by_name);
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

int merge_nodes(Part& part, double distance, const XmlElement& place) {
  Mesh& mesh = part.model.mesh;
  const int old_count = mesh.node_count();
  try {
    renumber_lists(part.model, glisson::merge_nodes(mesh, distance));
  } catch (const Error& error) {
    place.fail(error.what());
  }
  return old_count - mesh.node_count();
}

}  // namespace glisson::detail
