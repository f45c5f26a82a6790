// Hierarchies: structure, broad phase against brute force, cones, selective refitting.
#include <gtest/gtest.h>

#include <algorithm>

#include <glisson/contact/bvh/pair_search.hpp>
#include <glisson/contact/bvh/update_nodes.hpp>
#include <glisson/core/base/error.hpp>

#include "tests/contact/surfaces.hpp"

namespace glisson::contact {
namespace {

constexpr double pi = full_turn / 2;
std::size_t at(int i) { return std::size_t(i); }

Box leaf_box(const TriangleSurface& s, int t, double margin) {
  Box box;
  for (const int n : s.triangles[at(t)]) box = united(box, s.x[at(n)]);
  return inflated(box, margin);
}
Pairs brute_force(const TriangleSurface& a, const TriangleSurface& b, double margin) {
  Pairs pairs;
  for (int i = 0; i < int(a.triangles.size()); ++i)
    for (int j = 0; j < int(b.triangles.size()); ++j)
      if (overlap(leaf_box(a, i, margin), leaf_box(b, j, margin))) pairs.emplace_back(i, j);
  return pairs;
}
Hierarchy hierarchy_of(const TriangleSurface& s, int arity, double margin = 0) {
  HierarchySettings settings;
  settings.arity = arity;
  settings.margin = margin;
  return build_hierarchy(s.triangles, s.x, settings);
}

/// Parts in another order, as threads may take them.
const HostParts backwards{1, [](int count, const std::function<void(int, int)>& part) {
                            for (int i = count; i-- > 0;) part(i, 0);
                          }};

TEST(BroadPhase, IsBruteForceOnTenThousandRandomScenes) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> count(0, 18);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  for (int scene = 0; scene < 10000; ++scene) {
    auto a = random_soup(random, 3 + count(random), count(random));
    const auto b = scene % 3 ? random_soup(random, 3 + count(random), count(random))
                             : sphere({move(random), 0, 0}, 0.6, 3, 4);
    const int arity = scene % 2 ? 2 : 4;
    const double margin = scene % 5 ? 0.01 : 0;
    auto ha = hierarchy_of(a, arity, margin);
    const auto hb = hierarchy_of(b, arity, margin);
    ASSERT_EQ(overlapping_pairs(ha, hb), brute_force(a, b, margin)) << scene;
    for (auto& p : a.x) p = p + Vec3<double>{move(random), move(random), move(random)};
    refit(ha, a.triangles, a.x);
    ASSERT_EQ(overlapping_pairs(ha, hb), brute_force(a, b, margin)) << scene;
    Pairs self = brute_force(a, a, margin);
    self.erase(std::remove_if(self.begin(), self.end(), [](const auto& p) { return p.first >= p.second; }),
               self.end());
    ASSERT_EQ(overlapping_pairs(ha, 0).pairs, self) << scene;
  }
}

/// Three regions: 0 and 2 must not touch each other, nor 1 itself.
TEST(BroadPhase, InPartsIsBruteForceOfWhatMayTouch) {
  std::mt19937 random(13);
  std::uniform_int_distribution<int> count(0, 40);
  const auto may = [](int a, int b) { return a + b != 2; };
  for (int scene = 0; scene < 2000; ++scene) {
    const auto s = random_soup(random, 3 + count(random), count(random));
    const double margin = scene % 5 ? 0.02 : 0;
    const auto h = hierarchy_of(s, scene % 2 ? 2 : 4, margin);
    std::vector<int> region;
    for (std::size_t t = 0; t < s.triangles.size(); ++t) region.push_back(int(3 * t / s.triangles.size()));
    Pairs expected = brute_force(s, s, margin), found;
    std::erase_if(expected, [&](const auto& p) {
      return p.first >= p.second || !may(region[at(p.first)], region[at(p.second)]);
    });
    PairSearch(h, region, may).find(h, 0, backwards, found);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected) << scene;
  }
}

TEST(BroadPhase, NearTrianglesAreThoseWhoseBoxesOverlap) {
  const auto s = sphere({}, 1, 12, 16);
  const auto h = hierarchy_of(s, 4, 0.02);
  std::vector<int> found, stack, expected;
  const Box box{{0.5, 0.2, 0.3}, {0.9, 0.6, 0.5}};
  triangles_near(h, box, found, stack);
  for (int t = 0; t < int(s.triangles.size()); ++t)
    if (overlap(leaf_box(s, t, 0.02), box)) expected.push_back(t);
  EXPECT_EQ(found, expected);
  EXPECT_FALSE(found.empty());
}

/// Triangles of a subtree hang together over edges.
bool hangs_together(const TriangleSurface& s, std::vector<int> triangles) {
  std::vector<Triangle> its;
  for (const int t : triangles) its.push_back(s.triangles[at(t)]);
  const auto neighbours = neighbours_of(its);
  std::vector<int> reached{0};
  std::vector<bool> seen(its.size());
  seen[0] = true;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const int n : neighbours[at(reached[i])])
      if (n >= 0 && !seen[at(n)]) seen[at(n)] = true, reached.push_back(n);
  return reached.size() == its.size();
}

TEST(HierarchyBuild, EveryTriangleHasOneLeafAndSubtreesHangTogether) {
  for (const int arity : {2, 4}) {
    TriangleSurface s = sphere({}, 1, 9, 12);
    append(s, sphere({3, 0, 0}, 1, 5, 6));
    append(s, rolled_strip(20, 0));
    const auto h = hierarchy_of(s, arity);
    std::vector<std::vector<int>> below(h.nodes.size());
    for (const int n : h.by_level) {  // children first
      if (h.is_leaf(n)) below[at(n)] = {h.nodes[at(n)].triangle};
      int children = 0;
      for (const int c : h.nodes[at(n)].child)
        if (c >= 0) {
          ++children;
          EXPECT_EQ(h.nodes[at(c)].parent, n);
          below[at(n)].insert(below[at(n)].end(), below[at(c)].begin(), below[at(c)].end());
        }
      EXPECT_TRUE(h.is_leaf(n) ? children == 0 : children >= 2 && children <= arity);
      EXPECT_TRUE(!h.nodes[at(n)].connected || hangs_together(s, below[at(n)]));
    }
    auto all = below[0];
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all.size(), s.triangles.size());
    for (int t = 0; t < int(all.size()); ++t) EXPECT_EQ(all[at(t)], t);
    EXPECT_FALSE(h.nodes[0].connected);
    EXPECT_EQ(h.level_begin.back(), h.node_count());
  }
}

TEST(HierarchyBuild, HandlesNothingOneAndManyLoosePatches) {
  EXPECT_EQ(hierarchy_of({}, 4).node_count(), 0);
  EXPECT_EQ(hierarchy_of(rolled_strip(1, 0), 4).node_count(), 3);
  std::mt19937 random(3);
  const auto soup = random_soup(random, 3000, 2000);
  EXPECT_LT(hierarchy_of(soup, 2).level_count(), 80);
  EXPECT_THROW(hierarchy_of(soup, 3), Error);
}

/// Random directions of a cone about its axis are in the merged cone, which is as narrow as it can be.
TEST(NormalCones, MergedConesHoldBothAndAreNarrowest) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> angle(0, pi);
  const auto direction = [&] { return cone_of({normal(random), normal(random), normal(random)}).axis; };
  const auto between = [](const Vec3<double>& a, const Vec3<double>& b) {
    const auto c = cross(a, b);
    return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
  };
  int narrower = 0;
  for (int i = 0; i < 5000; ++i) {
    const NormalCone a{direction(), angle(random)}, b{direction(), angle(random)};
    const auto narrow = merged(a, b), provot = merged(a, b, ConeRule::provot),
               checked = merged(a, b, ConeRule::provot_or_child);
    for (const auto& cone : {narrow, provot, checked}) {
      if (cone.angle >= full_turn) continue;
      EXPECT_LE(between(cone.axis, a.axis) + a.angle / 2, cone.angle / 2 + 1e-9);
      EXPECT_LE(between(cone.axis, b.axis) + b.angle / 2, cone.angle / 2 + 1e-9);
    }
    EXPECT_LE(narrow.angle, checked.angle + 1e-9);
    EXPECT_LE(checked.angle, provot.angle + 1e-9);
    const double needed = std::max({a.angle, b.angle, between(a.axis, b.axis) + (a.angle + b.angle) / 2});
    EXPECT_NEAR(narrow.angle, std::min(needed, full_turn), 1e-9);
    narrower += narrow.angle < provot.angle - 1e-6;
  }
  EXPECT_GT(narrower, 1000);
}

TEST(NormalCones, DegenerateFacetsExcludeNothing) {
  EXPECT_EQ(cone_of({}).angle, full_turn);
  EXPECT_EQ(merged(cone_of({0, 0, 1}), cone_of({0, 0, -1})).angle, full_turn);
  EXPECT_NEAR(merged(cone_of({0, 0, 1}), cone_of({1, 0, 0})).angle, pi / 2, 1e-11);
  EXPECT_EQ(merged(NormalCone{}, cone_of({0, 0, 2})).angle, 0);
}

TEST(SelfContact, AFlatStripIsNotSearchedAndARolledOneIs) {
  const auto flat = rolled_strip(60, 0), bent = rolled_strip(60, 0.9 * pi),
             rolled = rolled_strip(60, 2.2 * pi);
  const double threshold = 0.95 * pi;
  EXPECT_EQ(overlapping_pairs(hierarchy_of(flat, 4), threshold).subtrees_tested, 0);
  EXPECT_EQ(overlapping_pairs(hierarchy_of(bent, 4), threshold).subtrees_tested, 0);
  const auto found = overlapping_pairs(hierarchy_of(rolled, 4), threshold);
  // its end lies on its start: pairs far apart along the strip
  EXPECT_TRUE(std::any_of(found.pairs.begin(), found.pairs.end(),
                          [](const auto& p) { return p.second - p.first > 60; }));
  const auto all = overlapping_pairs(hierarchy_of(rolled, 4), 0);
  EXPECT_LT(found.subtrees_tested, all.subtrees_tested);
  for (const auto& p : all.pairs)
    EXPECT_TRUE(p.second - p.first <= 60 || std::binary_search(found.pairs.begin(), found.pairs.end(), p));
}

/// What an update promises, checked on every leaf and every cone.
void expect_valid(const Hierarchy& h, const TriangleSurface& s, const UpdateSettings& settings) {
  std::vector<Box> needed(h.nodes.size());
  std::vector<std::vector<Vec3<double>>> normals(h.nodes.size());
  for (const int n : h.by_level) {
    if (h.is_leaf(n)) {
      needed[at(n)] = leaf_box(s, h.nodes[at(n)].triangle, settings.reserve);
      const Triangle& t = s.triangles[at(h.nodes[at(n)].triangle)];
      normals[at(n)] = {cone_of(cross(s.x[at(t[1])] - s.x[at(t[0])], s.x[at(t[2])] - s.x[at(t[0])])).axis};
    }
    ASSERT_TRUE(contains(h.box[at(n)], needed[at(n)].low) && contains(h.box[at(n)], needed[at(n)].high)) << n;
    if (h.cone[at(n)].angle < settings.threshold) {
      for (const auto& a : normals[at(n)])
        for (const auto& b : normals[at(n)]) ASSERT_GT(dot(a, b), std::cos(settings.threshold));
    }
    if (const int parent = h.nodes[at(n)].parent; parent >= 0) {
      needed[at(parent)] = united(needed[at(parent)], needed[at(n)]);
      normals[at(parent)].insert(normals[at(parent)].end(), normals[at(n)].begin(), normals[at(n)].end());
    }
  }
}

TEST(SelectiveRefit, LeavesAloneShiftsOrRefits) {
  auto s = sphere({}, 1, 16, 24);
  auto h = hierarchy_of(s, 4, 0.02);
  const UpdateSettings settings{0.95 * pi, 0.002};
  UpdateNodes update(h, s.triangles, s.x, settings);
  EXPECT_EQ(update.update(h, s.triangles, s.x).inactive, update.count());
  for (auto& p : s.x) p = p + Vec3<double>{0.015, 0, 0};
  EXPECT_EQ(update.update(h, s.triangles, s.x).inactive, update.count());
  expect_valid(h, s, settings);
  for (auto& p : s.x) p = p + Vec3<double>{0.015, 0, 0};
  const auto shifted = update.update(h, s.triangles, s.x);
  EXPECT_EQ(shifted.translated, update.count());
  EXPECT_LT(shifted.volumes_refitted, h.node_count() / 4);
  expect_valid(h, s, settings);
  for (auto& p : s.x) p = {p.x, p.y, 0.5 * p.z};
  EXPECT_GT(update.update(h, s.triangles, s.x).refitted, 0);
  expect_valid(h, s, settings);
}

TEST(SelectiveRefit, KeepsItsPromiseOverARandomDeformation) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> noise(-2e-4, 2e-4);
  auto s = sphere({}, 1, 16, 24);
  append(s, sphere({2.5, 0, 0}, 1, 10, 12));
  auto h = hierarchy_of(s, 2, 0.02);
  const UpdateSettings settings{0.95 * pi, 0.002};
  UpdateNodes update(h, s.triangles, s.x, settings);
  std::int64_t refitted = 0;
  constexpr int steps = 200;
  for (int step = 0; step < steps; ++step) {
    for (auto& p : s.x)  // the one drifts and swings, both tremble
      p = p + Vec3<double>{2e-3 * (p.x < 1.2), 1e-3 * std::sin(3 * p.x), 0} +
          Vec3<double>{noise(random), noise(random), noise(random)};
    refitted += update.update(h, s.triangles, s.x).volumes_refitted;
    if (step % 10 == 0) expect_valid(h, s, settings);
  }
  EXPECT_LT(refitted, std::int64_t(steps) * h.node_count() / 3);
}

}  // namespace
}  // namespace glisson::contact
