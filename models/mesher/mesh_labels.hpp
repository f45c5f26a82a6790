// From a segmented image to a mesh: one hexahedron, or six tetrahedra, per coarsened voxel. Staircase
// surfaces, perfect elements.
#pragma once

#include <cstdint>
#include <glisson/core/mesh/mesh.hpp>
#include <glisson/models/image/label_image.hpp>
#include <string>
#include <vector>

namespace glisson {

struct MesherOptions {
  double voxel_mm = 0;  ///< edge of a hexahedron [mm]
  Shape element = Shape::tetrahedron;
  std::vector<int> labels;    ///< what is meshed; empty: everything but 0
  bool one_region = false;    ///< all chosen labels become one region with the smallest of them
  int min_component = 8;      ///< face-connected pieces with fewer coarse voxels are dropped
  bool largest_only = false;  ///< keeps only the largest face-connected piece
  double scale = 1;           ///< of the node positions: 0.001 gives metres
  std::int64_t max_elements = 20'000'000;
};

/// What became of one label.
struct MeshedRegion {
  int label = 0;
  double image_mm3 = 0, mesh_mm3 = 0;
  std::int64_t element_count = 0;
};

struct LabelMesh {
  Mesh mesh;  ///< positions in world coordinates, times scale; Mesh::label from the image
  std::vector<MeshedRegion> regions;  ///< in the order of their labels
  std::vector<std::string> warnings;  ///< what was dropped or cut loose, one line each
};

/// The coarse grid follows the image's axes and begins at its corner; its voxels have edges of exactly
/// voxel_mm, whatever the image's spacing. A coarse voxel is meshed if at least half of its volume is covered
/// by chosen labels, and gets the label that covers most of it (the smaller label if two cover the same).
/// Pieces that touch only along an edge or at a node get nodes of their own there, so that every piece is a
/// solid. Same input, same mesh, bit for bit. Throws Error(input) if nothing is selected (naming the labels
/// that are there), Error(usage) for impossible options.
LabelMesh mesh_labels(const LabelImage& image, const MesherOptions& options);

/// Labels of an image with their voxel counts: "127 (316205 voxels), 255 (...)"; at most the 20 most
/// frequent.
std::string label_summary(const LabelImage& image);

}  // namespace glisson
