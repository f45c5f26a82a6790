#include <glisson/contact/bvh/update_nodes.hpp>

#include <algorithm>
#include <cmath>

#include <glisson/core/mesh/triangles.hpp>

namespace glisson::contact {
namespace {

using Nodes = std::span<const Vec3<double>>;
std::size_t at(int i) { return static_cast<std::size_t>(i); }
double length_of(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

/// Nodes of the subtree, parents first.
std::vector<int> nodes_below(const Hierarchy& h, int root) {
  std::vector<int> nodes{root};
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const int c : h.nodes[at(nodes[i])].child)
      if (c >= 0) nodes.push_back(c);
  return nodes;
}

std::vector<int> vertices_of(const Hierarchy& h, const std::vector<int>& nodes,
                             std::span<const Triangle> triangles) {
  std::vector<int> vertices;
  for (const int n : nodes)
    if (h.is_leaf(n)) {
      const Triangle& t = triangles[at(h.nodes[at(n)].triangle)];
      vertices.insert(vertices.end(), t.begin(), t.end());
    }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Translation of the centroid and the largest motion that it leaves.
struct Motion {
  Vec3<double> shift;
  double rest = 0;
};
Motion motion_of(const std::vector<int>& vertices, const std::vector<Vec3<double>>& reference, Nodes x) {
  Motion motion;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    motion.shift = motion.shift + (x[at(vertices[i])] - reference[i]);
  motion.shift = (1.0 / double(vertices.size())) * motion.shift;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    motion.rest = std::max(motion.rest, length_of(x[at(vertices[i])] - reference[i] - motion.shift));
  return motion;
}

}  // namespace

UpdateNodes::UpdateNodes(const Hierarchy& h, std::span<const Triangle> triangles, Nodes x,
                         const UpdateSettings& settings)
    : settings_(settings) {
  std::vector<int> open;
  if (h.node_count() > 0) open.push_back(0);
  while (!open.empty()) {
    const int n = open.back();
    open.pop_back();
    if (!h.is_leaf(n) && h.cone[at(n)].angle > settings.threshold / 2) {
      above_.push_back(n);
      for (const int c : h.nodes[at(n)].child)
        if (c >= 0) open.push_back(c);
      continue;
    }
    Subtree subtree;
    subtree.root = n;
    subtree.nodes = nodes_below(h, n);
    std::reverse(subtree.nodes.begin(), subtree.nodes.end());
    subtree.vertices = vertices_of(h, subtree.nodes, triangles);
    set_reference(subtree, h, triangles, x);
    subtrees_.push_back(std::move(subtree));
  }
  std::reverse(above_.begin(), above_.end());  // parents were met before their children
}

/// Eq. 5.9 with the sine instead of the tangent: a facet whose corners move by u in any direction, not only
/// along its normal, turns by at most arcsin(2 u / h), h its smallest height.
void UpdateNodes::set_reference(Subtree& subtree, const Hierarchy& h, std::span<const Triangle> triangles,
                                Nodes x) const {
  subtree.reference.clear();
  for (const int v : subtree.vertices) subtree.reference.push_back(x[at(v)]);
  std::vector<Triangle> its;
  for (const int n : subtree.nodes)
    if (h.is_leaf(n)) its.push_back(triangles[at(h.nodes[at(n)].triangle)]);
  const double room = (settings_.threshold - h.cone[at(subtree.root)].angle) / 2;
  subtree.largest_deformation =
      room > 0 ? triangle_sizes(its, x).smallest / 2 * std::sin(std::min(room, full_turn / 4)) : 0;
}

void UpdateNodes::update_one(Subtree& subtree, Hierarchy& h, std::span<const Triangle> triangles, Nodes x,
                             UpdateCounts& counts) const {
  const Motion motion = motion_of(subtree.vertices, subtree.reference, x);
  const double allowed = h.settings.margin - settings_.reserve;
  const bool may_touch_itself = h.cone[at(subtree.root)].angle >= settings_.threshold;
  const bool stiff = !may_touch_itself && motion.rest < subtree.largest_deformation && motion.rest < allowed;
  if (stiff && motion.rest + length_of(motion.shift) < allowed) {
    ++counts.inactive;
  } else if (stiff) {
    for (const int n : subtree.nodes)
      h.box[at(n)] = {h.box[at(n)].low + motion.shift, h.box[at(n)].high + motion.shift};
    for (auto& p : subtree.reference) p = p + motion.shift;
    ++counts.translated;
    counts.volumes_translated += static_cast<std::int64_t>(subtree.nodes.size());
  } else {
    for (const int n : subtree.nodes) refit_node(h, n, triangles, x);
    set_reference(subtree, h, triangles, x);
    ++counts.refitted;
    counts.volumes_refitted += static_cast<std::int64_t>(subtree.nodes.size());
  }
}

UpdateCounts UpdateNodes::update(Hierarchy& hierarchy, std::span<const Triangle> triangles, Nodes x) {
  UpdateCounts counts;
  for (Subtree& subtree : subtrees_) update_one(subtree, hierarchy, triangles, x, counts);
  for (const int n : above_) refit_node(hierarchy, n, triangles, x);
  counts.volumes_refitted += static_cast<std::int64_t>(above_.size());
  return counts;
}

}  // namespace glisson::contact
