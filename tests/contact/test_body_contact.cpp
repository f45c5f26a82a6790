// Deformable bodies in contact: exchange of momentum, a uniform stress through meshes that do not match,
// restart, threads, what is refused.
#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include <tests/contact/body_scenes.hpp>
#include <tests/support/same_bits.hpp>

namespace glisson::test {
namespace {

class BodyContacts : public Matrix {};

/// Two equal bars with nu = 0: the first flies at the second, whose mesh is another one across.
Model two_bars(double v, double gap) {
  Model model;
  const double L = 0.1;
  const Material rubber{"LE", {1e4, 0.0}, 1000};
  Mesh first = box_mesh({50, 2, 2}, {L, 0.008, 0.008}, Shape::hexahedron);
  Mesh second = box_mesh({50, 3, 3}, {L, 0.008, 0.008}, Shape::hexahedron);
  move(second, {L + gap, 0, 0});
  const Body a = add_body(model, first, Formulation::h8, rubber);
  add_body(model, second, Formulation::h8, rubber);
  model.initial_velocities.push_back({a.nodes(), {v, 0, 0}});
  model.contact.between_bodies = true;
  return model;
}

/// The wave that starts at the impact is back at 2 L / c: then the first bar rests and the second moves.
TEST_P(BodyContacts, EqualBarsExchangeTheirVelocity) {
  const double v = 0.01, L = 0.1, c = std::sqrt(1e4 / 1000), gap = 1e-5;
  Model model = two_bars(v, gap);
  model.time.total = gap / v + 2 * L / c + 0.03;
  const Body a{0, 51 * 9}, b{51 * 9, 51 * 16};
  const auto mass = lumped_mass(model);
  auto simulation = simulate(model, GetParam());
  double parted = 0;
  while (!simulation->finished()) {
    simulation->step(1);
    if (mean_of(simulation->velocity(), b, mass).x < 0.98 * v) parted = simulation->time();
  }
  const auto va = mean_of(simulation->velocity(), a, mass), vb = mean_of(simulation->velocity(), b, mass);
  EXPECT_NEAR(vb.x / v, 1, 0.01);
  EXPECT_NEAR(va.x / v, 0, 0.01);
  EXPECT_NEAR((va.x + vb.x) / v, 1, GetParam().rounding());
  EXPECT_NEAR(parted - gap / v, 2 * L / c, 0.1 * L / c);
  const Energies e = simulation->energies();
  EXPECT_NEAR(e.kinetic + e.strain, e.initial, 0.01 * e.initial);
}

/// Two blocks on each other, 3 x 3 and 4 x 4 cells at the interface, pressed by 5 %, nu = 0.3, sides free.
Model pressed_blocks(Shape shape, Formulation formulation) {
  Model model;
  const Material rubber{"NH", mu_kappa(3000, 0.3), 1000};
  add_body(model, box_mesh({3, 3, 2}, {1, 1, 0.5}, shape), formulation, rubber);
  Mesh upper = box_mesh({4, 4, 3}, {1, 1, 0.5}, shape);
  move(upper, {0, 0, 0.5});
  add_body(model, upper, formulation, rubber);
  model.fixed.push_back({face(model.mesh, 2, 0), 4});
  model.fixed.push_back({face(model.mesh, 0, 0), 1});
  model.fixed.push_back({face(model.mesh, 1, 0), 2});
  model.displacements.push_back({face(model.mesh, 2, 1), 4, {-0.05}, ramp_curve(1)});
  model.contact.between_bodies = true;
  model.time = relaxed();
  return model;
}

/// Nodes and facets that do not match pass a uniform stress if the interface has no way to warp that this
/// stress works on; quadrilaterals cut along one diagonal have one, and the stress varied by 6 %.
TEST_P(BodyContacts, AUniformStressPassesAnInterfaceThatDoesNotMatch) {
  for (const auto& [shape, formulation, bound] : {std::tuple{Shape::tetrahedron, Formulation::t4, 4e-3},
                                                  std::tuple{Shape::hexahedron, Formulation::h8, 6e-3}}) {
    const Model model = pressed_blocks(shape, formulation);
    auto simulation = simulate(model, GetParam());
    while (!simulation->finished()) simulation->step(100);
    double low = 1e30, high = -1e30, side = 0;
    for (const auto& s : simulation->element_fields().stress) {
      low = std::min(low, s.zz);
      high = std::max(high, s.zz);
      side = std::max(side, std::abs(s.xx));
    }
    EXPECT_NEAR(low / high, 1, bound);
    EXPECT_LT(side, 1e-3 * std::abs(low));
  }
}

TEST_P(BodyContacts, KeepMomentumWithFriction) {
  const Model model = sliding_block();
  const auto mass = lumped_mass(model);
  const Body all{0, model.mesh.node_count()};
  auto simulation = simulate(model, GetParam());
  const auto before = mean_of(simulation->velocity(), all, mass);
  while (!simulation->finished()) simulation->step(20);
  const auto after = mean_of(simulation->velocity(), all, mass);
  const auto lost = after - before;
  EXPECT_LT(std::sqrt(dot(lost, lost)), GetParam().rounding() * 0.1);
  EXPECT_LT(simulation->energies().contact, 0) << "friction takes energy";
  const Body lower{0, 25 * 25 * 3};
  EXPECT_GT(mean_of(simulation->velocity(), lower, mass).x, 1e-4) << "nothing was touched";
}

TEST(BodyContactThreads, GiveTheSameBitsForAnyNumber) {
  expect_same_bits_for_any_threads(sliding_block(), threads_float, 30);
}

TEST_P(BodyContacts, AResumedRunEndsWithTheSameBits) {
  const Model model = sliding_block();
  const auto [whole, resumed] = expect_same_bits_resumed(model, GetParam(), 10, 10);
  const ContactReport a = whole->contacts().at(0).report, b = resumed->contacts().at(0).report;
  EXPECT_GT(a.node_count, 0);
  EXPECT_EQ(a.node_count, b.node_count);
  EXPECT_EQ(a.largest_depth, b.largest_depth);
}

GLISSON_ALL_CASES(BodyContacts);

/// Two cubes, the second one shifted by x.
Model two_cubes(const Vec3<double>& shift) {
  Model model;
  const Material rubber{"NH", mu_kappa(1e4, 0.3), 1000};
  add_body(model, box_mesh({4, 4, 4}, {1, 1, 1}, Shape::hexahedron), Formulation::h8, rubber);
  Mesh second = box_mesh({3, 3, 3}, {1, 1, 1}, Shape::tetrahedron);
  move(second, shift);
  add_body(model, second, Formulation::t4, rubber);
  model.contact.between_bodies = true;
  model.time.total = 0.1;
  return model;
}

TEST(BodyContactRefuses, BodiesThatStartInEachOther) {
  expect_refused(two_cubes({0.5, 0.1, 0.1}), "node 34 of sub-model 'body 0' starts more than");
  expect_refused(two_cubes({0.5, 0.1, 0.1}), "inside of another body, sub-model 'body 1'");
  expect_refused(two_cubes({0.955, 0.05, 0.05}), "up to 0.04 can be resolved");
  Model nested = two_cubes({0.4, 0.4, 0.4});
  for (std::size_t n = 125; n < nested.mesh.X.size(); ++n)
    nested.mesh.X[n] = Vec3<double>{0.5, 0.5, 0.5} + 0.2 * (nested.mesh.X[n] - Vec3<double>{0.9, 0.9, 0.9});
  expect_refused(nested, "starts inside of the one");
  nested.contact.pairs = {{"pair", nested.bodies_by_name[0].name, nested.bodies_by_name[1].name, false, {}}};
  EXPECT_NO_THROW(simulate(nested, serial_double)) << "the pair may not touch";
}

TEST(BodyContactRefuses, WrongNumbers) {
  for (const double wrong : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    Model model = two_cubes({1.1, 0, 0});
    model.contact.friction = wrong;
    expect_refused(model, "friction");
    model = two_cubes({1.1, 0, 0});
    model.contact.offset = wrong;
    expect_refused(model, "safety margin");
    model = two_cubes({1.1, 0, 0});
    model.contact.distance = wrong;
    expect_refused(model, "rate constraint distance");
  }
  Model model = two_cubes({1.1, 0, 0});
  model.contact.nodes = {100000};
  expect_refused(model, "does not exist");
  model.contact.nodes = {62};  // the cube's centre
  expect_refused(model, "neither on the outer surface");
  model = two_cubes({1.1, 0, 0});
  model.contact.pairs = {{"pair 7", "body 0", "body 9", true, {}}};
  expect_refused(model, "body 9");
  model.contact.pairs = {{"pair 7", "body 0", "body 1", true, {}}, {"pair 8", "body 1", "body 0", false, {}}};
  expect_refused(model, "pair 8: 'body 1' and 'body 0' are a pair already");
}

TEST(BodyContactRefuses, BodiesAtTheSamePlaceOrWithCommonSides) {
  expect_refused(two_cubes({0, 0, 0}), "starts inside of the one");
  expect_refused(two_cubes({0, 0, 0.5}), "starts inside of the one");
  expect_refused(two_cubes({0.25, 0, 0}), "starts inside of the one");
  EXPECT_NO_THROW(simulate(two_cubes({0, 0, 1}), serial_double)) << "flush";
  EXPECT_NO_THROW(simulate(two_cubes({1, 0, 0.5}), serial_double)) << "flush in part";
}

TEST(BodyContactRefuses, MarginsThatAreTooLargeForTheMesh) {
  Model model = two_cubes({1.1, 0, 0});
  model.contact.offset = 0.02;
  model.contact.distance = 0.08;
  EXPECT_NO_THROW(simulate(model, serial_double));
  model.contact.distance = 0.2;
  expect_refused(model, "too much for surface edges of");
}

/// A bar of one solid bent into a ring whose ends overlap by a part of their thickness.
Model ring(double turns) {
  Model model;
  Mesh mesh = box_mesh({30, 1, 1}, {1, 1, 1}, Shape::hexahedron);
  for (auto& X : mesh.X) {
    const double angle = 6.283185307179586 * turns * X.x, radius = 2 + X.z;
    X = {-radius * std::cos(angle), X.y + 0.3 * X.x, radius * std::sin(angle)};
  }
  add_body(model, mesh, Formulation::h8, {"NH", mu_kappa(1e4, 0.3), 1000});
  model.time.total = 0.1;
  return model;
}

TEST(BodyContactRefuses, NothingButWarnsWhereThereIsOneBody) {
  const auto warns = [](const Model& model) {
    const auto warnings = validate(model);
    return std::any_of(warnings.begin(), warnings.end(), [](const std::string& w) {
      return w.find("all elements hang together") != std::string::npos;
    });
  };
  Model model = ring(0.5);
  model.contact.between_bodies = true;
  EXPECT_TRUE(warns(model));
  model.contact.self = true;
  EXPECT_FALSE(warns(model));
  model = two_cubes({1.1, 0, 0});
  EXPECT_FALSE(warns(model));
}

TEST(BodyContactRefuses, ASolidThatGoesThroughItself) {
  Model model = ring(1.05);
  EXPECT_NO_THROW(simulate(model, serial_double)) << "no contact wanted";
  model.contact.between_bodies = true;
  EXPECT_NO_THROW(simulate(model, serial_double)) << "no self-contact wanted";
  model.contact.self = true;
  expect_refused(model, "the surface goes through itself");
  model = ring(0.97);
  model.contact.self = true;
  EXPECT_NO_THROW(simulate(model, serial_double));
}

/// Elements that meet at an edge only: the surface has no inside there.
TEST(BodyContactRefuses, SurfacesWithFourFacetsAtAnEdge) {
  Model model;
  const Material rubber{"NH", mu_kappa(1e4, 0.3), 1000};
  Mesh mesh = box_mesh({2, 2, 1}, {1, 1, 1}, Shape::hexahedron), two;
  two.X = mesh.X;
  for (const int e : {0, 3}) two.add_element(Shape::hexahedron, mesh.element(e));
  add_body(model, two, Formulation::h8, rubber);
  model.contact.self = true;
  model.time.total = 0.1;
  expect_refused(model, "4 outer facets");
  expect_refused(model, "(there are 0, 1)");
}

/// A small overlap of flush blocks ends step by step, without a jump.
TEST(BodyContactStart, ASmallOverlapIsResolvedGradually) {
  Model model = two_cubes({0.97, 0.05, 0.05});
  model.time.damping = 20;
  model.time.total = 1;
  auto simulation = simulate(model, threads_float);
  EXPECT_NEAR(simulation->contacts().at(0).report.start_depth, 0.03, 1e-6);
  double fastest = 0;
  while (!simulation->finished()) {
    simulation->step(1);
    for (const auto& v : simulation->velocity()) fastest = std::max(fastest, std::sqrt(dot(v, v)));
  }
  EXPECT_LT(fastest, 0.1);
  EXPECT_LT(simulation->contacts().at(0).report.depth, 0.003);
}

}  // namespace
}  // namespace glisson::test
