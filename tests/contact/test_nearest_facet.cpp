// The nearest of a node's candidate facets against a plain loop over all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <glisson/contact/deformable/nearest_facet.hpp>

namespace glisson::contact {
namespace {

/// A fan of triangles around points near the origin, and others farther off; the point is the last one.
struct Scene {
  std::vector<Vec4<float>> to;
  std::vector<Corners> triangles;
  std::vector<int> facets;
  std::vector<float> bias;

  SurfaceView<float> view() {
    SurfaceView<float> view{};
    view.triangles = triangles.data();
    view.to = to.data();
    return view;
  }
};

Scene scene_of(std::mt19937& random) {
  std::uniform_real_distribution<float> at(-1, 1);
  std::uniform_int_distribution<int> count(1, 40), kind(0, 3);
  Scene s;
  const float height = kind(random) ? 0.01f * at(random) : 0;
  const auto add = [&](float x, float y, float z) {
    s.to.push_back({x, y, z, 0});
    return int(s.to.size()) - 1;
  };
  const int fan = count(random) / 2 + 1, centre = add(0, 0, 0);
  for (int i = 0; i < fan; ++i) {
    const float a = 6.2831853f * float(i) / float(fan), b = 6.2831853f * float(i + 1) / float(fan);
    const int p = add(std::cos(a), std::sin(a), height), q = add(std::cos(b), std::sin(b), height);
    s.triangles.push_back({{centre, p, q}});
  }
  for (int i = count(random); i > 0; --i) {
    const int p = add(at(random), at(random), at(random));
    s.triangles.push_back({{p, add(at(random), at(random), at(random)), kind(random) ? centre : p}});
  }
  for (int f = 0; f < int(s.triangles.size()); ++f) s.facets.push_back(f);
  std::shuffle(s.facets.begin(), s.facets.end(), random);
  for (std::size_t i = 0; i < s.facets.size(); ++i)
    s.bias.push_back(kind(random) ? 0 : 0.05f * (1 + at(random)));
  const float off = kind(random) ? 0.01f : 0;
  s.to.push_back({off * at(random), off * at(random), kind(random) ? 0.1f * at(random) : 0, 0});
  return s;
}

struct Answer {
  int place = -1;
  float away = 0;
  Vec3<float> normal;
  bool operator==(const Answer& o) const {
    return place == o.place && away == o.away && normal.x == o.normal.x && normal.y == o.normal.y &&
           normal.z == o.normal.z;
  }
};

constexpr float reach = 0.4f, slack = 0.02f;

/// Every facet in turn, without boxes, packs or lists of what was near.
Answer plain(const FacetsNear<float>& group) {
  Answer answer;
  float best = 2 * reach;
  for (int i = 0; i < group.count; ++i) {
    const float d = std::sqrt(group.foot(i).distance_squared);
    if (!(d < reach && d + group.bias[i] < best)) continue;
    best = answer.away = d + group.bias[i];
    answer.place = i;
  }
  Vec3<float> sum;
  for (int i = 0; i < group.count && answer.place >= 0; ++i) {
    const float away = std::sqrt(group.foot(i).distance_squared) + group.bias[i];
    const float weight = 1 - (away - answer.away) / slack;
    if (weight > 0) sum = sum + weight * group.normal(i);
  }
  answer.normal = unit_or(sum, Vec3<float>{});
  return answer;
}

/// L: a pack, as hosts look at facets, or one number, as devices do.
template <class L>
void expect_that_of_a_plain_loop() {
  std::mt19937 random(41);
  int near = 0, crowded = 0;
  for (int i = 0; i < 20000; ++i) {
    Scene scene = scene_of(random);
    const SurfaceView<float> view = scene.view();
    const FacetsNear<float> group{view, xyz(scene.to.back()), scene.facets.data(), scene.bias.data(),
                                  int(scene.facets.size())};
    const Answer expected = plain(group);
    near += expected.place >= 0;
    NearestFacet<float, L> nearest;
    nearest.find(group, reach, slack);
    crowded += !nearest.complete;
    const Vec3<float> normal = nearest.place < 0 ? Vec3<float>{} : mean_normal(group, nearest, slack);
    ASSERT_TRUE((Answer{nearest.place, nearest.away, normal}) == expected)
        << "scene " << i << ": " << nearest.place << " " << expected.place;
  }
  EXPECT_GT(near, 8000);
  EXPECT_GT(crowded, 100) << "no scene had more facets than are kept";
}
TEST(NearestFacet, IsThatOfAPlainLoop) { expect_that_of_a_plain_loop<Lanes<float>>(); }
TEST(NearestFacet, OfWidePacksIsThatOfAPlainLoop) { expect_that_of_a_plain_loop<Lanes<float, 8>>(); }
TEST(NearestFacet, OneByOneIsThatOfAPlainLoop) { expect_that_of_a_plain_loop<float>(); }

}  // namespace
}  // namespace glisson::contact
