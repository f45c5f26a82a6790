#include <glisson/contact/surface/surface_overlap.hpp>

#include <algorithm>
#include <limits>
#include <string>

#include <glisson/contact/shortest_edge.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double outside(double low, double p, double high) { return std::max({low - p, p - high, 0.0}); }

double distance_squared(const SurfaceNode<double>& box, const Vec3<double>& p) {
  const Vec3<double> d{outside(box.low.x, p.x, box.high.x), outside(box.low.y, p.y, box.high.y),
                       outside(box.low.z, p.z, box.high.z)};
  return dot(d, d);
}

/// The closest facet to points of which each is near the last one: its facet is the first guess.
class ClosestFacet {
 public:
  explicit ClosestFacet(const SurfaceData& data) : data_(data) {}

  int operator()(const Vec3<double>& p) {
    double nearest = distance_squared(closest_, p);
    for (int n = 0; n < static_cast<int>(data_.nodes.size());) {
      const SurfaceNode<double>& node = data_.nodes[at(n)];
      if (contact::distance_squared(node, p) > nearest) {
        n = node.skip;
        continue;
      }
      ++n;
      if (node.facet < 0) continue;
      if (const double d = distance_squared(node.facet, p); d < nearest) {
        nearest = d;
        closest_ = node.facet;
      }
    }
    return closest_;
  }

 private:
  double distance_squared(int facet, const Vec3<double>& p) const {
    const auto& x = data_.facets[at(facet)].smooth.x;
    return closest_on_triangle(p, x[0], x[1], x[2]).distance_squared;
  }

  const SurfaceData& data_;
  int closest_ = 0;
};

struct DeepNode {
  int node = -1;
  double depth = 0;
  void add(int n, double d) {
    if (d > depth) *this = {n, d};
  }
};

/// What lies behind a surface at the start.
struct StartSides {
  std::vector<double> depth;  ///< with half of the thickness [m]  [node_count of the mesh]
  DeepNode refused, any;
  DeepNode near;  ///< in front, but nearer than half a thickness; by how much
  bool some_in_front = false;
};

StartSides start_sides(const RigidSurface& surface, const SurfaceData& data, const std::vector<int>& nodes,
                       const std::vector<double>& half_thickness, const Mesh& mesh) {
  const SurfacePose pose = pose_about(data.centre, surface, 0);
  const SurfaceShape<double> shape = data.shape();
  ClosestFacet closest(data);
  StartSides sides;
  sides.depth.resize(mesh.X.size());
  for (const int n : nodes) {
    const Vec3<double> q = transposed_times(pose.turn, mesh.X[at(n)] - data.centre - pose.shift);
    const int facet = closest(q);
    const auto& triangle = data.facets[at(facet)].smooth;
    const double depth = shape.behind_facet(data.facets[at(facet)], q).depth;
    sides.any.add(n, depth);
    const double half = half_thickness[at(n)];
    sides.depth[at(n)] = half > 0 ? shape.behind_facet(data.facets[at(facet)], q, half).depth : depth;
    if (half > 0 && !(depth > 0)) sides.near.add(n, sides.depth[at(n)]);
    if (data.closed[at(facet)] || depth < 4 * data.reach) sides.refused.add(n, depth);
    if (!(depth > 0) && dot(q - triangle.x[0], triangle.facet_normal()) >= 0) sides.some_in_front = true;
  }
  return sides;
}

}  // namespace

std::vector<double> start_depths(const RigidSurface& surface, const SurfaceData& data,
                                 const std::vector<int>& nodes, const std::vector<double>& half_thickness,
                                 const Mesh& mesh) {
  if (data.facets.empty()) return std::vector<double>(mesh.X.size());
  StartSides sides = start_sides(surface, data, nodes, half_thickness, mesh);
  const double most = 0.01 * data.reach;
  // the facets of a floor may be far larger than what stands on it
  const auto deep = [&](const DeepNode& its) {
    return its.node >= 0 && its.depth > std::min(most, 0.1 * shortest_edge_around(mesh, its.node));
  };
  const auto refuse = [&](const DeepNode& its, const std::string& more) {
    throw Error(ErrorKind::input,
                "node " + std::to_string(its.node) + " starts " + number_text(its.depth) + more,
                {"", 0, surface.name});
  };
  if (!sides.some_in_front && deep(sides.any))
    refuse(
        sides.any,
        " behind the surface, and no node starts in front of it. Its facets' normals (right-hand rule) point "
        "to the side that nodes stay on: list the nodes of its facets backwards, or move it");
  if (deep(sides.refused))
    refuse(
        sides.refused,
        " behind the surface, too deep to be let out at the start of the run. Move the surface or the body "
        "apart");
  if (sides.near.depth > most)
    refuse(sides.near,
           " too near to the surface to be let out at the start of the run: it is a node of a shell, which "
           "stays half of the thickness in front of it. Move the surface or the shell apart");
  for (double& depth : sides.depth)
    if (depth > most) depth = 0;  // far below an open surface, where nothing holds it
  return std::move(sides.depth);
}

}  // namespace glisson::contact
