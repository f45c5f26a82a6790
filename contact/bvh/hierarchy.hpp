// A bounding volume hierarchy over the triangles of a surface. Its topology is fixed when it is built: in a
// total Lagrangian mesh neighbours stay neighbours, and a step only refits the boxes and cones.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glisson/contact/bvh/box.hpp>
#include <glisson/contact/bvh/normal_cone.hpp>
#include <glisson/contact/geometry/triangles.hpp>

namespace glisson::contact {

struct HierarchySettings {
  int arity = 4;      ///< 2 or 4 children
  double margin = 0;  ///< added to all sides of a leaf's box [m]
  ConeRule cones = ConeRule::narrowest;
  double angle_weight = 0.6366197723675814;  ///< c of Johnsen 2016, eq. 5.7: 2 / pi [1/rad]
};

struct Hierarchy {
  struct Node {
    int parent = -1;
    int triangle = -1;                         ///< of a leaf; -1 elsewhere
    std::array<int, 4> child{-1, -1, -1, -1};  ///< filled from the front
    bool connected = true;                     ///< its triangles hang together over edges
  };
  HierarchySettings settings;
  std::vector<Node> nodes;       ///< [node_count], root first; empty without triangles
  std::vector<Box> box;          ///< [node_count], with the margin
  std::vector<NormalCone> cone;  ///< [node_count]
  /// Nodes by level: leaves first, then each level's children lie in levels before it (algorithm 5.5).
  std::vector<int> by_level;     ///< [node_count]
  std::vector<int> level_begin;  ///< [level_count + 1], into by_level

  int node_count() const { return static_cast<int>(nodes.size()); }
  int level_count() const { return static_cast<int>(level_begin.size()) - 1; }
  bool is_leaf(int n) const { return nodes[static_cast<std::size_t>(n)].triangle >= 0; }
};

/// Patches that hang together over edges are divided from the top so that both halves stay connected and
/// V (1 + c alpha) stays small (Johnsen 2016, eq. 5.7); boxes of the patches are united from the bottom.
/// Boxes and cones fit x when it returns. Throws Error(usage) for another arity.
Hierarchy build_hierarchy(std::span<const Triangle> triangles, std::span<const Vec3<double>> x,
                          const HierarchySettings& settings);

/// Refits every box and cone, level by level (algorithm 5.4).
void refit(Hierarchy& hierarchy, std::span<const Triangle> triangles, std::span<const Vec3<double>> x);

/// Refits one node; of an interior node from its children.
void refit_node(Hierarchy& hierarchy, int n, std::span<const Triangle> triangles,
                std::span<const Vec3<double>> x);
/// The same, but its cone stays.
void refit_box(Hierarchy& hierarchy, int n, std::span<const Triangle> triangles,
               std::span<const Vec3<double>> x);

}  // namespace glisson::contact
