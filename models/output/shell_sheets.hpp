// Membranes and shells as surfaces with fields: the mid-surface, and the faces that close their thickness.
#pragma once

#include <glisson/models/output/vtp_writer.hpp>

namespace glisson {

/// A surface with copies of the values on it; fields() are views on them.
struct ShellSheet {
  TriangleSurface surface;                                           ///< at rest
  std::vector<Vec3<double>> displacement, velocity, internal_force;  ///< [points] or empty
  std::vector<double> node;                                          ///< of the mesh [-] [points]
  std::vector<double> set;                                           ///< of each triangle [-] [triangles]
  std::vector<double> side;  ///< 1: on the side of the normal, -1: on the other, 0: border; or empty
  ShellFields values;        ///< [triangles] each, or empty

  /// displacement, velocity, internal_force and node on points; on triangles stress, strain, J, area_ratio,
  /// thickness, membrane_force, and with rotation-free shells moment and curvature; energy on the
  /// mid-surface; set, and side on the faces. Empty arrays are left out.
  Fields fields() const;
};

/// Nodes and triangles of the shells; nodes of solids alone are left out.
ShellSheet mid_surface(const Mesh& mesh, const Snapshot& snapshot);

/// Both faces, half the thickness away along the mean normals of the nodes, and the strips that close them at
/// borders; the displacement carries the thickness now. Stress and strain are those at the faces, linear
/// through the thickness. Nodes have a point of their own for each surface that meets there: across an edge
/// of three triangles or of two with opposite orientation the faces end.
ShellSheet shell_faces(const Mesh& mesh, const Snapshot& snapshot);

}  // namespace glisson
