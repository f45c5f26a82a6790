// What a bounding volume hierarchy costs while a surface moves: algorithm 5.2 of Johnsen 2016 (update nodes)
// beside a refit of everything, with the narrowest cones (eq. 5.4-5.6) or Provot's.
#pragma once

#include <chrono>
#include <span>

#include <glisson/contact/bvh/update_nodes.hpp>
#include <glisson/core/any_simulation.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/mesh/triangles.hpp>

namespace glisson::bench {

/// Settings of the thesis: margin of a hundredth of the sum of the smallest and the largest facet height, of
/// which motion leaves twice the distance of the gap-rate forces (section 5.3.5.2).
class HierarchyCounts {
 public:
  HierarchyCounts(const std::vector<contact::Triangle>& triangles, const std::vector<Vec3<double>>& X,
                  int arity, contact::ConeRule cones)
      : arity(arity),
        cones(cones),
        triangles_(triangles),
        hierarchy_(contact::build_hierarchy(triangles, X, settings(triangles, X, arity, cones))),
        exhaustive_(hierarchy_),
        update_(hierarchy_, triangles, X, update_settings(triangles, X)) {}

  /// Brings both hierarchies to x.
  void follow(const std::vector<Vec3<double>>& x) {
    const auto start = Clock::now();
    const contact::UpdateCounts counts = update_.update(hierarchy_, triangles_, x);
    const auto updated = Clock::now();
    contact::refit(exhaustive_, triangles_, x);
    exhaustive_seconds += seconds(updated, Clock::now());
    update_seconds += seconds(start, updated);
    ++steps;
    refitted += static_cast<double>(counts.volumes_refitted);
    translated += static_cast<double>(counts.volumes_translated);
    for (int n = 0; n < hierarchy_.node_count(); ++n)
      subtrees += !hierarchy_.is_leaf(n) &&
                  hierarchy_.cone[static_cast<std::size_t>(n)].angle >= contact::UpdateSettings{}.threshold;
  }
  int volumes() const { return hierarchy_.node_count(); }
  int update_nodes() const { return update_.count(); }
  double per_step(double sum) const { return steps > 0 ? sum / steps : 0; }

  int arity;
  contact::ConeRule cones;
  int steps = 0;
  double subtrees = 0;    ///< whose children are tested against each other, over all steps
  double refitted = 0;    ///< volumes, those above the update nodes included
  double translated = 0;  ///< volumes
  double update_seconds = 0, exhaustive_seconds = 0;

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  }
  static double sum_of_heights(const std::vector<contact::Triangle>& triangles,
                               const std::vector<Vec3<double>>& X) {
    const auto sizes = triangle_sizes(triangles, X);
    return sizes.smallest + sizes.largest;
  }
  static contact::HierarchySettings settings(const std::vector<contact::Triangle>& triangles,
                                             const std::vector<Vec3<double>>& X, int arity,
                                             contact::ConeRule cones) {
    contact::HierarchySettings settings;
    settings.arity = arity;
    settings.margin = 0.01 * sum_of_heights(triangles, X);
    settings.cones = cones;
    return settings;
  }
  static contact::UpdateSettings update_settings(const std::vector<contact::Triangle>& triangles,
                                                 const std::vector<Vec3<double>>& X) {
    contact::UpdateSettings settings;
    settings.reserve = 2 * 2.5e-4 * sum_of_heights(triangles, X);
    return settings;
  }

  const std::vector<contact::Triangle>& triangles_;
  contact::Hierarchy hierarchy_, exhaustive_;
  contact::UpdateNodes update_;
};

/// The outer surface of the solids.
inline std::vector<contact::Triangle> surface_triangles(const Mesh& mesh) {
  return contact::split_facets(outer_surface(mesh), mesh.X);
}

/// Runs the simulation to its end and lets all follow its nodes after every step.
inline void follow_run(const Mesh& mesh, AnySimulation& simulation, std::span<HierarchyCounts> all) {
  std::vector<Vec3<double>> x = mesh.X;
  while (!simulation.finished()) {
    simulation.step(1);
    const auto u = simulation.displacement();
    for (std::size_t n = 0; n < x.size(); ++n) x[n] = mesh.X[n] + u[n];
    for (HierarchyCounts& its : all) its.follow(x);
  }
}

}  // namespace glisson::bench
