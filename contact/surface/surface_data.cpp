#include <glisson/contact/surface/surface_data.hpp>

#include <cmath>

#include <glisson/contact/bvh/hierarchy.hpp>
#include <glisson/core/mesh/triangles.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Appends the subtree of node n in depth-first order; a stack of {node, place to note its end or -1}.
void append_tree(const Hierarchy& h, std::vector<SurfaceNode<double>>& nodes) {
  struct Open {
    int node, placed;
  };
  std::vector<Open> stack;
  if (h.node_count() > 0) stack.push_back({0, -1});
  while (!stack.empty()) {
    const Open open = stack.back();
    stack.pop_back();
    const int next = static_cast<int>(nodes.size());
    if (open.placed >= 0) {
      nodes[at(open.placed)].skip = next;
      continue;
    }
    const Box& box = h.box[at(open.node)];
    nodes.push_back({box.low, box.high, next + 1, h.nodes[at(open.node)].triangle});
    stack.push_back({open.node, next});
    const auto& child = h.nodes[at(open.node)].child;
    for (int k = 3; k >= 0; --k)
      if (child[at(k)] >= 0) stack.push_back({child[at(k)], -1});
  }
}

std::vector<SurfaceFacet<double>> facets_of(const std::vector<Triangle>& triangles,
                                            const std::vector<Vec3<double>>& x) {
  const auto neighbours = neighbours_of(triangles);
  const auto normals = vertex_normals(triangles, x);
  std::vector<SurfaceFacet<double>> facets(triangles.size());
  std::vector<bool> border(x.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      facets[t].smooth.x[k] = x[at(triangles[t][k])];
      facets[t].smooth.n[k] = normals[at(triangles[t][k])];
      if (neighbours[t][k] < 0) border[at(triangles[t][k])] = border[at(triangles[t][(k + 1) % 3])] = true;
    }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vec3<double> own = facets[t].smooth.facet_normal();
    for (std::size_t k = 0; k < 3; ++k) {
      const int other = neighbours[t][(k + 1) % 3];  // edge k + 1 starts after corner k
      facets[t].border_edge[k] = other < 0;
      facets[t].border_corner[k] = border[at(triangles[t][k])];
      facets[t].edge_normal[k] =
          other < 0 ? own : unit_or(own + facets[at(other)].smooth.facet_normal(), own);
    }
  }
  return facets;
}

/// Whether no edge of what a triangle hangs together with over edges is a border.
std::vector<bool> closed_parts(const std::vector<Triangle>& triangles) {
  std::vector<bool> closed(triangles.size());
  for (const SurfacePart& part : connected_parts(triangles))
    for (const std::size_t t : part.triangles) closed[t] = part.closed;
  return closed;
}

}  // namespace

SurfaceData surface_data(const SurfaceMesh& surface, const Vec3<double>& centre) {
  std::vector<Vec3<double>> x;
  for (const auto& X : surface.X) x.push_back(X - centre);
  auto triangles = split_facets(surface.facets, x);
  part_vertices(triangles, x);
  SurfaceData data;
  data.centre = centre;
  data.closed = closed_parts(triangles);
  data.facets = facets_of(triangles, x);
  data.reach = triangle_sizes(triangles, x).largest;
  HierarchySettings settings;
  settings.margin = 1e-3 * data.reach;  // covers the rounding of float
  append_tree(build_hierarchy(triangles, x, settings), data.nodes);
  return data;
}

SurfacePose pose_at(const RigidSurface& surface, double t) {
  if (!surface.poses.empty()) {
    const RigidPose pose = pose_in(surface.poses, t);
    return {matrix_of(pose.turn), pose.shift};
  }
  const double amplitude = surface.motion(t);
  const Vec3<double> a = amplitude * surface.angles;
  const double ca = std::cos(a.x), sa = std::sin(a.x), cb = std::cos(a.y), sb = std::sin(a.y);
  const double cc = std::cos(a.z), sc = std::sin(a.z);
  return {{{{cb * cc, -cb * sc, sb},
            {sa * sb * cc + ca * sc, ca * cc - sa * sb * sc, -sa * cb},
            {sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb}}},
          amplitude * surface.displacement};
}

SurfacePose pose_about(const Vec3<double>& centre, const RigidSurface& surface, double t) {
  SurfacePose pose = pose_at(surface, t);
  const Vec3<double> arm = centre - surface.centre;
  pose.shift = pose.shift + times(pose.turn, arm) - arm;
  return pose;
}

}  // namespace glisson::contact
