// Where a rigid surface is at a list of times, and in between.
#pragma once

#include <array>
#include <vector>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// w x y z; a rotation has length 1.
using Quaternion = std::array<double, 4>;

/// x = R(turn) (X - centre) + centre + shift.
struct RigidPose {
  double time = 0;              ///< [s]
  Vec3<double> shift;           ///< of the centre [m]
  Quaternion turn{1, 0, 0, 0};  ///< unit
};

/// Rotation about the direction of v by its length [rad] (Rodrigues 1840).
Quaternion quaternion_of(const Vec3<double>& v);
Mat3<double> matrix_of(const Quaternion& q);
double length_of(const Quaternion& q);
/// Least angle between two rotations, 0 to pi [rad].
double angle_between(const Quaternion& a, const Quaternion& b);

/// From row to row the shift is linear and the rotation goes about one axis at one speed, the shorter way
/// (Shoemake 1985, slerp): velocities jump at the rows. Before the first and after the last it stands. The
/// table is not empty, its times increase.
RigidPose pose_in(const std::vector<RigidPose>& table, double t);

}  // namespace glisson
