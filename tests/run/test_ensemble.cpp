// Members of an ensemble against their single runs.
#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include <glisson/core/base/error.hpp>
#include <glisson/run/make_ensemble.hpp>
#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

namespace glisson::test {
namespace {

struct Variant {
  const char* name;
  Formulation formulation;
  const char* law;
  std::vector<double> parameters;
  bool viscous;
};

const Variant variants[] = {
    {"T4", Formulation::t4, "NH", {1000, 5000}, false},
    {"T4Viscous", Formulation::t4, "NH", {1000, 5000}, true},
    {"T4Linear", Formulation::t4, "LE", {3000, 0.4}, false},
    {"T4ANP", Formulation::t4anp, "NH", {1000, 20000}, false},
    {"T4ANPViscousOgden", Formulation::t4anp, "OG", {300, 2, 200, 3, 100, 2.5, 9000}, true},
    {"H8", Formulation::h8, "AB", {1000, 2, 8000}, false},
    {"H8Fixed", Formulation::h8_fixed, "PY", {300, 200, 50, 20, 10, 6000}, false},
    {"H8FullTransverse", Formulation::h8_full, "TI", {1000, 8000, 500, 0, 0, 1}, true},
};

/// A block held at the bottom with every kind of load; what the loads and parameters are depends on k.
Model member_model(const Variant& v, int k) {
  Model model = box_model({3, 3, 4}, {0.03, 0.03, 0.04}, v.formulation, {v.law, v.parameters}, 0.1);
  const double scale = 1 + 0.11 * (k % 7);
  MaterialSpec& material = model.sections[0].material;
  const bool young = std::string(v.law) == "LE";
  for (std::size_t i = 0; i < (young ? 1 : v.parameters.size()); ++i)
    if (material.parameters[i] > 20) material.parameters[i] *= scale;
  if (v.viscous) material.isochoric = {{0.3 + 0.01 * k, 0.02}}, material.volumetric = {{0.1, 0.05 * scale}};
  const auto& mesh = model.mesh;
  model.fixed = {{face(mesh, 2, 0)}};
  const double total = 0.03;
  model.gravity = {{{}, {0, 0.5 * k, -9.81}, ramp_curve(total)}};
  model.forces = {{{face(mesh, 2, 0.04)[0]}, 1, {0.002 * (k + 1)}, smooth_curve(total)}};
  if (k % 2 == 0) model.displacements = {{face(mesh, 2, 0.04), 4, {-0.001 * scale}, smooth_curve(total)}};
  Springs springs;
  springs.nodes = {face(mesh, 2, 0.04)[1]};
  springs.targets = {{0.002, 0, 0}};
  springs.stiffness = {5.0 * scale};
  springs.curve = ramp_curve(total);
  model.springs = {springs};
  model.time.total = total * (k % 3 == 0 ? 1 : 0.7);
  model.time.safety = k % 4 == 1 ? 0.5 : 0.8;
  model.time.damping = k % 2;
  return model;
}

std::vector<Model> member_models(const Variant& v, int count) {
  std::vector<Model> models;
  for (int k = 0; k < count; ++k) models.push_back(member_model(v, k));
  return models;
}

std::unique_ptr<AnyEnsemble> run_ensemble(std::vector<Model> models, const Case& c, int threads = 2) {
  SimulationOptions options;
  options.device = c.device;
  options.precision = c.precision;
  options.threads = threads;
  auto ensemble = make_ensemble(std::move(models), options);
  while (!ensemble->finished()) ensemble->step(17);
  return ensemble;
}

double largest(const std::vector<Vec3<double>>& a) {
  double square = 0;
  for (const auto& x : a) square = std::max(square, dot(x, x));
  return std::sqrt(square);
}

double distance(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  std::vector<Vec3<double>> difference;
  for (std::size_t n = 0; n < a.size(); ++n) difference.push_back(a[n] - b[n]);
  return largest(difference);
}

bool same_bits(AnySimulation& a, AnySimulation& b) {
  const auto u = a.displacement(), v = b.displacement();
  return a.step_count() == b.step_count() && u.size() == v.size() &&
         std::memcmp(u.data(), v.data(), u.size() * sizeof u[0]) == 0;
}

TEST(Ensemble, EveryMemberIsItsSingleRun) {
  for (const Variant& v : variants)
    for (const Case& c : all_cases) {
      const int count = std::string(c.device) == "emulated" ? 2 : 5;
      const auto models = member_models(v, count);
      const auto ensemble = run_ensemble(models, c);
      for (int k = 0; k < count; ++k) {
        SCOPED_TRACE(std::string(v.name) + " " + c.name + " member " + std::to_string(k));
        ASSERT_EQ(ensemble->status(k), MemberStatus::finished) << ensemble->error(k);
        const auto& model = models[static_cast<std::size_t>(k)];
        const auto alone = simulate(model, c);
        while (!alone->finished()) alone->step(100);
        auto& member = ensemble->member(k);
        EXPECT_NEAR(member.report().stable_step, alone->report().stable_step,
                    2e-3 * alone->report().stable_step);
        const auto u = alone->displacement();
        EXPECT_GT(largest(u), 1e-5);
        EXPECT_LT(distance(u, member.displacement()), (c.rounding() + 1e-6) * largest(u));
        EXPECT_NEAR(member.energies().strain, alone->energies().strain, 1e-3 * alone->energies().strain);
        EXPECT_NEAR(member.energies().external, alone->energies().external,
                    1e-3 * std::abs(alone->energies().external) + 1e-12);
      }
    }
}

TEST(Ensemble, AnyNumberOfMembersAndThreadsGivesTheSameBits) {
  const Variant& v = variants[1];
  const auto reference = run_ensemble(member_models(v, 33), threads_float, 1);
  for (const int count : {1, 3, 17, 33})
    for (const int threads : {1, 2, 3}) {
      const auto ensemble = run_ensemble(member_models(v, count), threads_float, threads);
      for (int k = 0; k < count; ++k)
        ASSERT_TRUE(same_bits(ensemble->member(k), reference->member(k))) << k << " of " << count;
    }
}

TEST(Ensemble, StepsAtOnceOrOneByOneAreTheSame) {
  const auto reference = run_ensemble(member_models(variants[3], 4), threads_float);
  SimulationOptions options;
  auto ensemble = make_ensemble(member_models(variants[3], 4), options);
  ensemble->step(3);
  EXPECT_EQ(ensemble->member(2).step_count(), 3);
  ensemble->member(1).velocity();  // forces between two steps disturb nobody
  ensemble->member(2).internal_force();
  ensemble->step(100000);
  for (int k = 0; k < 4; ++k) EXPECT_TRUE(same_bits(ensemble->member(k), reference->member(k)));
}

TEST(Ensemble, AFailedMemberHarmsNoOther) {
  for (const Case& c : {threads_float, serial_double}) {
    auto models = member_models(variants[0], 6);
    const auto healthy = run_ensemble(models, c);
    models[2].time.step = 40 * healthy->member(2).report().stable_step;
    models[2].time.total = 1;
    const auto ensemble = run_ensemble(models, c);
    for (int k = 0; k < 6; ++k) {
      EXPECT_EQ(ensemble->status(k), k == 2 ? MemberStatus::failed : MemberStatus::finished);
      EXPECT_EQ(ensemble->error(k).empty(), k != 2);
      if (k != 2) {
        EXPECT_TRUE(same_bits(ensemble->member(k), healthy->member(k)));
      }
    }
    EXPECT_NE(ensemble->error(2).find("above the stable step"), std::string::npos) << ensemble->error(2);
  }
}

TEST(Ensemble, QuasiStaticMembersConverge) {
  std::vector<Model> models;
  for (int k = 0; k < 3; ++k) {
    Model model = member_model(variants[0], k);
    model.time = relaxed(1e-4, 1e-5);
    models.push_back(model);
  }
  const auto ensemble = run_ensemble(models, threads_float);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(ensemble->member(k).report().ending, "converged");
    const auto u = final_displacement(models[static_cast<std::size_t>(k)], serial_double);
    EXPECT_LT(distance(u, ensemble->member(k).displacement()), 2e-3 * largest(u));
  }
}

TEST(Ensemble, MembersWithOtherLawsGetGroupsOfTheirOwn) {
  std::vector<Model> models{member_model(variants[0], 1), member_model(variants[2], 2),
                            member_model(variants[0], 3)};
  const auto ensemble = run_ensemble(models, threads_float);
  for (int k = 0; k < 3; ++k) {
    const auto u = final_displacement(models[static_cast<std::size_t>(k)], threads_float);
    EXPECT_LT(distance(u, ensemble->member(k).displacement()), 2e-5 * largest(u));
  }
}

TEST(Ensemble, LargeMeshesRunOneAfterAnotherOnAllThreads) {
  std::vector<Model> models;
  for (int k = 0; k < 2; ++k) {
    models.push_back(box_model({20, 20, 20}, {0.1, 0.1, 0.1}, Formulation::h8, {"NH", {1000, 5000}}));
    models.back().gravity = {{{}, {0, 0, -9.81 * (1 + k)}, step_curve(1)}};
    models.back().fixed = {{face(models.back().mesh, 2, 0)}};
    models.back().time.total = 1;
  }
  const auto ensemble = make_ensemble(models);
  EXPECT_NE(ensemble->device().find("single runs"), std::string::npos) << ensemble->device();
  ensemble->step(2);
  for (int k = 0; k < 2; ++k) {
    const auto alone = simulate(models[static_cast<std::size_t>(k)], threads_float);
    alone->step(2);
    EXPECT_TRUE(same_bits(ensemble->member(k), *alone));
  }
}

TEST(Ensemble, RefusesWhatItCannotDo) {
  EXPECT_THROW(make_ensemble({}), Error);
  auto models = member_models(variants[0], 2);
  models[1].mesh.X[0].x += 1e-4;
  EXPECT_THROW(make_ensemble(models), Error);
  SimulationOptions options;
  options.device = "cuda";
  EXPECT_THROW(make_ensemble(member_models(variants[0], 1), options), Error);
}

}  // namespace
}  // namespace glisson::test
