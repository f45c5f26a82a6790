// The broad phase of devices against that of the host, on the emulated device.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include <glisson/contact/bvh/device_search.hpp>
#include <glisson/contact/bvh/pair_search.hpp>
#include <glisson/cpu/emulated_device.hpp>
#include <glisson/cpu/serial.hpp>
#include <tests/contact/surfaces.hpp>

namespace glisson::contact {
namespace {

struct Scene {
  TriangleSurface surface;
  std::vector<int> region;
  int regions = 0;
  void add(const TriangleSurface& part) {
    append(surface, part);
    region.resize(surface.triangles.size(), regions++);
  }
};

Vec3<double> random_vector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> of(-size, size);
  return {of(random), of(random), of(random)};
}

/// Spheres that overlap and rolled strips whose ends meet.
Scene random_scene(unsigned seed) {
  std::mt19937 random(seed);
  Scene scene;
  for (int k = 0; k < 3; ++k) scene.add(sphere(random_vector(random, 1), 0.7, 6 + k, 9));
  scene.add(rolled_strip(40, 3 + 0.5 * seed));
  return scene;
}

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

using MayTouch = bool(int, int);
bool all(int, int) { return true; }
bool others(int a, int b) { return a != b; }
bool some(int a, int b) { return a + b != 2; }

template <class B>
void expect_the_pairs_of_the_host(double threshold, MayTouch* may) {
  std::size_t seen = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Scene scene = random_scene(seed);
    HierarchySettings settings;
    settings.arity = seed % 2 ? 4 : 2;
    Hierarchy h = build_hierarchy(scene.surface.triangles, scene.surface.x, settings);
    PairSearch host(h, scene.region, may);
    B backend;
    DeviceSearch<B> device(backend, h, scene.surface.triangles, {scene.region, scene.regions, may});
    std::mt19937 random(seed);
    for (const double motion : {0.0, 0.05, 0.2}) {  // the same search follows the surface
      auto x = scene.surface.x;
      for (auto& p : x) p = p + random_vector(random, motion);
      h.settings.margin = 0.03;
      refit(h, scene.surface.triangles, x);
      Pairs expected, found;
      host.find(h, threshold, {}, expected);
      device.find(x, 0.03, threshold, found);
      ASSERT_EQ(sorted(found), sorted(expected)) << "scene " << seed << ", motion " << motion;
      seen += found.size();
    }
  }
  EXPECT_GT(seen, 1000u);
}

constexpr double below_half_turn = 0.9 * full_turn / 2;

TEST(DeviceSearchPairs, AreThoseOfTheHost) {
  expect_the_pairs_of_the_host<EmulatedDevice>(below_half_turn, all);
  expect_the_pairs_of_the_host<Serial>(below_half_turn, all);
}
TEST(DeviceSearchPairs, WithoutSelfContactTooAndWithEveryPairSearched) {
  expect_the_pairs_of_the_host<EmulatedDevice>(full_turn, others);
  expect_the_pairs_of_the_host<EmulatedDevice>(0, some);
}

TEST(DeviceSearchPairs, HaveOneOrderWhateverTheOrderOfThreads) {
  const Scene scene = random_scene(3);
  const Hierarchy h = build_hierarchy(scene.surface.triangles, scene.surface.x, {});
  Pairs first, second;
  for (auto [seed, pairs] : {std::pair{1u, &first}, std::pair{2u, &second}}) {
    EmulatedDevice device(seed);
    DeviceSearch<EmulatedDevice>(device, h, scene.surface.triangles, {scene.region, scene.regions, all})
        .find(scene.surface.x, 0.05, below_half_turn, *pairs);
  }
  EXPECT_EQ(first, second);
  EXPECT_FALSE(first.empty());
}

TEST(DeviceSearchPairs, OfNoTrianglesAreNone) {
  EmulatedDevice device;
  const Hierarchy h = build_hierarchy({}, {}, {});
  DeviceSearch<EmulatedDevice> search(device, h, {}, {});
  Pairs found{{1, 2}};
  search.find({}, 0.1, 0, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace glisson::contact
