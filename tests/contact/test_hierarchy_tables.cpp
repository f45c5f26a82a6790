// Tables 5.1 and 5.2 of Johnsen 2016 at reduced size (bench/contact_bench.cpp has the whole): narrowest cones
// leave fewer subtrees to test than Provot's, update nodes fewer volumes to refit than refitting all.
#include <gtest/gtest.h>

#include <bench/contact_cases.hpp>
#include <bench/hierarchy_counts.hpp>
#include <tests/support/cases.hpp>

namespace glisson::test {
namespace {

using bench::HierarchyCounts;
using contact::ConeRule;

std::vector<HierarchyCounts> counted(const bench::ContactCase& its, std::vector<ConeRule> rules) {
  static std::vector<contact::Triangle> triangles;  // outlives the counts
  triangles = bench::surface_triangles(its.model.mesh);
  std::vector<HierarchyCounts> all;
  for (const int arity : {2, 4})
    for (const ConeRule cones : rules) all.emplace_back(triangles, its.model.mesh.X, arity, cones);
  const auto simulation = simulate(its.model, threads_float);
  bench::follow_run(its.model.mesh, *simulation, all);
  EXPECT_GT(simulation->contacts().at(0).report.largest_depth, 0) << its.name << ": nothing was touched";
  return all;
}

TEST(HierarchyTables, NarrowestConesLeaveThirtyPercentFewerSubtrees) {
  for (const auto& its : {bench::closing_c({28, 4, 2}, 0), bench::closing_zipper({24, 3, 1}, 0)}) {
    const auto all = counted(its, {ConeRule::narrowest, ConeRule::provot});
    for (std::size_t k = 0; k < all.size(); k += 2) {
      EXPECT_GT(all[k].subtrees, 0) << its.name;
      EXPECT_LT(all[k].subtrees, 0.7 * all[k + 1].subtrees) << its.name << " AABB" << all[k].arity;
    }
  }
}

TEST(HierarchyTables, UpdateNodesRefitAFifthOfTheVolumes) {
  for (const auto& its : {bench::ball_and_slab(6, {6, 9, 2}, 0), bench::two_spheres({6, 6, 6}, 0),
                          bench::rigid_bar({9, 12, 2}, 0)})
    for (const HierarchyCounts& one : counted(its, {ConeRule::narrowest}))
      EXPECT_LT(5 * one.per_step(one.refitted), one.volumes()) << its.name << " AABB" << one.arity;
}

}  // namespace
}  // namespace glisson::test
