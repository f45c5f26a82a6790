// Triangle surfaces for tests.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include <glisson/contact/geometry/triangles.hpp>

namespace glisson::contact {

struct TriangleSurface {
  std::vector<Vec3<double>> x;
  std::vector<Triangle> triangles;
};

inline void append(TriangleSurface& to, const TriangleSurface& from) {
  const int first = static_cast<int>(to.x.size());
  to.x.insert(to.x.end(), from.x.begin(), from.x.end());
  for (const Triangle& t : from.triangles) to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Latitude-longitude sphere, outward, with 2 slices (rings - 1) triangles.
inline TriangleSurface sphere(Vec3<double> centre, double radius, int rings, int slices) {
  constexpr double pi = 3.14159265358979323846;
  TriangleSurface s;
  s.x.push_back(centre + Vec3<double>{0, 0, radius});
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < slices; ++j) {
      const double a = pi * i / rings, b = 2 * pi * j / slices;
      s.x.push_back(centre +
                    radius * Vec3<double>{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    }
  s.x.push_back(centre - Vec3<double>{0, 0, radius});
  const auto at = [&](int i, int j) { return 1 + (i - 1) * slices + j % slices; };
  const int south = static_cast<int>(s.x.size()) - 1;
  for (int j = 0; j < slices; ++j) {
    s.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i + 1 < rings; ++i) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    s.triangles.push_back({at(rings - 1, j), south, at(rings - 1, j + 1)});
  }
  return s;
}

/// Strip of 2 n triangles along x of length 1, rolled to a circular arc of this angle (0: flat).
inline TriangleSurface rolled_strip(int n, double angle) {
  TriangleSurface s;
  for (int i = 0; i <= n; ++i)
    for (const double y : {0.0, 0.05}) {
      const double t = double(i) / n, a = angle * t, r = angle > 0 ? 1 / angle : 0;
      s.x.push_back(angle > 0 ? Vec3<double>{r * std::sin(a), y, r * (1 - std::cos(a))}
                              : Vec3<double>{t, y, 0});
    }
  for (int i = 0; i < n; ++i) {
    s.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    s.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  return s;
}

/// Loose triangles, small patches, facets without area and repeated nodes.
inline TriangleSurface random_soup(std::mt19937& random, int nodes, int triangles) {
  std::uniform_real_distribution<double> place(0, 1);
  std::uniform_int_distribution<int> node(0, nodes - 1);
  TriangleSurface s;
  for (int n = 0; n < nodes; ++n) s.x.push_back({place(random), place(random), place(random)});
  for (int t = 0; t < triangles; ++t) s.triangles.push_back({node(random), node(random), node(random)});
  return s;
}

}  // namespace glisson::contact
