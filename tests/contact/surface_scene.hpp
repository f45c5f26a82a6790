// Free nodes and a rigid surface.
#pragma once

#include <cmath>

#include "tests/contact/free_nodes.hpp"
#include "tests/contact/surfaces.hpp"

namespace glisson::contact {

inline RigidSurface surface_of(const TriangleSurface& s) {
  RigidSurface surface;
  surface.name = "test surface";
  surface.surface.X = s.x;
  for (const Triangle& t : s.triangles) surface.surface.facets.push_back({{t[0], t[1], t[2], -1}});
  return surface;
}
/// Square [0, 4]^2 at z = 0 of 2 n^2 triangles, front along +z, turned about y by this angle.
inline RigidSurface floor_of(int n = 4, double slope = 0) {
  TriangleSurface s;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = 4.0 * i / n, y = 4.0 * j / n;
      s.x.push_back({x * std::cos(slope), y, -x * std::sin(slope)});
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      s.triangles.push_back({a, b, b + 1});
      s.triangles.push_back({a, b + 1, a + 1});
    }
  return surface_of(s);
}
inline Model model_of(std::vector<Vec3<double>> X, RigidSurface surface) {
  Model model;
  model.mesh.X = std::move(X);
  for (int n = 0; n < model.mesh.node_count(); ++n) surface.nodes.push_back(n);
  model.surfaces = {std::move(surface)};
  return model;
}

struct SurfaceScene : FreeNodes {
  SurfaceScene(BenchCase row, std::vector<Vec3<double>> X, RigidSurface surface, double mass = 1)
      : FreeNodes(row, model_of(std::move(X), std::move(surface)), mass) {}
};

}  // namespace glisson::contact
