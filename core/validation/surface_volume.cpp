// Closed parts of rigid surfaces: front and back must lie apart.
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/core/validation/checks.hpp>

#include <cmath>

namespace glisson::detail {
namespace {

/// Thickness over the height of the highest facet. So far behind a facet a run still takes a node for one
/// that rests on it (the slack of SurfaceShape): what lets go of the back of a thinner body is held by its
/// front.
constexpr double thinnest = 1e-3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double length_of(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

/// Volume over half of the area: the thickness of a plate, 2/3 of the radius of a ball [m].
double mean_thickness(const SurfacePart& part, const std::vector<Triangle>& triangles,
                      const std::vector<Vec3<double>>& X) {
  double volume = 0, area = 0;  // the volume is negative where the facets face inwards, as around a cavity
  const Vec3<double> base = X[at(triangles[part.triangles[0]][0])];  // on the part: fewer digits are lost
  for (const std::size_t t : part.triangles) {
    const auto &a = X[at(triangles[t][0])], &b = X[at(triangles[t][1])], &c = X[at(triangles[t][2])];
    const Vec3<double> across = cross(b - a, c - a);
    volume += dot(a - base, across) / 6;
    area += length_of(across) / 2;
  }
  return 2 * std::abs(volume) / area;
}

}  // namespace

void check_volumes(const RigidSurface& surface, const std::string& where) {
  const std::vector<Vec3<double>>& X = surface.surface.X;
  std::vector<Triangle> triangles;
  std::vector<std::size_t> facet;  // of each triangle
  for (std::size_t f = 0; f < surface.surface.facets.size(); ++f) {
    append_triangles(surface.surface.facets[f], X, triangles);
    facet.resize(triangles.size(), f);
  }
  const double height = triangle_sizes(triangles, X).largest;
  for (const SurfacePart& part : connected_parts(triangles)) {
    if (!part.closed) continue;
    const double thickness = mean_thickness(part, triangles, X);
    if (thickness > thinnest * height) continue;
    const std::size_t f = facet[part.triangles[0]];
    throw Error(
        ErrorKind::input,
        "the closed part with facet " + std::to_string(f) + " has hardly any volume: it is " +
            number_text(thickness) + " thick, and the surface has facets " + number_text(height) +
            " high, so its front cannot be told from its back. Take one side of it as an open surface, "
            "which nodes stay in front of, or make it thicker than a thousandth of these facets",
        {surface.file, f < surface.facet_lines.size() ? surface.facet_lines[f] : 0, where});
  }
}

}  // namespace glisson::detail
