// Selective refitting: subtrees whose triangles moved little, or moved as one, are left alone or shifted
// (Johnsen 2016, section 5.3.4.3 and algorithm 5.2).
#pragma once

#include <cstdint>

#include <glisson/contact/bvh/hierarchy.hpp>

namespace glisson::contact {

struct UpdateSettings {
  double threshold = 0.95 * full_turn / 2;  ///< opening of a cone from which a patch may touch itself [rad]
  double reserve = 0;  ///< part of the hierarchy's margin that motion must leave: at least this stays [m]
};

/// What an update did.
struct UpdateCounts {
  int inactive = 0, translated = 0, refitted = 0;  ///< update nodes
  std::int64_t volumes_refitted = 0;  ///< boxes fitted anew, those above the update nodes included
  std::int64_t volumes_translated = 0;
};

/// Boxes are axis-aligned, so a rotated subtree is refitted: the algorithm's third case, which turns boxes by
/// Procrustes analysis, needs oriented ones.
class UpdateNodes {
 public:
  /// The hierarchy must fit x. Update nodes are the highest nodes whose cone opens by at most half of the
  /// threshold: the greedy search of the seed ends there, because no cone is narrower than its children's.
  UpdateNodes(const Hierarchy& hierarchy, std::span<const Triangle> triangles,
              std::span<const Vec3<double>> x, const UpdateSettings& settings);

  /// Afterwards every leaf's box holds its triangle at x with `reserve` around it, and a node whose cone
  /// opens by less than the threshold has triangles whose normals do.
  UpdateCounts update(Hierarchy& hierarchy, std::span<const Triangle> triangles,
                      std::span<const Vec3<double>> x);
  int count() const { return static_cast<int>(subtrees_.size()); }

 private:
  struct Subtree {
    int root = 0;
    std::vector<int> nodes;               ///< of the hierarchy, children first
    std::vector<int> vertices;            ///< each once, sorted
    std::vector<Vec3<double>> reference;  ///< where the boxes were fitted [m]  [vertices]
    double largest_deformation = 0;       ///< that keeps the cones below the threshold [m]
  };
  void set_reference(Subtree& subtree, const Hierarchy& hierarchy, std::span<const Triangle> triangles,
                     std::span<const Vec3<double>> x) const;
  void update_one(Subtree& subtree, Hierarchy& hierarchy, std::span<const Triangle> triangles,
                  std::span<const Vec3<double>> x, UpdateCounts& counts) const;

  UpdateSettings settings_;
  std::vector<Subtree> subtrees_;
  std::vector<int> above_;  ///< nodes above the subtrees, children first
};

}  // namespace glisson::contact
