#include <glisson/contact/analytic/body_overlap.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>

namespace glisson::contact {
namespace {

const Vec3<double>& at(const Mesh& mesh, int n) { return mesh.X[static_cast<std::size_t>(n)]; }

/// Of the elements and triangles that have the node; infinite without any.
double shortest_edge_around(const Mesh& mesh, int node) {
  double shortest = std::numeric_limits<double>::infinity();
  const auto take = [&](const auto& nodes) {
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) return;
    for (const int n : nodes) {
      const auto d = at(mesh, n) - at(mesh, node);
      if (n != node) shortest = std::min(shortest, std::sqrt(dot(d, d)));
    }
  };
  for (int e = 0; e < mesh.element_count(); ++e) take(mesh.element(e));
  for (const auto& triangle : mesh.triangles) take(triangle);
  return shortest;
}

struct DeepNode {
  int node = -1;
  double depth = 0;
  void add(int n, double d) {
    if (d > depth) *this = {n, d};
  }
};

void refuse_deep(const RigidMotion& motion, const DeepNode& its, const Mesh& mesh, const std::string& where,
                 const std::string& advice) {
  if (its.node < 0 || !(its.depth > 0.1 * shortest_edge_around(mesh, its.node))) return;
  throw Error(ErrorKind::input,
              "node " + std::to_string(its.node) + " starts " + number_text(its.depth) + where +
                  ", so the first step would throw it out. Move one of them" + advice,
              {"", 0, motion.body().name});
}

template <class Shape>
void refuse_in(const Shape& shape, const RigidMotion& motion, const std::vector<int>& nodes,
               const std::vector<double>& half_thickness, const Mesh& mesh) {
  DeepNode inside, near;
  for (const int n : nodes) {
    const auto p = at(mesh, n) - motion.reference() - motion.shift(0);
    inside.add(n, shape(p).depth);
    near.add(n, shape(p, half_thickness[static_cast<std::size_t>(n)]).depth);
  }
  const bool plate = motion.body().shape == RigidShape::plate;
  refuse_deep(motion, inside, mesh, plate ? " behind it" : " inside of it",
              plate ? "; if the elements are on its wrong side, exchange b and c" : "");
  refuse_deep(motion, near, mesh,
              " too near to it: it is a node of a shell, which stays half of the thickness in front of it",
              "");
}

template <class Shape>
Shape shape_of(const RigidMotion& motion) {
  Shape shape;
  shape_at(motion, 0, shape);
  return shape;
}

}  // namespace

void refuse_overlap(const RigidMotion& motion, const std::vector<int>& nodes,
                    const std::vector<double>& half_thickness, const Mesh& mesh) {
  switch (motion.body().shape) {
    case RigidShape::plate:
      return refuse_in(shape_of<Plate<double>>(motion), motion, nodes, half_thickness, mesh);
    case RigidShape::cylinder:
      return refuse_in(shape_of<Cylinder<double>>(motion), motion, nodes, half_thickness, mesh);
    case RigidShape::probe:
      return refuse_in(shape_of<Probe<double>>(motion), motion, nodes, half_thickness, mesh);
  }
}

}  // namespace glisson::contact
