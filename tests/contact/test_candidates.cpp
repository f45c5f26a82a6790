// Broad phase of contact between deformable bodies against brute force: nothing that can touch is lost.
#include <gtest/gtest.h>

#include <random>

#include <glisson/run/search_parts.hpp>

#include "tests/contact/bodies.hpp"
#include "tests/contact/candidate_reference.hpp"

namespace glisson::contact {
namespace {

using test::add_body;
using Found = std::set<std::array<int, 2>>;  ///< pairs

Found nodes_and_facets(const Candidates& c) {
  Found found;
  for (int g = 0; g < c.group_count(); ++g)
    for (int i = c.group_begin[std::size_t(g)]; i < c.group_begin[std::size_t(g + 1)]; ++i)
      found.insert({c.group_node[std::size_t(g)], c.facets[std::size_t(i)]});
  return found;
}

/// One search against all pairs. Within one part what fits into a half-space may be found or not.
void expect_all_found(const ContactMesh& mesh, const Candidates& found, const CandidateReference& reference,
                      int& required) {
  const Found nodes = nodes_and_facets(found), edges(found.edge_pairs.begin(), found.edge_pairs.end());
  const auto compare = [&](bool may, bool is_found, bool same_part, auto may_be_left_out) {
    ASSERT_TRUE(may || !is_found) << "cannot meet";
    if (!may || (same_part && may_be_left_out())) return;
    ASSERT_TRUE(is_found) << "lost";
    ++required;
  };
  const auto part = [&](int t) { return mesh.part_of_region[std::size_t(mesh.region[std::size_t(t)])]; };
  for (int n = 0; n < mesh.node_count(); ++n)
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const int own = mesh.around[std::size_t(mesh.around_begin[std::size_t(n)])];
      ASSERT_NO_FATAL_FAILURE(compare(reference.node_may_meet(n, t), nodes.contains({n, t}),
                                      part(own) == part(t),
                                      [&] { return reference.node_may_be_left_out(n, t); }))
          << "node " << n << " facet " << t;
    }
  for (int i = 0; i < int(mesh.edges.size()); ++i)
    for (int j = i + 1; j < int(mesh.edges.size()); ++j) {
      const int a = mesh.edges[std::size_t(i)].triangle[0], b = mesh.edges[std::size_t(j)].triangle[0];
      ASSERT_NO_FATAL_FAILURE(compare(reference.edges_may_meet(i, j), edges.contains({i, j}),
                                      part(a) == part(b),
                                      [&] { return reference.edges_may_be_left_out(i, j); }))
          << "edges " << i << " " << j;
    }
}

struct Random {
  std::mt19937 engine;
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  int count(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); }
  Vec3<double> point(double most) { return {in(-most, most), in(-most, most), in(-most, most)}; }
};

/// What hangs on rounding at rest, like edges exactly beside each other, must not decide.
Mesh without_ties(Mesh mesh, Random& random) {
  for (auto& p : mesh.X) p = p + random.point(1e-3);
  return mesh;
}

/// Two or three small bodies anywhere near each other.
Model heap(Random& random) {
  Model model;
  const int bodies = random.count(2, 3);
  for (int b = 0; b < bodies; ++b) {
    const bool tetrahedra = random.count(0, 1) == 0;
    const Shape shape = tetrahedra ? Shape::tetrahedron : Shape::hexahedron;
    Mesh mesh = box_mesh({1, 1, random.count(0, 3) ? 1 : 2}, {1, 1, random.in(0.05, 1)}, shape);
    test::move(mesh, random.point(0.8));
    add_body(model, without_ties(mesh, random), tetrahedra ? Formulation::t4 : Formulation::h8,
             {"NH", {1, 1}});
  }
  return model;
}

bool same(const Candidates& a, const Candidates& b) {
  return a.group_node == b.group_node && a.group_region == b.group_region && a.group_begin == b.group_begin &&
         a.facets == b.facets && a.bias == b.bias && a.group_friction == b.group_friction &&
         a.group_entry == b.group_entry && a.edge_pairs == b.edge_pairs &&
         a.edge_friction == b.edge_friction && a.edge_entry == b.edge_entry && a.nodes == b.nodes &&
         a.incident_begin == b.incident_begin && a.incident == b.incident;
}

/// Large enough that every stage has several parts.
TEST(Candidates, AreTheSameForAnyThreads) {
  Random random{std::mt19937(31)};
  Model model;
  for (int b = 0; b < 2; ++b) {
    Mesh mesh = box_mesh({24, 24, 2}, {6, 6, 0.5}, Shape::tetrahedron);
    test::move(mesh, {0.1 * b, 0.07 * b, 0.51 * b});
    add_body(model, without_ties(mesh, random), Formulation::t4, {"NH", {1, 1}});
  }
  for (const bool self : {false, true}) {
    model.contact.between_bodies = true;
    model.contact.self = self;
    const ContactMesh mesh = contact_mesh(model);
    const ContactRules rules(model, mesh);
    auto x = mesh.X;
    for (auto& p : x) p = p + random.point(0.02);
    CandidateSearch alone(mesh, rules, 0.05);
    const Candidates expected = alone.find(x, 0.1);
    EXPECT_GT(expected.group_count(), 500);
    for (const int threads : {1, 2, 3}) {
      Team team(threads);
      CandidateSearch search(mesh, rules, 0.05);
      for (int again = 0; again < 3; ++again)
        EXPECT_TRUE(same(search.find(x, 0.1, parts_of(team)), expected)) << threads << " threads";
    }
  }
}

/// The bodies are deformed at random, turned inside out among them, and may touch themselves.
TEST(Candidates, OfBodiesAreThoseOfBruteForceInTenThousandScenes) {
  Random random{std::mt19937(23)};
  int required = 0;
  for (int scene = 0; scene < 10000; ++scene) {
    Model model = heap(random);
    model.contact.between_bodies = model.contact.self = true;
    const ContactMesh mesh = contact_mesh(model);
    const ContactRules rules(model, mesh);
    const double reach = random.in(0.01, 0.2), margin = reach + random.in(0, 0.3);
    CandidateSearch search(mesh, rules, reach);
    auto x = mesh.X;
    for (auto& p : x) p = p + random.point(scene % 3 ? 0.2 : 0);
    const CandidateReference reference(mesh, x, reach, margin);
    ASSERT_NO_FATAL_FAILURE(expect_all_found(mesh, search.find(x, margin), reference, required)) << scene;
  }
  EXPECT_GT(required, 100000);
}

/// A strip bent to an arc of up to 1.3 turns, twisted, and crumpled a little.
std::vector<Vec3<double>> bent(std::vector<Vec3<double>> X, Random& random) {
  const double angle = random.in(0, 2.6 * 3.14159265), twist = random.in(-1, 1), crumple = random.in(0, 0.1);
  const double radius = 12 / std::max(angle, 1e-3);
  for (auto& p : X) {
    const double turn = twist * p.x / 12, around = p.x / radius;
    const double y = std::cos(turn) * p.y - std::sin(turn) * p.z;
    const double r = radius - std::sin(turn) * p.y - std::cos(turn) * p.z;
    p = Vec3<double>{r * std::sin(around), y, radius - r * std::cos(around)} + random.point(crumple);
  }
  return X;
}

TEST(Candidates, OfAStripThatBendsOntoItselfAreThoseOfBruteForce) {
  Random random{std::mt19937(29)};
  int required = 0;
  for (int scene = 0; scene < 400; ++scene) {
    Model model;
    const Mesh strip = box_mesh({12, 1, 1}, {12, 1, 0.4}, Shape::tetrahedron);
    add_body(model, without_ties(strip, random), Formulation::t4, {"NH", {1, 1}});
    model.contact.self = true;
    const ContactMesh mesh = contact_mesh(model);
    const ContactRules rules(model, mesh);
    const double reach = 0.1, margin = random.in(0.1, 0.5);
    CandidateSearch search(mesh, rules, reach);
    const auto x = bent(mesh.X, random);
    const CandidateReference reference(mesh, x, reach, margin);
    ASSERT_NO_FATAL_FAILURE(expect_all_found(mesh, search.find(x, margin), reference, required)) << scene;
  }
  EXPECT_GT(required, 1000);
}

}  // namespace
}  // namespace glisson::contact
