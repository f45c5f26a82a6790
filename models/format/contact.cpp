// ContactPlate, ContactCylinder, ContactUSProbe: analytic rigid bodies that move over time.
#include <glisson/models/format/reader.hpp>

#include <cmath>

namespace glisson::detail {
namespace {

double positive(const XmlElement& body, const char* name) {
  const auto& element = body.required_child(name);
  const double value = element.number();
  if (!(value > 0)) element.fail("it is " + element.text() + ", but must be greater than 0");
  return value;
}

Vec3<double> optional_vector(const XmlElement& body, const char* name) {
  const auto element = body.child(name);
  return element != nullptr ? vector_of(*element) : Vec3<double>{};
}

RigidBody common(const Reader& reader, const XmlElement& element, RigidShape shape, const Mesh& mesh) {
  RigidBody body;
  body.shape = shape;
  body.name = element.name + " at line " + std::to_string(element.line);
  body.motion = read_curve(reader, element, "LoadShape", "Table", LoadShape::poly345);
  if (const auto friction = element.child("FrictionCoefficient")) body.friction = not_negative(*friction);
  if (const auto slaves = element.child("SlvNodes")) {
    const auto count = slaves->attribute("NumNodes");
    if (count != nullptr && count->value == "all") {
      for (int n = 0; n < mesh.node_count(); ++n) body.nodes.push_back(n);
    } else {
      body.nodes = index_list(*slaves, slaves->integer_attribute("NumNodes"), mesh.node_count(), "nodes");
    }
    if (body.nodes.empty())
      slaves->fail("the list of nodes is empty; without the element all surface nodes may touch the body");
  }
  return body;
}

void read_round(const Reader& reader, const XmlElement& element, RigidShape shape, Model& model) {
  auto body = common(reader, element, shape, model.mesh);
  body.origin = vector_of(element.required_child("Origin"));
  const auto& axis = element.required_child("Axis");
  const auto raw = vector_of(axis);
  body.axis = direction_of(axis);
  if (std::abs(std::sqrt(dot(raw, raw)) - 1) > 1e-4)
    reader.warn(axis, "the axis is not a unit vector; it has been scaled to one");
  body.radius = positive(element, "Radius");
  body.length = positive(element, "Length");
  body.displacement = optional_vector(element, "OrigDisp");
  if (const auto change = element.child("RadChange")) {
    body.radius_change = change->number();
    if (body.radius + body.radius_change < 0) change->fail("the radius would become negative");
  }
  model.bodies.push_back(std::move(body));
}

void read_plate(const Reader& reader, const XmlElement& element, Model& model) {
  auto body = common(reader, element, RigidShape::plate, model.mesh);
  body.corners = {vector_of(element.required_child("a")), vector_of(element.required_child("b")),
                  vector_of(element.required_child("c"))};
  const auto normal = cross(body.corners[1] - body.corners[0], body.corners[2] - body.corners[0]);
  if (!(dot(normal, normal) > 0))
    element.fail("the corners a, b and c lie on one line, so the plate has no side");
  body.displacement = optional_vector(element, "Disp");
  model.bodies.push_back(std::move(body));
}

}  // namespace

void read_contact(const Reader& reader, const XmlElement& model, Part& part) {
  for (const auto& element : model.children) {
    if (element.is("ContactCylinder")) read_round(reader, element, RigidShape::cylinder, part.model);
    if (element.is("ContactUSProbe")) read_round(reader, element, RigidShape::probe, part.model);
    if (element.is("ContactPlate")) read_plate(reader, element, part.model);
  }
}

}  // namespace glisson::detail
