// Contact of deformable bodies: numbers that can be used, nodes and names that exist.
#include <glisson/core/validation/checks.hpp>

#include <cmath>

namespace glisson::detail {
namespace {

void check_friction(double friction, const std::string& where) {
  if (!(friction >= 0) || !std::isfinite(friction))
    refuse(where, "its friction coefficient is " + number_text(friction) + ", but must not be negative");
}

void check_pair(const Model& model, const ContactPair& pair) {
  if (pair.friction) check_friction(*pair.friction, pair.where);
  for (const std::string& name : {pair.a, pair.b}) {
    bool found = false;
    for (const NamedElements& body : model.bodies_by_name) found = found || body.name == name;
    if (!found)
      refuse(pair.where, "there is no sub-model with the name '" + name +
                             "'; names are given by the attribute Name of SubModel");
  }
}

}  // namespace

void check_deformable_contact(const Model& model, Warnings& warnings) {
  const DeformableContact& contact = model.contact;
  const std::string where = "contact of deformable bodies";
  check_friction(contact.friction, where);
  if (!(contact.offset >= 0) || !std::isfinite(contact.offset))
    refuse(where, "its safety margin is " + number_text(contact.offset) + ", but must not be negative");
  if (contact.distance && (!(*contact.distance > 0) || !std::isfinite(*contact.distance)))
    refuse(where, "its rate constraint distance is " + number_text(*contact.distance) +
                      ", but must be greater than 0");
  for (const int n : contact.nodes)
    if (n < 0 || n >= model.mesh.node_count())
      refuse(where, "node " + std::to_string(n) + " does not exist: the mesh has nodes 0 to " +
                        std::to_string(model.mesh.node_count() - 1));
  for (const ContactPair& pair : contact.pairs) check_pair(model, pair);
  if (!contact.wanted()) {
    if (!contact.pairs.empty())
      warnings.push_back("contact pairs have no effect: contact of deformable bodies is switched off");
    return;
  }
  if (model.mesh.element_count() == 0)
    refuse(where, "there are no solid elements that could touch each other");
}

}  // namespace glisson::detail
