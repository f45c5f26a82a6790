#include <glisson/contact/deformable/contact_distances.hpp>

#include <algorithm>

#include <glisson/contact/rate_distance.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>

namespace glisson::contact {

ContactDistances contact_distances(const DeformableContact& contact, const ContactMesh& mesh) {
  ContactDistances d;
  d.offset = contact.offset;
  d.close = contact.distance.value_or(rate_distance(mesh.shortest, mesh.longest));
  // they are searched twice as far behind a surface (four times at the start)
  if (!within_half_an_edge(d.offset + d.close, mesh.edge_length))
    throw Error(
        ErrorKind::input,
        "it keeps a gap of " + number_text(d.offset) + " (ContactSafetyMargin) and slows approaches below " +
            number_text(d.close) +
            " more (RateConstraintDistance, by default ten times the margin), too much for surface edges "
            "of " +
            number_text(mesh.edge_length) + ": both together can be half of an edge. Make them smaller",
        {"", 0, contact_place});
  d.slack = 0.01 * mesh.edge_length;
  d.reach = std::max(0.2 * mesh.edge_length, 2 * (d.offset + d.close));
  d.penalty = contact.penalty.value_or(0);
  // what the sides of sheets face turns faster: with more, a sheet that flies askew at an edge is cut by it
  const double share = mesh.beside.empty() ? 1 : 0.5;
  d.room = share * 0.15 * mesh.edge_length;
  d.steps = share * 3;
  d.swing = 1 + 2 * mesh.largest_offset() / mesh.edge_length;
  return d;
}

}  // namespace glisson::contact
