// ShellElementSet: which triangles are which membrane or shell, and the nodes that are clamped.
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/core/validation/checks.hpp>
#include <glisson/models/format/reader.hpp>

#include <algorithm>
#include <numeric>

namespace glisson::detail {
namespace {

std::vector<int> selected(const Selection& filter, const Part& part) {
  const auto mask = SelectionMesh(part.model.mesh, facets_of(part.model.mesh.triangles), part.triangle_label)
                        .facet_mask(filter);
  std::vector<int> triangles;
  for (std::size_t e = 0; e < mask.size(); ++e)
    if (mask[e] != 0) triangles.push_back(static_cast<int>(e));
  return triangles;
}

std::vector<int> listed(const XmlElement& set, int count) {
  const auto size = set.attribute("Size");
  if (size == nullptr || size->value == "all") {
    if (set.has_text())
      set.fail(
          "a set without a number as Size holds no list; remove the list or give the number of triangles");
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  return index_list(set, set.integer_attribute("Size"), count, "shell triangles");
}

/// Size or Label, and selections that must hold too.
std::vector<int> triangles_of(const Reader& reader, const XmlElement& set, const Part& part) {
  const auto label = set.attribute("Label");
  const Selection filter = facet_filter(read_choice(reader, set, part.model.mesh));
  const int count = static_cast<int>(part.model.mesh.triangles.size());
  if (label == nullptr && filter.parts.empty()) set.required_attribute("Size");
  if (label != nullptr && set.attribute("Size") != nullptr)
    set.fail("Size and Label cannot both be given; keep one");
  auto triangles = label != nullptr ? labelled(set, *label, part.triangle_label, count, "shell triangle")
                                    : listed(set, count);
  if (filter.parts.empty()) return triangles;
  const auto chosen = selected(filter, part);
  std::erase_if(triangles, [&](int e) { return !std::binary_search(chosen.begin(), chosen.end(), e); });
  if (triangles.empty())
    set.fail(
        "no shell triangle is in the selection; check the direction, the region and the units of its "
        "numbers");
  return triangles;
}

void refuse_second_set(const XmlElement& set, const std::vector<int>& triangles, const Model& model) {
  std::vector<const ShellSection*> owner(model.mesh.triangles.size(), nullptr);
  for (const auto& section : model.shells)
    for (const int e : section.elements) owner[static_cast<std::size_t>(e)] = &section;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (const auto other = owner[static_cast<std::size_t>(triangles[i])])
      set.fail("shell triangle " + std::to_string(triangles[i]) + " is in another set already (" +
               other->name + "); take it out of one of them");
  std::vector<int> sorted = triangles;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) set.fail("it lists shell triangle " + std::to_string(*twice) + " twice");
}

void read_clamped(const Reader& reader, const XmlElement& set, const ShellSection& section, Part& part) {
  const SelectionMesh mesh(part.model.mesh, facets_of(part.model.mesh.triangles), part.triangle_label);
  for (const auto element : set.all("ClampedNodes")) {
    if (section.formulation == ShellFormulation::membrane)
      reader.warn(*element, "it has no effect: a membrane has no bending stiffness");
    std::vector<int> nodes;
    if (element->has_text())
      nodes =
          index_list(*element, element->integer_attribute("NumNodes"), part.model.mesh.node_count(), "nodes");
    else if (const Selection filter = facet_filter(read_choice(reader, *element, part.model.mesh));
             !filter.parts.empty())
      nodes = mesh.nodes(filter);
    if (nodes.empty()) element->fail("it names no node; list them, or choose them with <Box>, <Normal>, ...");
    auto& clamped = part.model.clamped_nodes;
    clamped.insert(clamped.end(), nodes.begin(), nodes.end());
  }
}

void read_set(const Reader& reader, const XmlElement& set, Part& part) {
  if (part.model.mesh.triangles.empty())
    set.fail("there are no shell triangles here; add <ShellElements> beside it");
  ShellSection section;
  section.name = "ShellElementSet at line " + std::to_string(set.line);
  section.elements = triangles_of(reader, set, part);
  if (section.elements.empty()) return reader.warn(set, "the set is empty and has been left out");
  refuse_second_set(set, section.elements, part.model);
  read_shell_material(reader, set.required_child("Material"), part, section);
  read_clamped(reader, set, section, part);
  part.model.shells.push_back(std::move(section));
}

}  // namespace

void read_shell_sets(const Reader& reader, const XmlElement& level, Part& part) {
  const auto sets = level.all("ShellElementSet");
  for (const auto set : sets) read_set(reader, *set, part);
  if (sets.empty()) return;
  try {
    check_shell_edges(part.model);
  } catch (const Error& error) {
    level.required_child("ShellElementSet").fail(error.what());
  }
}

}  // namespace glisson::detail
