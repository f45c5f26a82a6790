#include <glisson/contact/deformable/contact_distances.hpp>

#include <algorithm>

namespace glisson::contact {

ContactDistances contact_distances(const DeformableContact& contact, const ContactMesh& mesh) {
  ContactDistances d;
  d.offset = contact.offset;
  d.close = contact.distance.value_or(default_contact_distance(mesh));
  d.slack = 0.01 * mesh.edge_length;
  d.reach = std::max(0.2 * mesh.edge_length, 2 * (d.offset + d.close));
  d.room = 0.15 * mesh.edge_length;
  return d;
}

}  // namespace glisson::contact
