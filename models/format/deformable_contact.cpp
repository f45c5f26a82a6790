// Contact of deformable bodies: what SystemParams says about it, ContactNodes, ContactPair, TiedSurfaces.
#include <glisson/models/format/reader.hpp>
#include <glisson/models/format/suggest.hpp>

#include <algorithm>

namespace glisson::detail {
namespace {

bool switched_on(const XmlElement& system, const char* name) {
  const auto element = system.child(name);
  return element != nullptr && element->integer() != 0;
}

/// NiftySim 2.5 starts to slow an approach at ten times the margin.
void read_distances(const XmlElement& system, DeformableContact& contact) {
  if (const auto margin = system.child("ContactSafetyMargin")) {
    contact.offset = not_negative(*margin);
    if (contact.offset > 0) contact.distance = 10 * contact.offset;
  }
  if (const auto distance = system.child("RateConstraintDistance"))
    if (const double value = not_negative(*distance); value > 0) contact.distance = value;
}

void check_hierarchy_type(const XmlElement& system) {
  const auto type = system.child("BVType");
  if (type == nullptr) return;
  const std::vector<std::string> known{"AABB", "AABB2", "AABB4", "OBB", "OBB2", "OBB4"};
  const auto name = type->required_text();
  if (std::find(known.begin(), known.end(), name) == known.end())
    type->fail("'" + name + "' is not a kind of bounding volume" + suggestion(name, known));
}

/// Distances count for rigid surfaces too.
void warn_of_unused(const Reader& reader, const XmlElement& system, bool wanted, bool rigid) {
  for (const auto name : {"DoMultiPassContacts", "BVType"})
    if (const auto element = system.child(name))
      reader.warn(*element, wanted ? "it has no effect: all contacts of a step are solved together, and one "
                                     "kind of bounding volume is used"
                                   : "it has no effect: contact of deformable bodies is switched off");
  if (wanted) return;
  for (const auto name : {"DeformableFrictionCoefficient", "ContactSafetyMargin", "RateConstraintDistance"})
    if (const auto element = system.child(name);
        element != nullptr && (!rigid || element->is("DeformableFrictionCoefficient")))
      reader.warn(*element, "it has no effect: contact of deformable bodies is switched off");
}

ContactPair read_pair(const XmlElement& element) {
  ContactPair pair;
  pair.where = "ContactPair at line " + std::to_string(element.line);
  pair.a = element.required_attribute("A");
  pair.b = element.required_attribute("B");
  if (const auto touch = element.integer_attribute("Touch")) pair.touch = *touch != 0;
  if (const auto friction = element.child("FrictionCoefficient")) pair.friction = not_negative(*friction);
  return pair;
}

void require_known(const XmlElement& element, const std::vector<NamedElements>& bodies) {
  std::vector<std::string> names;
  for (const NamedElements& body : bodies) names.push_back(body.name);
  for (const char* attribute : {"A", "B"}) {
    const std::string name = element.required_attribute(attribute);
    if (std::find(names.begin(), names.end(), name) == names.end())
      element.fail("no SubModel has Name=\"" + name + "\"" + suggestion(name, names));
  }
}

TiedSurfaces read_tie(const XmlElement& element) {
  TiedSurfaces tie;
  tie.where = "TiedSurfaces at line " + std::to_string(element.line);
  tie.a = element.required_attribute("A");
  tie.b = element.required_attribute("B");
  if (tie.a == tie.b) element.fail("A and B are both \"" + tie.a + "\"; give two different sub-models");
  if (const auto distance = element.number_attribute("Distance")) {
    if (!(*distance > 0)) element.fail("its Distance must be greater than 0");
    tie.distance = distance;
  }
  return tie;
}

/// The last one of contact pairs or ties.
template <class Pair>
void require_first(const XmlElement& element, const std::vector<Pair>& pairs) {
  const Pair& last = pairs.back();
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k)
    if (std::minmax(pairs[k].a, pairs[k].b) == std::minmax(last.a, last.b))
      element.fail("the pair of \"" + last.a + "\" and \"" + last.b + "\" has a " + pairs[k].where +
                   " already; keep one of them");
}

}  // namespace

PenaltyShare read_response(const XmlElement& element, const char* attribute, const PenaltyShare& otherwise) {
  const auto response = element.attribute(attribute);
  const auto stiffness = element.number_attribute("Stiffness");
  if (stiffness && (response == nullptr || response->value != "Penalty"))
    element.fail("its Stiffness belongs to " + std::string(attribute) + "=\"Penalty\"");
  if (stiffness && !(*stiffness > 0 && *stiffness <= 1))
    element.fail("its Stiffness must be greater than 0 and at most 1, above which the step is not stable");
  if (response == nullptr) return otherwise;
  return response->value == "Penalty" ? PenaltyShare(stiffness.value_or(default_penalty)) : PenaltyShare();
}

void read_deformable_contact(const Reader& reader, const XmlElement& model, Part& part) {
  const auto& system = model.required_child("SystemParams");
  DeformableContact& contact = part.model.contact;
  contact.self = switched_on(system, "DoSelfCollision");
  contact.between_bodies = contact.self || switched_on(system, "DoDeformableCollision");
  read_distances(system, contact);
  if (const auto friction = system.child("DeformableFrictionCoefficient"))
    contact.friction = not_negative(*friction);
  if (const auto response = system.child("ContactResponse"))
    contact.penalty = read_response(*response, "Type", {});
  check_hierarchy_type(system);
  warn_of_unused(reader, system, contact.wanted(), !part.model.surfaces.empty());
  if (const auto nodes = model.child("ContactNodes")) {
    contact.nodes =
        index_list(*nodes, nodes->integer_attribute("NumNodes"), part.model.mesh.node_count(), "nodes");
    if (contact.nodes.empty())
      nodes->fail("the list of nodes is empty; without the element all surface nodes may touch");
  }
  for (const auto element : model.all("ContactPair")) {
    contact.pairs.push_back(read_pair(*element));
    require_known(*element, part.model.bodies_by_name);
    require_first(*element, contact.pairs);
    if (const auto friction = element->child("FrictionCoefficient"); friction && !contact.pairs.back().touch)
      reader.warn(*friction, "it has no effect: the two may not touch");
  }
  for (const auto element : model.all("TiedSurfaces")) {
    part.model.ties.push_back(read_tie(*element));
    require_known(*element, part.model.bodies_by_name);
    require_first(*element, part.model.ties);
  }
}

void name_body(const XmlElement& sub_model, Part& part) {
  const auto name = sub_model.attribute("Name");
  if (name == nullptr) return;
  if (name->value.empty()) sub_model.fail(name->line, "the Name is empty; leave it out or give one");
  part.model.bodies_by_name.push_back({name->value, 0, part.model.mesh.element_count(), 0,
                                       static_cast<int>(part.model.mesh.triangles.size())});
}

}  // namespace glisson::detail
