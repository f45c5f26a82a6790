// A model's rigid surface in double: its tree and facets in the surface's own frame, and where it is at a
// time.
#pragma once

#include <vector>

#include <glisson/contact/surface/surface_shape.hpp>
#include <glisson/core/model.hpp>

namespace glisson::contact {

/// Positions are relative to the centre of rotation.
struct SurfaceData {
  std::vector<SurfaceNode<double>> nodes;
  std::vector<SurfaceFacet<double>> facets;
  std::vector<bool> closed;  ///< the facet's part of the surface has no border  [facets]
  double reach = 0;          ///< default contact distance: the largest height of its triangles [m]
  Vec3<double> centre;       ///< that positions are measured from [m]

  SurfaceShape<double> shape() const {
    return {nodes.data(), facets.data(), static_cast<int>(nodes.size()), reach};
  }
};
SurfaceData surface_data(const SurfaceMesh& surface, const Vec3<double>& centre);

/// x = turn q + shift + centre.
struct SurfacePose {
  Mat3<double> turn;
  Vec3<double> shift;  ///< [m]
};
SurfacePose pose_at(const RigidSurface& surface, double t);
/// The same motion with another point in place of the surface's centre.
SurfacePose pose_about(const Vec3<double>& centre, const RigidSurface& surface, double t);

/// a^T v
template <class R>
GLISSON_HD Vec3<R> transposed_times(const Mat3<R>& a, const Vec3<R>& v) {
  return {a.m[0][0] * v.x + a.m[1][0] * v.y + a.m[2][0] * v.z,
          a.m[0][1] * v.x + a.m[1][1] * v.y + a.m[2][1] * v.z,
          a.m[0][2] * v.x + a.m[1][2] * v.y + a.m[2][2] * v.z};
}
template <class R>
GLISSON_HD Vec3<R> times(const Mat3<R>& a, const Vec3<R>& v) {
  return {a.m[0][0] * v.x + a.m[0][1] * v.y + a.m[0][2] * v.z,
          a.m[1][0] * v.x + a.m[1][1] * v.y + a.m[1][2] * v.z,
          a.m[2][0] * v.x + a.m[2][1] * v.y + a.m[2][2] * v.z};
}

}  // namespace glisson::contact
