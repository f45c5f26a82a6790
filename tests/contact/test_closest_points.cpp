// Closest points against exact integer arithmetic, degenerate features included.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include <glisson/contact/geometry/closest_points.hpp>

namespace glisson::contact {
namespace {

__extension__ using Wide = __int128;
/// Coordinates are integers of at most 15 bits, so that every number below is exact.
using Point = Vec3<Wide>;

/// num / den, the only rounding of the reference: 64 bits.
long double ratio(Wide num, Wide den) {
  return static_cast<long double>(num) / static_cast<long double>(den);
}
long double to_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a, w = p - a;
  const Wide length = dot(d, d), along = dot(w, d);
  if (length == 0 || along <= 0) return ratio(dot(w, w), 1);
  if (along >= length) return ratio(dot(p - b, p - b), 1);
  return ratio(dot(cross(w, d), cross(w, d)), length);
}
/// Squared distance of a point and a triangle.
long double to_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point n = cross(b - a, c - a);
  const auto left = [&](const Point& u, const Point& v) { return dot(cross(v - u, p - u), n) >= 0; };
  if (dot(n, n) > 0 && left(a, b) && left(b, c) && left(c, a)) {
    const Wide height = dot(p - a, n);
    return ratio(height, 1) * ratio(height, dot(n, n));
  }
  return std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
}
long double of_segments(const Point& p, const Point& p1, const Point& q, const Point& q1) {
  const Point d = p1 - p, e = q1 - q, w = q - p, n = cross(d, e);
  const Wide area = dot(n, n), s = dot(cross(w, e), n), t = dot(cross(w, d), n);
  if (area > 0 && s >= 0 && s <= area && t >= 0 && t <= area) {
    const Wide height = dot(w, n);
    return ratio(height, 1) * ratio(height, area);
  }
  return std::min({to_segment(p, q, q1), to_segment(p1, q, q1), to_segment(q, p, p1), to_segment(q1, p, p1)});
}

template <class R>
Vec3<R> rounded(const Point& a) {
  return {R(a.x), R(a.y), R(a.z)};
}

/// Four points; few distinct coordinates make coincident points, collinear and parallel edges common.
struct Draw {
  std::mt19937 random{7};
  std::array<Point, 4> operator()(int range, int stretch) {
    std::uniform_int_distribution<int> place(-range, range);
    std::array<Point, 4> result;
    for (auto& p : result) p = {place(random) * stretch, place(random), place(random)};
    return result;
  }
};
constexpr std::array<std::array<int, 2>, 5> kinds{{{1, 1}, {2, 1}, {9, 1}, {2, 3000}, {8000, 1}}};

/// Rounding of a squared distance of points of this extent.
template <class R>
long double tolerance(const std::array<Point, 4>& x) {
  long double extent = 0;
  for (const auto& p : x) extent = std::max(extent, ratio(dot(p - x[0], p - x[0]), 1));
  return 64 * static_cast<long double>(std::numeric_limits<R>::epsilon()) * extent;
}

template <class R>
struct ClosestPoints : ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ClosestPoints, Reals);

/// found = closest(four points rounded to R) against exact(the points), and what else check(found) wants.
template <class R, class Closest, class Exact, class Check>
void compare(Closest closest, Exact exact, Check check) {
  Draw draw;
  for (const auto& [range, stretch] : kinds)
    for (int i = 0; i < 40000; ++i) {
      const auto x = draw(range, stretch);
      const auto found = closest(rounded<R>(x[0]), rounded<R>(x[1]), rounded<R>(x[2]), rounded<R>(x[3]));
      ASSERT_NEAR(static_cast<long double>(found.distance_squared), exact(x[0], x[1], x[2], x[3]),
                  tolerance<R>(x))
          << range << " " << stretch << " case " << i;
      ASSERT_NO_FATAL_FAILURE(check(found));
    }
}

TYPED_TEST(ClosestPoints, OnATriangleAsInExactArithmetic) {
  using R = TypeParam;
  constexpr R rounding = 4 * std::numeric_limits<R>::epsilon();
  compare<R>([](const auto&... x) { return closest_on_triangle(x...); }, to_triangle,
             [](const auto& found) {
               for (const R b : found.b) ASSERT_GE(b, -rounding);
               ASSERT_NEAR(found.b[0] + found.b[1] + found.b[2], 1, rounding);
             });
}

TYPED_TEST(ClosestPoints, OfSegmentsAsInExactArithmetic) {
  compare<TypeParam>(
      [](const auto&... x) { return closest_of_segments(x...); }, of_segments,
      [](const auto& found) { ASSERT_TRUE(found.s >= 0 && found.s <= 1 && found.t >= 0 && found.t <= 1); });
}

/// A point and two directions; those of a needle, of one line and of a point among them.
struct Fan {
  Point a, d, e;
};
Fan fan(std::mt19937& random, int kind) {
  std::uniform_int_distribution<int> place(-1200, 1200), one(-1, 1);
  const auto point = [&] { return Point{place(random), place(random), place(random)}; };
  const Point a = point(), d = kind == 3 ? Point{} : point(), aside{one(random), one(random), one(random)};
  return {a, d, kind == 0 ? point() : kind == 1 ? d + aside : d};
}
template <class R>
R length(const Point& a) {
  return R(std::sqrt(ratio(dot(a, a), 1)));
}

/// Inverse of the sine between two directions, 1 where there is none: rounding grows by it.
template <class R>
R sharpness(const Point& d, const Point& e) {
  const R across = length<R>(cross(d, e));
  return across > 0 ? length<R>(d) * length<R>(e) / across : 1;
}

/// Points on corners, on edges and inside: their distance is rounding, not the square root of it.
TYPED_TEST(ClosestPoints, WhatLiesOnATriangleIsAtNoDistance) {
  using R = TypeParam;
  std::mt19937 random(13);
  std::uniform_int_distribution<int> share(0, 12);
  for (int i = 0; i < 40000; ++i) {
    const auto [a, d, e] = fan(random, i % 4);
    const int u = share(random), v = i % 3 ? 12 - u : std::min(share(random), 12 - u);
    const Point p = a + Wide(u) * d + Wide(v) * e, b = a + Wide(12) * d, c = a + Wide(12) * e;
    const auto found = closest_on_triangle(rounded<R>(p), rounded<R>(a), rounded<R>(b), rounded<R>(c));
    const R extent = length<R>(b - a) + length<R>(c - a);
    const R rounding = 8 * std::numeric_limits<R>::epsilon() * sharpness<R>(d, e);
    ASSERT_LE(std::sqrt(found.distance_squared), rounding * extent) << i;
  }
}

/// Edges that cross, share an end, lie on each other or end on each other.
TYPED_TEST(ClosestPoints, EdgesThatMeetAreAtNoDistance) {
  using R = TypeParam;
  std::mt19937 random(19);
  std::uniform_int_distribution<int> share(0, 12);
  for (int i = 0; i < 40000; ++i) {
    const auto [m, d, e] = fan(random, i % 4);
    const Point p = m - Wide(share(random)) * d, q = m - Wide(share(random)) * e;  // both go through m
    const Point p1 = p + Wide(12) * d, q1 = q + Wide(12) * e;
    const auto found = closest_of_segments(rounded<R>(p), rounded<R>(p1), rounded<R>(q), rounded<R>(q1));
    const R extent = length<R>(p1 - p) + length<R>(q1 - q);
    const R rounding = 8 * std::numeric_limits<R>::epsilon() * sharpness<R>(d, e);
    ASSERT_LE(std::sqrt(found.distance_squared), rounding * extent) << i;
  }
}

TEST(ClosestPointsCases, GiveTheWeightsOfTheFeature) {
  const Vec3<double> a{0, 0, 0}, b{2, 0, 0}, c{0, 2, 0};
  const auto inside = closest_on_triangle(Vec3<double>{0.5, 0.5, 3}, a, b, c);
  EXPECT_EQ(inside.b[0], 0.5);
  EXPECT_EQ(inside.b[1], 0.25);
  EXPECT_EQ(inside.distance_squared, 9);
  const auto corner = closest_on_triangle(Vec3<double>{3, -1, 0}, a, b, c);
  EXPECT_EQ(corner.b[1], 1);
  EXPECT_EQ(corner.distance_squared, 2);
  const auto edge = closest_on_triangle(Vec3<double>{2, 2, 1}, a, b, c);
  EXPECT_EQ(edge.b[0], 0);
  EXPECT_EQ(edge.b[1], 0.5);
  EXPECT_EQ(edge.distance_squared, 3);
}

TEST(ClosestPointsCases, FeaturesOfNoExtentArePoints) {
  const Vec3<double> a{1, 2, 3}, p{1, 2, 5}, q{4, 2, 3};
  EXPECT_EQ(closest_on_triangle(p, a, a, a).distance_squared, 4);
  EXPECT_EQ(closest_of_segments(p, p, a, a).distance_squared, 4);
  EXPECT_EQ(closest_of_segments(a, q, p, p).distance_squared, 4);
  EXPECT_EQ(closest_of_segments(a, q, a, q).distance_squared, 0);
}

}  // namespace
}  // namespace glisson::contact
