// What a constraint acts on, from its XML: lists, NumNodes="all", selection elements, Select trees and
// RestrictTo.
#include <glisson/models/format/reader.hpp>

#include <algorithm>

namespace glisson::detail {
namespace {

using Kind = Selection::Kind;

constexpr const char* leaf_names[] = {"Normal", "Box",     "Sphere", "HalfSpace",
                                      "Label",  "Surface", "All",    "Distance"};

Selection with_numbers(Kind kind, const std::vector<double>& values) {
  Selection selection{kind, {}, {}, {}, {}};
  std::copy(values.begin(), values.end(), selection.numbers.begin());
  return selection;
}

Selection normal_leaf(const XmlElement& leaf) {
  const auto angle = leaf.number_attribute("ToleranceAngle");
  if (!angle) leaf.required_attribute("ToleranceAngle");
  if (!(*angle >= 0 && *angle <= 180)) leaf.fail("ToleranceAngle must be within 0 and 180 degrees");
  const auto n = direction_of(leaf);
  return with_numbers(Kind::normal, {n.x, n.y, n.z, *angle});
}

Selection box_leaf(const XmlElement& leaf) {
  const auto v = leaf.numbers(6);
  for (std::size_t i = 0; i < 6; i += 2)
    if (v[i] > v[i + 1])
      leaf.fail("a box is xmin xmax ymin ymax zmin zmax, but a minimum here is above its maximum");
  return with_numbers(Kind::box, v);
}

Selection sphere_leaf(const XmlElement& leaf) {
  const auto v = leaf.numbers(4);
  if (!(v[0] > 0)) leaf.fail("a sphere is radius x y z, but the radius here is not positive");
  return with_numbers(Kind::sphere, v);
}

Selection half_space_leaf(const XmlElement& leaf) {
  const auto v = leaf.numbers(6);
  if (v[3] == 0 && v[4] == 0 && v[5] == 0)
    leaf.fail("a half-space is a point and a normal, but the normal here is the zero vector");
  return with_numbers(Kind::half_space, v);
}

Selection distance_leaf(const Reader& reader, const XmlElement& leaf) {
  const auto largest = leaf.number_attribute("Max");
  if (!largest) leaf.required_attribute("Max");
  if (!(*largest > 0)) leaf.fail("Max, the largest distance, must be greater than 0");
  Selection selection = with_numbers(Kind::distance, {*largest});
  selection.to_surface = distance_from_file(reader, leaf, *largest);
  return selection;
}

Selection label_leaf(const XmlElement& leaf) {
  Selection selection{Kind::label, {}, leaf.integers(), {}, {}};
  if (selection.integers.empty()) leaf.fail("it lists no label");
  return selection;
}

Selection read_select(const Reader& reader, const XmlElement& select, const Mesh& mesh);

/// All selection elements directly inside `parent`, except <Nodes>.
void append_leaves(const Reader& reader, const XmlElement& parent, const Mesh& mesh,
                   std::vector<Selection>& parts) {
  for (const auto name : leaf_names)
    for (const auto leaf : parent.all(name)) parts.push_back(read_leaf(reader, *leaf, name, mesh));
  for (const auto select : parent.all("Select")) parts.push_back(read_select(reader, *select, mesh));
}

Selection read_select(const Reader& reader, const XmlElement& select, const Mesh& mesh) {
  const auto op = select.attribute("Op");
  const std::string name = op != nullptr ? op->value : "and";
  Selection selection{name == "or"    ? Kind::either
                      : name == "not" ? Kind::neither
                                      : Kind::both,
                      {},
                      {},
                      {},
                      {}};
  for (const auto nodes : select.all("Nodes"))
    selection.parts.push_back(read_leaf(reader, *nodes, "Nodes", mesh));
  append_leaves(reader, select, mesh, selection.parts);
  if (selection.parts.empty())
    select.fail("it holds nothing to combine; put selections such as <Box> into it");
  return selection;
}

bool truth(const XmlElement& element, const char* name) {
  const auto attribute = element.attribute(name);
  return attribute != nullptr && attribute->value == "1";
}

Selection read_restriction(const Reader& reader, const XmlElement& restriction, const Mesh& mesh) {
  auto selection = read_leaf(reader, restriction, restriction.required_attribute("Type"), mesh);
  if (!truth(restriction, "Invert")) return selection;
  return Selection{Kind::neither, {}, {}, {}, {std::move(selection)}};
}

std::optional<int> announced_nodes(const XmlElement& constraint, bool& all) {
  const auto attribute = constraint.attribute("NumNodes");
  all = attribute != nullptr && attribute->value == "all";
  return all ? std::nullopt : constraint.integer_attribute("NumNodes");
}

/// The element that SpecType asks for must be there; without SpecType the elements speak for themselves.
void check_spec_type(const XmlElement& constraint) {
  const auto spec = constraint.attribute("SpecType");
  if (spec == nullptr) return;
  for (const auto name : {"Nodes", "Normal", "Box", "Sphere", "HalfSpace", "Label", "Distance", "Select"})
    if (same_name(spec->value, name) && constraint.child(name) == nullptr) {
      bool all = false;
      const auto count = announced_nodes(constraint, all);
      if (same_name(name, "Nodes") && (all || count == 0 || constraint.child("Faces") != nullptr ||
                                       constraint.attribute("NumFaces") != nullptr))
        return;
      constraint.fail(spec->line,
                      "SpecType=\"" + spec->value + "\" needs the element <" + name + "> inside it");
    }
}

void read_list(const XmlElement& constraint, const Mesh& mesh, Choice& choice) {
  bool all = false;
  const auto count = announced_nodes(constraint, all);
  const auto spec = constraint.attribute("SpecType");
  if (spec != nullptr && spec->value != "NODES") return;  // NORMAL beats NumNodes
  const auto lists = constraint.all("Nodes");
  if (all) {
    if (!lists.empty()) lists[0]->fail("a list stands beside NumNodes=\"all\"; remove one of them");
    choice.filter.parts.push_back({Kind::all, {}, {}, {}, {}});
    return;
  }
  if (lists.size() > 1) lists[1]->fail("a second list of nodes; join the lists or use <Select Op=\"or\">");
  if (count && *count == 0 && (lists.empty() || !lists[0]->has_text())) {
    choice.empty_on_purpose = true;
  } else if (!lists.empty()) {
    const auto own = lists[0]->integer_attribute("NumNodes");
    choice.list = index_list(*lists[0], count ? count : own, mesh.node_count(), "nodes");
    if (choice.list->empty()) lists[0]->fail("the list of nodes is empty");
  } else if (count) {
    constraint.fail("NumNodes=\"" + std::to_string(*count) + "\" needs the element <Nodes> inside it");
  }
}

}  // namespace

Selection read_leaf(const Reader& reader, const XmlElement& leaf, const std::string& type, const Mesh& mesh) {
  if (type == "Normal") return normal_leaf(leaf);
  if (type == "Box") return box_leaf(leaf);
  if (type == "Sphere") return sphere_leaf(leaf);
  if (type == "HalfSpace") return half_space_leaf(leaf);
  if (type == "Distance") return distance_leaf(reader, leaf);
  if (type == "Label") return label_leaf(leaf);
  if (type == "Nodes")
    return {Kind::nodes,
            {},
            index_list(leaf, leaf.integer_attribute("NumNodes"), mesh.node_count(), "nodes"),
            {},
            {}};
  return {type == "Surface" ? Kind::surface : Kind::all, {}, {}, {}, {}};
}

Selection facet_filter(Choice choice) {
  if (choice.list) choice.filter.parts.push_back({Kind::nodes, {}, std::move(*choice.list), {}, {}});
  return std::move(choice.filter);
}

Choice read_choice(const Reader& reader, const XmlElement& constraint, const Mesh& mesh) {
  Choice choice;
  check_spec_type(constraint);
  read_list(constraint, mesh, choice);
  append_leaves(reader, constraint, mesh, choice.filter.parts);
  for (const auto restriction : constraint.all("RestrictTo"))
    choice.filter.parts.push_back(read_restriction(reader, *restriction, mesh));
  const auto spec = constraint.attribute("SpecType");
  if (spec != nullptr && spec->value == "SURFACE")
    choice.filter.parts.push_back({Kind::surface, {}, {}, {}, {}});
  return choice;
}

}  // namespace glisson::detail
