// Patches, strips and packs against the plain double reference.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <glisson/core/base/error.hpp>
#include <glisson/core/solids/plain_solids.hpp>
#include <glisson/cpu/patch_solids.hpp>
#include <glisson/cpu/serial.hpp>
#include <glisson/cpu/solids/element_constants.hpp>
#include <tests/cpu/mixed_models.hpp>

namespace glisson {
namespace {

/// Nodal arrays of a model in internal numbering, with the same (float) displacement for every precision.
template <class R>
struct Nodes {
  std::vector<Vec4<R>> u, f;
  StepView<R> view;
  Nodes(const Model& model, const Numbering& numbering, double scale) : u(model.mesh.X.size()), f(u.size()) {
    for (std::size_t n = 0; n < u.size(); ++n) {
      const Vec3<double> a = displacement(model.mesh.X[at(numbering.user_of_internal[n])], scale);
      u[n] = {R(float(a.x)), R(float(a.y)), R(float(a.z)), R(0)};
      f[n] = {R(1), R(2), R(3), R(0)};  // providers add
    }
    view.u = u.data();
    view.f = f.data();
    view.node_count = static_cast<int>(u.size());
    view.dt = 1e-3;
  }
};

struct Difference {
  double squares = 0, norm = 0;
  void add(double a, double b) {
    squares += (a - b) * (a - b);
    norm += b * b;
  }
  double relative() const { return norm > 0 ? std::sqrt(squares / norm) : std::sqrt(squares); }
};

double difference(const std::vector<Vec4<float>>& a, const std::vector<Vec4<double>>& b) {
  Difference d;
  for (std::size_t n = 0; n < a.size(); ++n) {
    d.add(double(a[n].x) - 1, b[n].x - 1);
    d.add(double(a[n].y) - 2, b[n].y - 2);
    d.add(double(a[n].z) - 3, b[n].z - 3);
  }
  return d.relative();
}

std::vector<std::string> available_sets() {
  std::vector<std::string> names;
  const auto all = patches::instruction_sets();
  for (std::size_t i = 0; i < all.count; ++i)
    if (all.sets[i].available()) names.push_back(all.sets[i].name);
  return names;
}

using Case = std::tuple<Formulation, const char*, bool>;
class PatchSolids : public testing::TestWithParam<Case> {};

// 2e-5: rounding of 24 bits, amplified by kappa/mu = 10 and by sums of opposing element forces; f starts at 1
// to 3, so that at small scale the sum itself rounds. At small strain nothing may get worse: the formulas
// cancel nothing.
TEST_P(PatchSolids, AgreeWithTheReference) {
  const auto [formulation, law, viscous] = GetParam();
  const Model model = mixed_model(formulation, law, viscous);
  const Numbering numbering = make_numbering(model.mesh);
  for (const std::string& set : available_sets()) {
    Threads threads(2);
    Serial serial;
    const auto patches = make_patch_solids(threads, model, numbering, set);
    const auto plain = make_plain_solids<Serial, double>(serial, model, numbering);
    for (const double scale : {1.0, 0.7}) {
      Nodes<float> a(model, numbering, scale);
      Nodes<double> b(model, numbering, scale);
      patches->add_forces(a.view);
      plain->add_forces(b.view);
      EXPECT_LT(difference(a.f, b.f), 2e-5) << set;
      EXPECT_NEAR(patches->strain_energy(a.view).read(), plain->strain_energy(b.view).read(),
                  1e-6 * plain->strain_energy(b.view).read())
          << set;
      EXPECT_NEAR(patches->hourglass_energy(a.view).read(), plain->hourglass_energy(b.view).read(),
                  1e-5 * plain->hourglass_energy(b.view).read())
          << set;
    }
    const auto saved = patches->history(), expected = plain->history();
    ASSERT_EQ(saved.size(), expected.size());
    Difference d;
    for (std::size_t i = 0; i < saved.size(); ++i) d.add(saved[i], expected[i]);
    EXPECT_LT(d.relative(), 2e-5) << set;
  }
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Formulation f :
       {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_fixed, Formulation::h8_full})
    for (const char* law : {"LE", "NH", "AB", "PY", "TI", "OG"})
      for (const bool viscous : {false, true}) cases.emplace_back(f, law, viscous);
  return cases;
}
INSTANTIATE_TEST_SUITE_P(All, PatchSolids, testing::ValuesIn(all_cases()), [](const auto& its) {
  return std::string(name_of(std::get<0>(its.param))) + "_" + std::get<1>(its.param) +
         (std::get<2>(its.param) ? "_viscous" : "");
});

TEST(PatchSolidsBits, DoNotDependOnTheNumberOfThreads) {
  for (const Formulation formulation : {Formulation::t4, Formulation::t4anp, Formulation::h8}) {
    const Model model = mixed_model(formulation, "NH", formulation == Formulation::t4, {12, 10, 9});
    const Numbering numbering = make_numbering(model.mesh);
    std::vector<Vec4<float>> first;
    double first_energy = 0;
    for (const int count : {1, 2, 3}) {
      Threads threads(count);
      const auto solids = make_patch_solids(threads, model, numbering);
      Nodes<float> nodes(model, numbering, 1);
      for (int step = 0; step < 3; ++step) solids->add_forces(nodes.view);
      const double energy = solids->strain_energy(nodes.view).read();
      if (first.empty()) first = nodes.f, first_energy = energy;
      EXPECT_EQ(energy, first_energy);
      for (std::size_t n = 0; n < first.size(); ++n) {
        ASSERT_EQ(nodes.f[n].x, first[n].x);
        ASSERT_EQ(nodes.f[n].y, first[n].y);
        ASSERT_EQ(nodes.f[n].z, first[n].z);
        ASSERT_EQ(nodes.f[n].w, 0);
      }
    }
  }
}

TEST(PatchSolidsState, EvaluationAloneLeavesTheHistory) {
  const Model model = mixed_model(Formulation::t4, "NH", true);
  const Numbering numbering = make_numbering(model.mesh);
  Threads threads(2);
  const auto solids = make_patch_solids(threads, model, numbering);
  Nodes<float> nodes(model, numbering, 1);
  solids->add_forces(nodes.view);
  const auto history = solids->history();
  nodes.view.advance = false;
  solids->add_forces(nodes.view);
  EXPECT_EQ(solids->history(), history);

  auto other = make_patch_solids(threads, model, numbering);
  other->set_history(history);
  EXPECT_EQ(other->history(), history);
  EXPECT_THROW(other->set_history({1, 2, 3}), Error);
}

/// Boxes below, distorted above: patches run them by different kernels, the reference knows one.
Model boxes_and_others(Formulation formulation, const std::string& law, bool viscous) {
  Model model = mixed_model(formulation, law, viscous, {9, 8, 7});
  model.mesh = box_mesh({9, 8, 7}, {0.1, 0.09, 0.08}, Shape::hexahedron, 0, true);
  for (Vec3<double>& X : model.mesh.X)
    if (X.z > 0.05) X = {X.x + 0.001 * std::sin(900 * X.y), X.y + 0.001 * std::sin(700 * X.z), X.z};
  for (Vec3<double>& X : model.mesh.X) X = {X.x + 0.3 * X.y, X.y - 0.2 * X.z, X.z + 0.1 * X.x};
  return model;
}

TEST(PatchSolidsParallelepipeds, AgreeWithTheGeneralHexahedron) {
  for (const Formulation formulation : {Formulation::h8, Formulation::h8_fixed})
    for (const char* law : {"NH", "OG"})
      for (const bool viscous : {false, true}) {
        const Model model = boxes_and_others(formulation, law, viscous);
        const Numbering numbering = make_numbering(model.mesh);
        Threads threads(2);
        Serial serial;
        const auto plain = make_plain_solids<Serial, double>(serial, model, numbering);
        for (const std::string& set : available_sets()) {
          const auto patches = make_patch_solids(threads, model, numbering, set);
          Nodes<float> a(model, numbering, 0.4);
          Nodes<double> b(model, numbering, 0.4);
          patches->add_forces(a.view);
          plain->add_forces(b.view);
          EXPECT_LT(difference(a.f, b.f), 2e-5) << law << set;
          const double strain = plain->strain_energy(b.view).read(),
                       hourglass = plain->hourglass_energy(b.view).read();
          EXPECT_NEAR(patches->strain_energy(a.view).read(), strain, 1e-6 * strain) << law << set;
          EXPECT_NEAR(patches->hourglass_energy(a.view).read(), hourglass, 1e-5 * hourglass) << law << set;
          plain->set_history(std::vector<double>(plain->history().size()));
        }
      }
}

TEST(PatchSolidsParallelepipeds, AreToldFromAlmostParallelepipeds) {
  const Mesh mesh = box_mesh({1, 1, 1}, {0.1, 0.2, 0.3}, Shape::hexahedron);
  std::vector<Vec3<double>> X;
  for (const int n : mesh.element(0)) X.push_back(mesh.X[at(n)]);
  using patches::Kind, patches::kind_of;
  EXPECT_EQ(kind_of(Formulation::h8, X), Kind::h8_parallelepiped);
  EXPECT_EQ(kind_of(Formulation::h8_fixed, X), Kind::h8_parallelepiped);
  EXPECT_EQ(kind_of(Formulation::h8_full, X), Kind::h8_full);
  X[6].y += 1e-6;
  EXPECT_EQ(kind_of(Formulation::h8, X), Kind::h8);
  EXPECT_EQ(kind_of(Formulation::h8_fixed, X), Kind::h8_fixed);
}

// One section, one law: 41 numbers of the elements, indices and sums. The bound is the promise of the
// documentation.
TEST(PatchSolidsMemory, PerTetrahedron) {
  Model model;
  model.mesh = box_mesh({26, 26, 26}, {0.1, 0.1, 0.1}, Shape::tetrahedron, 0.15, true);
  model.sections = {section_of(Formulation::t4, "NH", false)};
  for (int e = 0; e < model.mesh.element_count(); ++e) model.sections[0].elements.push_back(e);
  Threads threads(2);
  const auto solids = make_patch_solids(threads, model, make_numbering(model.mesh));
  EXPECT_LT(double(solids->memory_bytes()) / model.mesh.element_count(), 62);
}

TEST(PatchSolidsInput, NamesWhatIsMissing) {
  Model model = mixed_model(Formulation::t4, "NH", false);
  const Numbering numbering = make_numbering(model.mesh);
  Threads threads(1);
  EXPECT_THROW(make_patch_solids(threads, model, numbering, "mmx"), Error);
  model.sections[0].material.law = "XX";
  EXPECT_THROW(make_patch_solids(threads, model, numbering), Error);
}

}  // namespace
}  // namespace glisson
