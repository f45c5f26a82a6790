#include <glisson/models/mesh/transform.hpp>

#include <array>
#include <cmath>
#include <string>

#include <glisson/core/base/error.hpp>

namespace glisson {
namespace {

using Rows = std::array<Vec3<double>, 3>;

/// Rx Ry Rz by rows.
Rows rotation(const Vec3<double>& degrees) {
  const double degree = std::acos(-1.0) / 180;
  const double ca = std::cos(degree * degrees.x), sa = std::sin(degree * degrees.x);
  const double cb = std::cos(degree * degrees.y), sb = std::sin(degree * degrees.y);
  const double cc = std::cos(degree * degrees.z), sc = std::sin(degree * degrees.z);
  return {Vec3<double>{cb * cc, -cb * sc, sb},
          Vec3<double>{sa * sb * cc + ca * sc, ca * cc - sa * sb * sc, -sa * cb},
          Vec3<double>{sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb}};
}

Vec3<double> moved(const Transform& t, const Rows& R, const Vec3<double>& x) {
  const auto d = x - t.centre;
  return t.scale * (Vec3<double>{dot(R[0], d), dot(R[1], d), dot(R[2], d)} + t.centre) + t.translation;
}

bool finite(const Vec3<double>& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); }

}  // namespace

Vec3<double> transformed(const Transform& transform, const Vec3<double>& x) {
  return moved(transform, rotation(transform.angles), x);
}

void transform_nodes(const Transform& transform, std::span<Vec3<double>> X) {
  if (!(transform.scale > 0) || !std::isfinite(transform.scale) || !finite(transform.centre) ||
      !finite(transform.angles) || !finite(transform.translation))
    throw Error(ErrorKind::usage, "a transform needs finite numbers and a positive scale (" +
                                      std::to_string(transform.scale) +
                                      "), else the mesh is turned inside out");
  const auto R = rotation(transform.angles);
  for (auto& x : X) x = moved(transform, R, x);
}

}  // namespace glisson
