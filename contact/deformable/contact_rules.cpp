#include <glisson/contact/deformable/contact_rules.hpp>

#include <algorithm>

#include <glisson/contact/deformable/contact_facets.hpp>

namespace glisson::contact {

ContactRules::ContactRules(const Model& model, const ContactMesh& mesh)
    : between_(model.contact.between_bodies),
      self_(model.contact.self),
      any_self_(model.contact.self),
      friction_(model.contact.friction),
      part_(mesh.part_of_region),
      body_(mesh.body_of_region) {
  for (const NamedElements& body : model.bodies_by_name) names_.push_back(body.name);
  for (const TiedSurfaces& tie : model.ties)
    pairs_[std::minmax(body_named(model, tie.a, tie.where), body_named(model, tie.b, tie.where))] = {
        false, friction_};
  for (const ContactPair& pair : model.contact.pairs) {
    const int a = body_named(model, pair.a, pair.where), b = body_named(model, pair.b, pair.where);
    pairs_[std::minmax(a, b)] = {pair.touch, pair.friction.value_or(friction_)};
    any_self_ = any_self_ || (a == b && pair.touch);
  }
}

const ContactRules::Rule* ContactRules::named(int a, int b) const {
  const auto found = pairs_.find(std::minmax(body_[std::size_t(a)], body_[std::size_t(b)]));
  return found == pairs_.end() ? nullptr : &found->second;
}

bool ContactRules::may_touch(int a, int b) const {
  if (const Rule* rule = named(a, b)) return rule->touch;
  return part_[std::size_t(a)] == part_[std::size_t(b)] ? self_ : between_;
}

double ContactRules::friction(int a, int b) const {
  const Rule* rule = named(a, b);
  return rule ? rule->friction : friction_;
}

bool ContactRules::any_friction() const {
  return friction_ > 0 ||
         std::any_of(pairs_.begin(), pairs_.end(), [](const auto& its) { return its.second.friction > 0; });
}

std::string ContactRules::body_name(int region) const {
  const int body = body_[std::size_t(region)];
  return body == 0 ? "a body without a name" : "sub-model '" + names_[std::size_t(body - 1)] + "'";
}

}  // namespace glisson::contact
