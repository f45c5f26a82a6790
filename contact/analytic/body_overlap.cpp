#include <glisson/contact/analytic/body_overlap.hpp>

#include <algorithm>
#include <string>

#include <glisson/contact/shortest_edge.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>

namespace glisson::contact {
namespace {

const Vec3<double>& at(const Mesh& mesh, int n) { return mesh.X[static_cast<std::size_t>(n)]; }

/// Where a node starts, as shapes want it.
Vec3<double> from_reference(const RigidMotion& motion, int n, const Mesh& mesh) {
  return at(mesh, n) - motion.reference() - motion.shift(0);
}

template <class Shape>
Shape shape_of(const RigidMotion& motion) {
  Shape shape;
  shape_at(motion, 0, shape);
  return shape;
}

void refuse_deep(const RigidMotion& motion, int worst, double deepest, const Mesh& mesh) {
  if (!(deepest > 0.1 * shortest_edge_around(mesh, worst))) return;
  const bool plate = motion.body().shape == RigidShape::plate;
  throw Error(ErrorKind::input,
              "node " + std::to_string(worst) + " starts " + number_text(deepest) +
                  (plate ? " behind it" : " inside of it") +
                  ", too deep to be let out at the start of the run. Move one of " +
                  (plate ? "them; if the elements are on its wrong side, exchange b and c" : "them"),
              {"", 0, motion.body().name});
}

/// use(shape at the start)
template <class Use>
void with_shape(const RigidMotion& motion, const Use& use) {
  switch (motion.body().shape) {
    case RigidShape::plate:
      return use(shape_of<Plate<double>>(motion));
    case RigidShape::cylinder:
      return use(shape_of<Cylinder<double>>(motion));
    case RigidShape::probe:
      return use(shape_of<Probe<double>>(motion));
  }
}

}  // namespace

std::vector<double> start_depths(const RigidMotion& motion, const std::vector<int>& nodes, const Mesh& mesh) {
  std::vector<double> depth(mesh.X.size());
  int worst = -1;
  with_shape(motion, [&](const auto& shape) {
    for (const int n : nodes) {
      double& its = depth[static_cast<std::size_t>(n)];
      its = std::max(0.0, shape(from_reference(motion, n, mesh)).depth);
      if (its > (worst < 0 ? 0 : depth[static_cast<std::size_t>(worst)])) worst = n;
    }
  });
  if (worst >= 0) refuse_deep(motion, worst, depth[static_cast<std::size_t>(worst)], mesh);
  return depth;
}

std::vector<double> gaps_to_keep(const RigidMotion& motion, const std::vector<int>& nodes,
                                 const std::vector<double>& half_thickness, const Mesh& mesh) {
  std::vector<double> gaps = half_thickness;
  with_shape(motion, [&](const auto& shape) {
    for (const int n : nodes) {
      double& gap = gaps[static_cast<std::size_t>(n)];
      gap = std::max(0.0, gap - shape(from_reference(motion, n, mesh), gap).depth);
    }
  });
  return gaps;
}

}  // namespace glisson::contact
