// ElementSet: which elements have which material and formulation.
#include <glisson/models/format/reader.hpp>

#include <algorithm>

namespace glisson::detail {
namespace {

std::vector<int> elements_of(const XmlElement& set, const Mesh& mesh) {
  const auto label = set.attribute("Label");
  if (label != nullptr) {
    if (set.attribute("Size") != nullptr) set.fail("Size and Label cannot both be given; keep one");
    if (set.has_text()) set.fail("a set chosen by Label holds no list; remove the list or the Label");
    return labelled(set, *label, mesh.label, mesh.element_count(), "element");
  }
  if (set.required_attribute("Size") == "all") {
    if (set.has_text())
      set.fail("a set of Size=\"all\" holds no list; remove the list or give the number of elements");
    std::vector<int> all(static_cast<std::size_t>(mesh.element_count()));
    for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<int>(e);
    return all;
  }
  return index_list(set, set.integer_attribute("Size"), mesh.element_count(), "elements");
}

/// The part of a section's elements with one formulation, and the same part of its per-element parameters.
Section part_with(const Section& whole, const std::vector<Formulation>& formulation, Formulation wanted) {
  Section part{whole.name, wanted, whole.material, {}, whole.hourglass};
  for (auto& [index, values] : part.material.element_parameters) values.clear();
  for (std::size_t i = 0; i < whole.elements.size(); ++i) {
    const int e = whole.elements[i];
    if (formulation[static_cast<std::size_t>(e)] != wanted) continue;
    part.elements.push_back(e);
    for (std::size_t k = 0; k < part.material.element_parameters.size(); ++k)
      part.material.element_parameters[k].second.push_back(whole.material.element_parameters[k].second[i]);
  }
  return part;
}

void override_formulation(const XmlElement& set, const std::vector<int>& elements, Part& part) {
  const auto attribute = set.attribute("Formulation");
  if (attribute == nullptr) return;
  const Formulation wanted = *formulation_named(attribute->value);
  for (const int e : elements) {
    auto& formulation = part.formulation[static_cast<std::size_t>(e)];
    if (shape_of(wanted) != shape_of(formulation))
      set.fail(attribute->line, "Formulation=\"" + attribute->value + "\" does not fit element " +
                                    std::to_string(e) + ", which has another shape; split the set by shape");
    formulation = wanted;
  }
}

}  // namespace

std::vector<int> integers_of(const XmlElement& element, const XmlAttribute& attribute) {
  std::vector<int> values;
  for_each_token(XmlText{attribute.value, attribute.line}, [&](std::string_view token, int) {
    const auto value = to_integer(token);
    if (!value || *value != static_cast<int>(*value))
      element.fail(attribute.line, attribute.name + "=\"" + attribute.value +
                                       "\" holds something that is not a whole number");
    values.push_back(static_cast<int>(*value));
  });
  return values;
}

std::vector<int> labelled(const XmlElement& set, const XmlAttribute& attribute, const std::vector<int>& label,
                          int count, const char* what) {
  const std::vector<int> labels = integers_of(set, attribute);
  std::vector<int> found;
  for (int e = 0; e < count; ++e) {
    const int its_label = label.empty() ? 0 : label[static_cast<std::size_t>(e)];
    if (std::find(labels.begin(), labels.end(), its_label) != labels.end()) found.push_back(e);
  }
  if (found.empty())
    set.fail(attribute.line, std::string("no ") + what + " has Label=\"" + attribute.value + "\"" +
                                 (label.empty() ? "; the mesh has no labels" : "") +
                                 "; `glisson info` lists the labels of a mesh");
  return found;
}

std::vector<int> index_list(const XmlElement& element, std::optional<int> count, int size, const char* what) {
  auto indices = element.integers();
  const auto fail_range = [&](std::int64_t index) {
    element.fail("index " + std::to_string(index) + " is outside the " + what + " 0 to " +
                 std::to_string(size - 1));
  };
  if (count && *count < 0) element.fail("a count of " + std::to_string(*count) + " is negative");
  if (count && indices.size() == 1 && *count > 1) {  // start index
    const std::int64_t first = indices[0], last = first + *count - 1;
    if (first < 0 || first >= size) fail_range(first);
    if (last >= size) fail_range(last);
    indices.resize(static_cast<std::size_t>(*count));
    for (std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = static_cast<int>(first) + static_cast<int>(i);
  }
  if (count && indices.size() != static_cast<std::size_t>(*count))
    element.fail("it lists " + std::to_string(indices.size()) + " " + what + " where " +
                 std::to_string(*count) + " are announced; give as many, or one start index");
  for (const int index : indices)
    if (index < 0 || index >= size) fail_range(index);
  return indices;
}

void read_element_sets(const Reader& reader, const XmlElement& level, Part& part) {
  for (const auto set : level.all("ElementSet")) {
    Section whole;
    whole.name = "ElementSet at line " + std::to_string(set->line);
    whole.elements = elements_of(*set, part.model.mesh);
    if (whole.elements.empty()) {
      reader.warn(*set, "the set is empty and has been left out");
      continue;
    }
    override_formulation(*set, whole.elements, part);
    whole.material = read_material(reader, set->required_child("Material"), part.model.mesh, whole.elements);
    whole.hourglass = reader.hourglass.value_or(whole.hourglass);
    for (const auto formulation : {Formulation::t4, Formulation::t4anp, Formulation::h8,
                                   Formulation::h8_fixed, Formulation::h8_full}) {
      auto section = part_with(whole, part.formulation, formulation);
      if (!section.elements.empty()) part.model.sections.push_back(std::move(section));
    }
  }
}

}  // namespace glisson::detail
