// Contact of deformable bodies: numbers that can be used, nodes and names that exist.
#include <glisson/core/validation/checks.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glisson::detail {
namespace {

void check_names(const Model& model, const std::string& where, const std::string& a, const std::string& b) {
  for (const std::string& name : {a, b}) {
    bool found = false;
    for (const NamedElements& body : model.bodies_by_name) found = found || body.name == name;
    if (!found)
      refuse(where, "there is no sub-model with the name '" + name +
                        "'; names are given by the attribute Name of SubModel");
  }
}

void check_pair(const Model& model, const ContactPair& pair) {
  if (pair.friction) check_friction(*pair.friction, pair.where);
  check_names(model, pair.where, pair.a, pair.b);
}

void check_tie(const Model& model, const TiedSurfaces& tie) {
  check_names(model, tie.where, tie.a, tie.b);
  if (tie.distance && (!(*tie.distance > 0) || !std::isfinite(*tie.distance)))
    refuse(tie.where, "its distance is " + number_text(*tie.distance) + ", but must be greater than 0");
}

/// Pairs of sub-models, in either order.
template <class Pair>
void check_listed_once(const std::vector<Pair>& pairs) {
  for (std::size_t k = 0; k < pairs.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (std::minmax(pairs[k].a, pairs[k].b) == std::minmax(pairs[j].a, pairs[j].b))
        refuse(pairs[k].where,
               "'" + pairs[k].a + "' and '" + pairs[k].b + "' are a pair already; keep one of them");
}

/// Whether all solids hang together through elements.
bool one_solid(const Mesh& mesh) {
  std::vector<int> parent(mesh.X.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int n) {
    while (parent[static_cast<std::size_t>(n)] != n) n = parent[static_cast<std::size_t>(n)];
    return n;
  };
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const int n : mesh.element(e)) {
      const int a = root(mesh.element(e)[0]), b = root(n);
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      parent[static_cast<std::size_t>(n)] = std::min(a, b);
    }
  for (int e = 0; e < mesh.element_count(); ++e)
    if (root(mesh.element(e)[0]) != root(mesh.element(0)[0])) return false;
  return true;
}

}  // namespace

void check_friction(double friction, const std::string& where) {
  if (!(friction >= 0) || !std::isfinite(friction))
    refuse(where, "its friction coefficient is " + number_text(friction) + ", but must not be negative");
}

void check_penalty(const PenaltyShare& share, const std::string& where) {
  if (share && !(*share > 0 && *share <= 1))
    refuse(where, "its penalty stiffness is " + number_text(*share) +
                      ", but must be greater than 0 and at most 1, above which the step is not stable");
}

void check_deformable_contact(const Model& model, Warnings& warnings) {
  const DeformableContact& contact = model.contact;
  const std::string where = "contact of deformable bodies";
  check_friction(contact.friction, where);
  check_penalty(contact.penalty, where);
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
  for (const TiedSurfaces& tie : model.ties) check_tie(model, tie);
  check_listed_once(contact.pairs);
  check_listed_once(model.ties);  // the second one would hold the first one's rows again, in other weights
  if (!contact.wanted()) {
    if (!contact.pairs.empty())
      warnings.push_back("contact pairs have no effect: contact of deformable bodies is switched off");
    return;
  }
  if (model.mesh.element_count() == 0 && model.mesh.triangles.empty())
    refuse(where, "there are no elements that could touch each other");
  if (!contact.self && contact.pairs.empty() && model.mesh.triangles.empty() && one_solid(model.mesh))
    warnings.push_back(where +
                       " has no effect: all elements hang together. For contact of a body with itself "
                       "there is DoSelfCollision");
}

}  // namespace glisson::detail
