// Ensembles whose members have membranes and shells, against their single runs.
#include <gtest/gtest.h>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/run/make_ensemble.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

/// A block in a capsule, or the capsule alone, pulled by gravity; its stiffness depends on k.
Model member(bool solid, int k) {
  Model model = box_model({3, 3, 3}, {0.03, 0.03, 0.03}, Formulation::t4, {"NH", {1000, 5000}}, 0.1);
  ShellSection capsule;
  capsule.law = "NeoHookean";
  capsule.parameters = {20000.0 * (k + 1)};
  capsule.density = 1000, capsule.thickness = 0.001;
  capsule.prony = {{0.3, 0.02}};
  for (const Facet& facet : outer_surface(model.mesh))
    append_triangles(facet, model.mesh.X, model.mesh.triangles);
  for (int e = 0; e < static_cast<int>(model.mesh.triangles.size()); ++e) capsule.elements.push_back(e);
  model.shells = {capsule};
  model.fixed = {{face(model.mesh, 2, 0)}};
  model.gravity = {{{}, {0, 0, -9.81}, ramp_curve(0.03)}};
  model.time.total = 0.03;
  if (solid) return model;
  model.sections.clear();
  model.mesh.shape.clear(), model.mesh.nodes.clear(), model.mesh.begin = {0};
  return model;
}

TEST(ShellEnsembles, MembersEndAsTheirSingleRuns) {
  for (const bool solid : {true, false}) {
    SCOPED_TRACE(solid);
    const SimulationOptions options{.device = "cpu", .threads = 1};
    std::vector<Model> members{member(solid, 0), member(solid, 1), member(solid, 2)};
    const auto ensemble = make_ensemble(members, options);
    ensemble->step(10'000);
    double before = 1e9;
    for (int k = 0; k < 3; ++k) {
      const auto single = make_simulation(members[static_cast<std::size_t>(k)], options);
      single->step(10'000);
      const auto a = ensemble->member(k).displacement(), b = single->displacement();
      double largest = 0, difference = 0;
      for (std::size_t n = 0; n < a.size(); ++n) {
        largest = std::max(largest, std::abs(b[n].z));
        difference = std::max(difference, std::abs(a[n].z - b[n].z));
      }
      EXPECT_LT(difference, 1e-4 * largest);  // sums of single precision in another order
      EXPECT_GT(ensemble->member(k).energies().shell, 0);
      EXPECT_LT(largest, before);  // the stiffer the less
      before = largest;
    }
  }
}

TEST(ShellEnsembles, OtherTrianglesAreAnotherMesh) {
  std::vector<Model> members{member(true, 0), member(true, 1)};
  members[1].mesh.triangles.pop_back(), members[1].shells[0].elements.pop_back();
  EXPECT_THROW(make_ensemble(std::move(members), {.device = "cpu"}), Error);
}

}  // namespace
}  // namespace glisson::test
