// Patches in shared memory, run phase by phase on the emulated device, against the plain double reference.
#include <algorithm>
#include <cstring>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include <glisson/core/base/error.hpp>
#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/solids/plain_solids.hpp>
#include <glisson/core/solids/staged_solids.hpp>
#include <glisson/cpu/emulated_device.hpp>
#include <glisson/cpu/serial.hpp>
#include <tests/cpu/mixed_models.hpp>
#include <tests/support/inner_forces.hpp>

namespace glisson {
namespace {

template <class B, class R>
struct Solids : test::InnerForces<B, R> {
  Solids(B backend, const Model& model, bool staged)
      : test::InnerForces<B, R>(std::move(backend), model,
                                staged ? make_staged_solids<B, R> : make_plain_solids<B, R>,
                                {displacement, {1, 2, 3}}) {}
};

template <class R>
double difference(const std::vector<Vec4<R>>& a, const std::vector<Vec4<double>>& b) {
  return test::difference(a, b, {1, 2, 3});
}

/// Over which the forces of a test are compared: rounding of R, amplified by kappa / mu = 10 and by sums of
/// opposing element forces on top of the 1, 2, 3 that were there.
template <class R>
constexpr double rounding() {
  return sizeof(R) == 4 ? 2e-5 : 1e-13;
}

using Case = std::tuple<Formulation, const char*, bool>;
class StagedForms : public testing::TestWithParam<Case> {
 protected:
  template <class R>
  void compare(const Model& model) {
    Solids<EmulatedDevice, R> staged(EmulatedDevice(), model, true);
    Solids<Serial, double> plain({}, model, false);
    for (const double scale : {1.0, 0.7}) {
      EXPECT_LT(difference(staged.forces(scale), plain.forces(scale)), rounding<R>());
      const double strain = plain.strain_energy(scale), hourglass = plain.hourglass_energy(scale);
      EXPECT_NEAR(staged.strain_energy(scale), strain, 0.1 * rounding<R>() * strain);
      EXPECT_NEAR(staged.hourglass_energy(scale), hourglass, rounding<R>() * hourglass);
    }
    const auto history = staged.get().history(), expected = plain.get().history();
    ASSERT_EQ(history.size(), expected.size());
    const double largest = expected.empty() ? 0 : *std::max_element(expected.begin(), expected.end());
    for (std::size_t i = 0; i < history.size(); ++i)
      ASSERT_NEAR(history[i], expected[i], rounding<R>() * largest);
  }
};

TEST_P(StagedForms, AgreeWithTheReference) {
  const auto [formulation, law, viscous] = GetParam();
  const Model model = mixed_model(formulation, law, viscous);
  compare<float>(model);
  compare<double>(model);
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Formulation f :
       {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_fixed, Formulation::h8_full})
    for (const char* law : {"LE", "NH", "AB", "PY", "TI", "OG"})
      for (const bool viscous : {false, true}) cases.emplace_back(f, law, viscous);
  return cases;
}
INSTANTIATE_TEST_SUITE_P(All, StagedForms, testing::ValuesIn(all_cases()), [](const auto& its) {
  return std::string(name_of(std::get<0>(its.param))) + "_" + std::get<1>(its.param) +
         (std::get<2>(its.param) ? "_viscous" : "");
});

/// Tetrahedra of both formulations share nodes, so that slots of pressure stay empty in some patches.
Model both_tetrahedra() {
  Model model = mixed_model(Formulation::t4, "NH", false, {9, 8, 7});
  model.sections[1].formulation = Formulation::t4anp;
  return model;
}

TEST(StagedSolidsBlocks, OfBothTetrahedraShareNodes) {
  const Model model = both_tetrahedra();
  Solids<EmulatedDevice, double> staged(EmulatedDevice(), model, true);
  Solids<Serial, double> plain({}, model, false);
  EXPECT_LT(difference(staged.forces(1), plain.forces(1)), rounding<double>());
}

/// What the sweep over the nodes adds is what add_forces() would have added, bit for bit.
TEST(StagedSolidsBlocks, MayLeaveTheSharedForces) {
  const Model model = both_tetrahedra();
  Solids<EmulatedDevice, float> whole(EmulatedDevice(), model, true), parts(EmulatedDevice(), model, true);
  const auto expected = whole.forces(1), f = parts.forces_with_left(1);
  EXPECT_EQ(std::memcmp(f.data(), expected.data(), f.size() * sizeof f[0]), 0);
}

TEST(StagedSolidsBits, DoNotDependOnTheOrderOfThreads) {
  const Model model = both_tetrahedra();
  Solids<EmulatedDevice, float> first(EmulatedDevice(1), model, true);
  const auto expected = first.forces(1);
  const double energy = first.strain_energy(1);
  for (const std::uint64_t seed : {2, 3, 4}) {
    Solids<EmulatedDevice, float> other(EmulatedDevice(seed), model, true);
    const auto f = other.forces(1);
    EXPECT_EQ(std::memcmp(f.data(), expected.data(), f.size() * sizeof f[0]), 0);
    EXPECT_EQ(other.strain_energy(1), energy);
  }
}

TEST(StagedSolidsState, EvaluationAloneLeavesTheHistory) {
  const Model model = mixed_model(Formulation::h8, "NH", true);
  Solids<EmulatedDevice, float> staged(EmulatedDevice(), model, true);
  staged.forces(1);
  const auto history = staged.get().history();
  staged.forces(1, false);
  EXPECT_EQ(staged.get().history(), history);
  Solids<EmulatedDevice, float> other(EmulatedDevice(), model, true);
  other.get().set_history(history);
  EXPECT_EQ(other.get().history(), history);
  EXPECT_THROW(other.get().set_history({1, 2, 3}), Error);
}

std::size_t constant_bytes(Formulation formulation) {
  if (shape_of(formulation) == Shape::tetrahedron) return sizeof(T4::Constants<float>);
  return formulation == Formulation::h8_full ? sizeof(H8Full::Constants<float>)
                                             : sizeof(H8::Constants<float>);
}

/// Elements in random order: their nodes are all over the mesh, and the limit on nodes cuts the patches.
std::vector<HostBlock<float>> scattered_blocks(const Model& model) {
  Numbering numbering = make_numbering(model.mesh);
  std::shuffle(numbering.element_order.begin(), numbering.element_order.end(), std::mt19937(3));
  return make_host_blocks<float>(model, numbering);
}

TEST(HostPatches, HoldEveryElementAndNodeOnce) {
  const Model model = mixed_model(Formulation::t4, "NH", false, {14, 13, 12});
  const auto blocks = scattered_blocks(model);
  const PatchCut cut = cut_into_patches(blocks, model.mesh.node_count());
  ASSERT_EQ(cut.blocks.size(), 1u);
  const HostPatches& patches = cut.blocks[0];
  EXPECT_EQ(patches.element_begin.back(), blocks[0].element_count);
  EXPECT_EQ(patches.row.size(), blocks[0].nodes.size());
  EXPECT_LE(patches.largest_node_count, patch_node_limit);
  EXPECT_GT(patches.largest_node_count, patch_node_limit - 4);
  std::vector<int> slots(at(cut.shared.slot_count()), 0);
  for (int p = 0; p < patches.patch_count(); ++p) {
    const int first = patches.node_begin[at(p)];
    ASSERT_LE(patches.element_begin[at(p) + 1] - patches.element_begin[at(p)], 256);
    for (int e = patches.element_begin[at(p)]; e < patches.element_begin[at(p) + 1]; ++e)
      for (int a = 0; a < 4; ++a) {
        const int place = first + patches.corner[at(a * blocks[0].element_count + e)];
        ASSERT_EQ(patches.node[at(place)], blocks[0].nodes[at(4 * e + a)]);
      }
    for (int i = first; i < patches.node_begin[at(p) + 1]; ++i) {
      const int s = patches.shared[at(i)], slot = patches.slot[at(i)];
      ASSERT_EQ(s >= 0, i - first >= patches.interior_count[at(p)]);
      ASSERT_EQ(s, cut.shared.shared_of_node[at(patches.node[at(i)])]);
      if (s < 0) continue;
      ASSERT_GE(slot, cut.shared.begin[at(s)]);
      ASSERT_LT(slot, cut.shared.begin[at(s) + 1]);
      ++slots[at(slot)];
    }
  }
  for (const int uses : slots) ASSERT_EQ(uses, 1);
}

/// A device needs the constants of no element but H8Full on its host.
TEST(HostBlocks, LeaveOutConstantsThatAreFormedAnew) {
  for (const auto formulation :
       {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_fixed, Formulation::h8_full}) {
    const Model model = mixed_model(formulation, "NH", false, {3, 3, 3});
    const Numbering numbering = make_numbering(model.mesh);
    const auto all = make_host_blocks<float>(model, numbering);
    const auto some = make_host_blocks<float>(model, numbering, StoredConstants::not_formed_anew);
    ASSERT_EQ(some.size(), all.size());
    for (std::size_t b = 0; b < all.size(); ++b) {
      EXPECT_EQ(all[b].constants.size(), at(all[b].element_count) * constant_bytes(all[b].formulation));
      EXPECT_EQ(some[b].constants.size(),
                all[b].formulation == Formulation::h8_full ? all[b].constants.size() : 0);
      EXPECT_EQ(some[b].volumes, all[b].volumes);
      EXPECT_EQ(some[b].hourglass, all[b].hourglass);
      EXPECT_EQ(some[b].nodes, all[b].nodes);
    }
  }
}

TEST(HostPatches, FitTheMemoryThatEveryDeviceGivesABlock) {
  EXPECT_LE(PatchMemory<double>::size(patch_node_limit) * sizeof(double), 48u << 10);
  EXPECT_GT(PatchMemory<double>::size(patch_node_limit + 32) * sizeof(double), 48u << 10);
}

TEST(HostPatches, OfNothing) {
  const PatchCut cut = cut_into_patches(std::vector<HostBlock<float>>(1), 0);
  EXPECT_EQ(cut.blocks[0].patch_count(), 0);
  EXPECT_EQ(cut.shared.count(), 0);
}

}  // namespace
}  // namespace glisson
