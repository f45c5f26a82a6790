// Who may touch whom, and how rough they are.
#pragma once

#include <map>
#include <utility>

#include <glisson/contact/deformable/contact_mesh.hpp>

namespace glisson::contact {

/// Bodies that are tied to each other do not touch, unless a pair says so.
class ContactRules {
 public:
  /// Throws Error(input) for a pair that names a body which does not exist.
  ContactRules(const Model& model, const ContactMesh& mesh);

  /// Whether two regions of the mesh may touch; a region with itself: self-contact.
  bool may_touch(int region_a, int region_b) const;
  double friction(int region_a, int region_b) const;
  bool any_friction() const;
  /// "sub-model 'liver'" for messages; "a body without a name".
  std::string body_name(int region) const;
  /// Whether any part may touch itself, so that the search has to look within parts.
  bool any_self_contact() const { return any_self_; }

 private:
  struct Rule {
    bool touch;
    double friction;
  };
  const Rule* named(int region_a, int region_b) const;

  bool between_, self_, any_self_;
  double friction_;
  std::map<std::pair<int, int>, Rule> pairs_;  ///< by bodies, the lower first
  std::vector<int> part_, body_;               ///< [region_count]
  std::vector<std::string> names_;             ///< of Model::bodies_by_name
};

}  // namespace glisson::contact
