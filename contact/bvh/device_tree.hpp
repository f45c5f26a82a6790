// The hierarchy in a backend's memory: refitted level by level (Johnsen 2016, algorithms 5.4 and 5.5), and
// searched by one loop body per triangle without a stack. Nodes are numbered in preorder, so that the subtree
// of node n is n ... skip[n] - 1. Plain data and loop bodies.
#pragma once

#include <glisson/contact/bvh/fit_node.hpp>

namespace glisson::contact {

struct TreeView {
  const int* skip;                 ///< first node behind the subtree                        [node_count]
  const int* parent;               ///< -1: root                                             [node_count]
  const int* triangle;             ///< of a leaf, -1 elsewhere                              [node_count]
  const int* connected;            ///< 0: its triangles do not hang together                [node_count]
  const int* region;               ///< of all triangles below, -1: several                  [node_count]
  const int* leaf;                 ///< node of a triangle                                   [triangle_count]
  const int* corners;              ///< points                                            [triangle_count][3]
  const unsigned char* may_touch;  ///< whether two regions may, or one with itself [region][region_count]
  Box* box;                        ///< with the margin [m]                                  [node_count]
  NormalCone* cone;                ///< [node_count]
  int* behind;                     ///< of a triangle, see FindClosed                        [triangle_count]
  int node_count, triangle_count, region_count;

  GLISSON_HD bool regions_touch(int a, int b) const {
    const int i = region[a], j = region[b];
    return i < 0 || j < 0 || may_touch[i * region_count + j];
  }
};

/// One level: of leaves from x, of other nodes from their children.
struct RefitLevel {
  TreeView tree;
  const int* nodes;       ///< of the level
  const Vec3<double>* x;  ///< [m]  [point_count]
  double margin;          ///< [m]
  ConeRule rule;
  bool cones;  ///< false: they stay

  GLISSON_HD void operator()(int i) const {
    const int n = nodes[i];
    if (tree.triangle[n] < 0) return fit_inner(*this, n, cones);
    const int* c = tree.corners + 3 * tree.triangle[n];
    fit_leaf(*this, n, x[c[0]], x[c[1]], x[c[2]], cones);
  }

  /// As fit_node.hpp wants it.
  GLISSON_HD bool connected(int n) const { return tree.connected[n] != 0; }
  GLISSON_HD Box& box(int n) const { return tree.box[n]; }
  GLISSON_HD NormalCone& cone(int n) const { return tree.cone[n]; }
  template <class Use>
  GLISSON_HD void for_each_child(int n, const Use& use) const {
    for (int child = n + 1; child < tree.skip[n]; child = tree.skip[child]) use(child);
  }
};

/// Of each triangle the largest subtree with it that cannot touch itself, because its normals open by less
/// than the threshold; nodes above it open by more. `behind` is the first node behind that subtree.
struct FindClosed {
  TreeView tree;
  double threshold;  ///< [rad]
  bool cones;        ///< false: only the triangle itself

  GLISSON_HD void operator()(int t) const {
    int closed = tree.leaf[t];
    for (int n = tree.parent[closed]; cones && n >= 0; n = tree.parent[n])
      if (tree.cone[n].angle < threshold) closed = n;
    tree.behind[t] = tree.skip[closed];
  }
};

/// Of each triangle those behind it in preorder whose boxes overlap its own: each pair once, with nothing of
/// the subtree that cannot touch itself. First they are counted, then, with `found`, listed.
struct FindPairs {
  static constexpr int cost = 100;
  TreeView tree;
  int* counts;       ///< [triangle_count]; not written when listing
  const int* begin;  ///< first place in `found` [triangle_count]; when listing
  int* found;        ///< the other triangles, or nullptr to count

  GLISSON_HD void operator()(int t) const {
    const int own = tree.leaf[t];
    const Box box = tree.box[own];
    int count = 0;
    for (int n = tree.behind[t]; n < tree.node_count;) {
      if (!tree.regions_touch(own, n) || !overlap(box, tree.box[n])) {
        n = tree.skip[n];
        continue;
      }
      if (tree.triangle[n] >= 0) {
        if (found) found[begin[t] + count] = tree.triangle[n];
        ++count;
      }
      ++n;
    }
    if (!found) counts[t] = count;
  }
};

}  // namespace glisson::contact
