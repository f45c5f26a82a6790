#include <glisson/viz/model_shapes.hpp>

#include <cmath>
#include <set>
#include <tuple>

#include <glisson/contact/analytic/rigid_motion.hpp>
#include <glisson/contact/surface/surface_data.hpp>
#include <glisson/core/mesh/surface.hpp>

namespace glisson::viz {
namespace {

constexpr int sides = 64, rings = 12;
const double pi = std::acos(-1.0);

Body plate(const RigidBody& b, const Vec3<double>& shift) {
  const auto& c = b.corners;
  Body body{b.name, {}, {{0, 1, 2}, {0, 2, 3}}};
  for (const auto& x : {c[0], c[1], c[1] + c[2] - c[0], c[2]}) body.X.push_back(x + shift);
  return body;
}

/// Places along the axis and radii from start to end: a rim that shows the open end from the front, the tube,
/// and a rim or the half sphere of a probe.
std::vector<std::array<double, 2>> outline(RigidShape shape, double length, double radius) {
  const double rim = 0.94 * radius;
  std::vector<std::array<double, 2>> points{{0, rim}, {0, radius}, {length, radius}};
  if (shape != RigidShape::probe) points.push_back({length, rim});
  for (int ring = 1; ring <= rings && shape == RigidShape::probe; ++ring) {
    const double tilt = 0.5 * pi * ring / rings;
    points.push_back({length + radius * std::sin(tilt), radius * std::cos(tilt)});
  }
  return points;
}

Body tube(const contact::RigidMotion& motion, double time) {
  const auto cylinder = motion.cylinder(time);
  const Vec3<double> start = motion.reference() + motion.shift(time),
                     third = cross(cylinder.axis, cylinder.side);
  Body body{motion.body().name, {}, {}};
  const auto points = outline(motion.body().shape, cylinder.length, cylinder.radius);
  for (const auto& [along, radius] : points)
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * pi * k / sides;
      body.X.push_back(start + along * cylinder.axis +
                       radius * (std::cos(angle) * cylinder.side + std::sin(angle) * third));
    }
  for (int ring = 0; ring + 1 < static_cast<int>(points.size()); ++ring)
    for (int k = 0; k < sides; ++k) {
      const int a = ring * sides + k, b = ring * sides + (k + 1) % sides;
      body.triangles.push_back({a, b, b + sides});
      body.triangles.push_back({a, b + sides, a + sides});
    }
  return body;
}

Body placed(const RigidSurface& surface, double time) {
  const contact::SurfacePose pose = contact::pose_at(surface, time);
  Body body{surface.name, {}, {}};
  for (const auto& X : surface.surface.X)
    body.X.push_back(contact::times(pose.turn, X - surface.centre) + pose.shift + surface.centre);
  for (const Facet& facet : surface.surface.facets) {
    const auto& n = facet.nodes;
    body.triangles.push_back({n[0], n[1], n[2]});
    if (facet.node_count() == 4) body.triangles.push_back({n[0], n[2], n[3]});
  }
  return body;
}

Vec3<double> unit(const Vec3<double>& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? (1 / length) * v : Vec3<double>{};
}

class Marks {
 public:
  Marks(std::span<const Vec3<double>> x, double spacing) : x_(x), spacing_(spacing) {}

  void at(MarkKind kind, const Vec3<double>& p, const Vec3<double>& direction) {
    const auto cell = [&](double v) { return static_cast<long>(std::floor(v / spacing_)); };
    if (taken_.insert({static_cast<int>(kind), cell(p.x), cell(p.y), cell(p.z)}).second)
      list.push_back({kind, p, unit(direction)});
  }
  void on_nodes(MarkKind kind, const std::vector<int>& nodes, const Vec3<double>& direction) {
    for (const int node : nodes) at(kind, x_[static_cast<std::size_t>(node)], direction);
  }
  /// A value per node, or one for all, on the axes of the mask.
  void along_axes(MarkKind kind, const std::vector<int>& nodes, Axes axes,
                  const std::vector<double>& values) {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const double v = values.empty() ? 0 : values[values.size() == nodes.size() ? n : 0];
      const auto part = [&](unsigned axis) { return axes & axis ? v : 0.0; };
      at(kind, x_[static_cast<std::size_t>(nodes[n])], {part(1), part(2), part(4)});
    }
  }

  std::vector<Mark> list;

 private:
  std::span<const Vec3<double>> x_;
  double spacing_;
  std::set<std::tuple<int, long, long, long>> taken_;
};

}  // namespace

std::vector<Body> bodies_at(const Model& model, double time) {
  std::vector<Body> bodies;
  for (const auto& b : model.bodies) {
    const contact::RigidMotion motion(b);
    bodies.push_back(b.shape == RigidShape::plate ? plate(b, motion.shift(time)) : tube(motion, time));
  }
  for (const RigidSurface& surface : model.surfaces) bodies.push_back(placed(surface, time));
  return bodies;
}

const char* name_of(MarkKind kind) {
  static constexpr const char* names[] = {"fixed", "prescribed", "force", "pressure", "sliding"};
  return names[static_cast<int>(kind)];
}

std::vector<Mark> marks_of(const Model& model, std::span<const Vec3<double>> x, double spacing) {
  Marks marks(x, spacing);
  for (const auto& f : model.fixed) marks.on_nodes(MarkKind::fixed, f.nodes, {});
  for (const auto& d : model.displacements) marks.along_axes(MarkKind::prescribed, d.nodes, d.axes, d.values);
  for (const auto& f : model.forces) marks.along_axes(MarkKind::force, f.nodes, f.axes, f.values);
  for (const auto& p : model.pressures)
    for (const auto& facet : p.facets)
      marks.at(MarkKind::pressure, facet_centre(facet, x), -p.magnitude * facet_normal(facet, x));
  for (const auto& t : model.tractions)
    for (std::size_t k = 0; k < t.facets.size(); ++k)
      marks.at(MarkKind::force, facet_centre(t.facets[k], x), t.values[t.values.size() == 1 ? 0 : k]);
  for (const auto& s : model.springs)
    for (std::size_t k = 0; k < s.nodes.size(); ++k) {
      const auto& target = s.targets[s.targets.size() == 1 ? 0 : k];
      if (dot(target, target) > 0) marks.at(MarkKind::force, x[static_cast<std::size_t>(s.nodes[k])], target);
    }
  for (const auto& plane : model.planes) marks.on_nodes(MarkKind::sliding, plane.nodes, plane.normal);
  return marks.list;
}

}  // namespace glisson::viz
