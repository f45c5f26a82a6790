#include <glisson/core/constraints/constraint_list.hpp>

#include <cmath>
#include <map>
#include <tuple>

#include <glisson/core/base/error.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson {
namespace {

struct NodeConstraints {
  unsigned axes = 0;
  std::vector<PrescribedValue> values;
  std::vector<Vec3<double>> normals;
};
using ByNode = std::map<int, NodeConstraints>;

class CurveIndex {
 public:
  explicit CurveIndex(std::vector<LoadCurve>& curves) : curves_(curves) {}
  int of(const LoadCurve& c) {
    const auto [place, is_new] = index_.try_emplace({c.shape, c.start, c.end, c.release_after_end, c.table},
                                                    static_cast<int>(curves_.size()));
    if (is_new) curves_.push_back(c);
    return place->second;
  }

 private:
  using Key = std::tuple<LoadShape, double, double, bool, std::vector<std::pair<double, double>>>;
  std::vector<LoadCurve>& curves_;
  std::map<Key, int> index_;
};

Vec3<double> unit_normal(const Vec3<double>& normal) {
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0) || !std::isfinite(length))
    throw Error(ErrorKind::input, "The normal of a sliding plane has the length " + std::to_string(length) +
                                      ", so it has no direction. Give three numbers that are not all zero.");
  return (1 / length) * normal;
}

/// Gram-Schmidt against the constrained axes and the planes before; see PlaneProjection.
std::vector<PlaneProjection> projections(const NodeConstraints& node) {
  constexpr double parallel = 1e-6;  // sine below which a normal counts as already constrained
  std::vector<PlaneProjection> result;
  std::vector<Vec3<double>> units;
  for (const auto& normal : node.normals) {
    Vec3<double> d{node.axes & 1u ? 0 : normal.x, node.axes & 2u ? 0 : normal.y,
                   node.axes & 4u ? 0 : normal.z};
    for (const auto& before : units) d = d - dot(d, before) * before;
    const double length = std::sqrt(dot(d, d));
    if (length < parallel) continue;
    d = (1 / length) * d;
    for (const auto& before : units) d = d - dot(d, before) * before;
    units.push_back(d);
    result.push_back({normal, (1 / dot(normal, d)) * d});
  }
  return result;
}

ByNode collect(const Model& model, const Numbering& numbering, std::vector<LoadCurve>& curves) {
  ByNode by_node;
  const auto at = [&](int user_node) -> NodeConstraints& {
    return by_node[detail::internal_node(numbering, user_node)];
  };
  CurveIndex index(curves);
  for (const auto& fix : model.fixed)
    for (const int n : fix.nodes) at(n).axes |= fix.axes & all_axes;
  for (const auto& disp : model.displacements) {
    const int curve = index.of(disp.curve);
    for (std::size_t k = 0; k < disp.nodes.size(); ++k) {
      NodeConstraints& node = at(disp.nodes[k]);
      node.axes |= disp.axes & all_axes;
      const double value = detail::value_of(disp.values, k, disp.nodes.size(), "prescribed displacements");
      node.values.push_back({curve, disp.axes & all_axes, value});
    }
  }
  for (const auto& plane : model.planes) {
    const auto normal = unit_normal(plane.normal);
    for (const int n : plane.nodes) at(n).normals.push_back(normal);
  }
  return by_node;
}

}  // namespace

ConstraintList make_constraint_list(const Model& model, const Numbering& numbering) {
  ConstraintList list;
  list.value_begin = list.plane_begin = {0};
  for (const auto& [n, node] : collect(model, numbering, list.curves)) {
    list.nodes.push_back(n);
    list.axes.push_back(node.axes);
    list.values.insert(list.values.end(), node.values.begin(), node.values.end());
    list.value_begin.push_back(static_cast<int>(list.values.size()));
    const auto planes = projections(node);
    list.planes.insert(list.planes.end(), planes.begin(), planes.end());
    list.plane_begin.push_back(static_cast<int>(list.planes.size()));
  }
  return list;
}

std::vector<Vec3<double>> initial_velocity(const Model& model, const Numbering& numbering) {
  std::vector<Vec3<double>> v(numbering.internal_of_user.size());
  for (const auto& initial : model.initial_velocities)
    for (const int n : initial.nodes) v[std::size_t(detail::internal_node(numbering, n))] = initial.velocity;
  return v;
}

}  // namespace glisson
