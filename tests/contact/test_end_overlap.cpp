// What contact lost: warnings at the end of a run.
#include <gtest/gtest.h>

#include <random>

#include <glisson/contact/bvh/solid_search.hpp>
#include <glisson/contact/end_overlap.hpp>
#include <glisson/core/mesh/surface.hpp>

#include <tests/contact/body_scenes.hpp>

namespace glisson::test {
namespace {

/// A cube of 4 cells and on it a smaller one of 3.
Model two_blocks() {
  Model model;
  const Material rubber{"NH", mu_kappa(1e4, 0.3), 1000};
  add_body(model, box_mesh({4, 4, 4}, {1, 1, 1}, Shape::hexahedron), Formulation::h8, rubber);
  Mesh upper = box_mesh({3, 3, 3}, {0.6, 0.6, 0.6}, Shape::tetrahedron);
  move(upper, {0.21, 0.22, 1});
  add_body(model, upper, Formulation::t4, rubber);
  model.contact.between_bodies = true;
  model.time.total = 1;
  return model;
}
std::vector<Vec3<double>> sunk(const Model& model, double depth) {
  std::vector<Vec3<double>> u(model.mesh.X.size());
  for (std::size_t n = 125; n < u.size(); ++n) u[n] = {0, 0, -depth};
  return u;
}

TEST(EndOverlap, NamesTheDeepestNodeOfABodyInAnother) {
  Model model = two_blocks();
  EXPECT_TRUE(contact::overlap_warnings(model, sunk(model, 0), 1).empty());
  EXPECT_TRUE(contact::overlap_warnings(model, sunk(model, 0.03), 1).empty()) << "contact brings it out";
  for (const double depth : {0.1, 0.3, 0.62}) {
    const auto warnings = contact::overlap_warnings(model, sunk(model, depth), 1);
    ASSERT_EQ(warnings.size(), 1u) << depth;
    EXPECT_NE(warnings[0].find("sub-model 'body 1'"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("sub-model 'body 0'"), std::string::npos) << warnings[0];
  }
  model.contact.pairs = {{"pair", "body 0", "body 1", false, {}}};
  EXPECT_TRUE(contact::overlap_warnings(model, sunk(model, 0.3), 1).empty()) << "they may";
  model.contact.pairs.clear();
  model.contact.between_bodies = false;
  EXPECT_TRUE(contact::overlap_warnings(model, sunk(model, 0.3), 1).empty()) << "no contact wanted";
}

/// A pyramid, tip down, that comes down between the nodes.
TEST(EndOverlap, NamesATipThatWentInBetweenNodes) {
  Model model = two_blocks();
  model.contact.between_bodies = false;
  RigidSurface tip;
  tip.name = "tip";
  tip.surface.X = {
      {0.58, 0.58, 1.8}, {0.62, 0.58, 1.8}, {0.62, 0.62, 1.8}, {0.58, 0.62, 1.8}, {0.6, 0.6, 1.7}};
  tip.surface.facets = {{{0, 4, 1, -1}}, {{1, 4, 2, -1}}, {{2, 4, 3, -1}}, {{3, 4, 0, -1}}};
  tip.displacement = {0, 0, -0.25};
  tip.motion = {LoadShape::ramp, 0, 1};
  model.surfaces = {tip};
  const auto u = sunk(model, 0);
  EXPECT_TRUE(contact::overlap_warnings(model, u, 0).empty());
  const auto warnings = contact::overlap_warnings(model, u, 1);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("its node 4 by 0.15"), std::string::npos) << warnings[0];
  model.surfaces[0].nodes = {130};
  EXPECT_TRUE(contact::overlap_warnings(model, u, 1).empty()) << "the file says which nodes may touch it";
}

/// Two balls, one within the other's box, against the distance from their centres.
TEST(EndOverlap, SearchFindsTheSolidsAroundAPoint) {
  std::vector<contact::Triangle> triangles;
  std::vector<int> solid;
  std::vector<Vec3<double>> x;
  const std::array<Vec3<double>, 2> centre{{{0, 0, 0}, {0.8, 0.6, 0.5}}};
  for (int b = 0; b < 2; ++b) {
    const Mesh ball = ball_mesh(5);
    const int first = int(x.size());
    for (const auto& X : ball.X) x.push_back(X + centre[std::size_t(b)]);
    for (const auto& t : contact::split_facets(outer_surface(ball), ball.X)) {
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      solid.push_back(b);
    }
  }
  contact::SolidSearch search(triangles, solid, x);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.1, 2.3);
  int in_both = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3<double> p{place(random), place(random), place(random)};
    std::vector<int> expected;
    bool near = false;
    for (int b = 0; b < 2; ++b) {
      const auto d = p - centre[std::size_t(b)];
      const double r = std::sqrt(dot(d, d));
      near = near || std::abs(r - 0.98) < 0.021;  // facets lie up to 0.03 below the sphere
      if (r < 1) expected.push_back(b);
    }
    if (near) continue;
    ASSERT_EQ(search.around(p, [](int) { return true; }), expected) << i;
    in_both += expected.size() == 2;
  }
  EXPECT_GT(in_both, 100);
}

}  // namespace
}  // namespace glisson::test
