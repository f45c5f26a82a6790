// Motion Type="Poses": times with translations and rotations, inline or from a table of values separated by
// commas.
#pragma once

#include <glisson/models/format/reader.hpp>

namespace glisson::detail {

/// Rows of time, x y z and, by the attribute Rotation of the motion, a rotation vector [rad] (absent or
/// Vector), a unit quaternion w x y z (Quaternion) or nothing (None), from its <Table> or the file that its
/// <TableFile> names. Throws Error(input) with file and line: a number that is none, a row too short or too
/// long, fewer than two rows, times that do not increase, a quaternion without length 1, half a turn or more
/// between two rows.
std::vector<RigidPose> read_poses(const Reader& reader, const XmlElement& motion);

}  // namespace glisson::detail
