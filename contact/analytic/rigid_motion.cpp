#include <glisson/contact/analytic/rigid_motion.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/surface.hpp>

namespace glisson::contact {
namespace {

double length_of(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

[[noreturn]] void refuse(const RigidBody& body, const std::string& problem) {
  throw Error(ErrorKind::input, "The rigid body '" + body.name + "' " + problem);
}
void demand_positive(const RigidBody& body, double value, const char* what) {
  if (!(value > 0) || !std::isfinite(value))
    refuse(body, std::string("has the ") + what + " " + std::to_string(value) +
                     ", so it touches nothing. Give a positive " + what + ".");
}

}  // namespace

RigidMotion::RigidMotion(const RigidBody& body) : body_(body) {
  if (body.shape == RigidShape::plate) {
    const Vec3<double> ab = body.corners[1] - body.corners[0], ac = body.corners[2] - body.corners[0];
    const double area = length_of(cross(ab, ac));
    if (!(area > 1e-9 * length_of(ab) * length_of(ac)) || !std::isfinite(area))
      refuse(body,
             "is a plate whose corners lie on one line, so it has no front. Give three corners of a "
             "parallelogram.");
    return;
  }
  demand_positive(body, body.radius, "radius");
  demand_positive(body, body.length, "length");
  const double axis_length = length_of(body.axis);
  demand_positive(body, axis_length, "axis length");
  body_.axis = (1 / axis_length) * body.axis;
  const Vec3<double>& a = body_.axis;
  const Vec3<double> least = std::abs(a.x) < 0.6 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
  const Vec3<double> side = cross(a, least);
  side_ = (1 / length_of(side)) * side;
}

Plate<double> RigidMotion::plate() const {
  const Vec3<double> ab = body_.corners[1] - body_.corners[0], ac = body_.corners[2] - body_.corners[0];
  const Vec3<double> normal = cross(ab, ac);
  return {(1 / length_of(normal)) * normal,      ab, ac, dot(ab, ab), dot(ac, ac),
          std::max(length_of(ab), length_of(ac))};
}

std::vector<int> candidate_nodes(const std::vector<int>& listed, const Mesh& mesh) {
  return listed.empty() ? outer_nodes(mesh) : listed;
}

}  // namespace glisson::contact
