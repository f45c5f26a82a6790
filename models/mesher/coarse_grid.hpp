// Labels on a coarse grid of cubes laid over an image; the first two steps of the mesher.
#pragma once

#include <array>
#include <cstdint>
#include <glisson/models/image/label_image.hpp>
#include <glisson/models/mesher/mesh_labels.hpp>
#include <string>
#include <vector>

namespace glisson::detail {

/// Voxels of the chosen labels, counted in one pass over the image.
struct Selection {
  std::vector<int> labels;             ///< chosen and present, ascending
  std::vector<std::int64_t> voxels;    ///< of each [-]  [labels]
  std::array<int, 3> first{}, last{};  ///< box that holds them, both ends included [voxel index]
};
Selection select(const LabelImage& image, const std::vector<int>& labels);

/// The part of the coarse grid that can hold chosen labels. Coarse voxel c begins at voxel coordinate c *
/// ratio - 1/2.
struct CoarseGrid {
  std::array<double, 3> ratio{};  ///< coarse edge in image voxels [-]
  std::array<int, 3> first{};     ///< grid index of the first coarse voxel held here
  std::array<int, 3> size{};      ///< coarse voxels held
  std::vector<int> region;  ///< index into Selection::labels; -1: background  [size[2]][size[1]][size[0]]

  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size[0]) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(k));
  }
  bool filled(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2] &&
           region[index(i, j, k)] >= 0;
  }
};

/// Lengths of the image's voxels along its axes [mm].
std::array<double, 3> spacing_of(const LabelImage& image);

CoarseGrid coarsen(const LabelImage& image, const Selection& selection, const MesherOptions& options);

/// Empties pieces that are too small or not the largest; adds a warning for what was dropped.
void drop_small_pieces(CoarseGrid& grid, const MesherOptions& options, std::vector<std::string>& warnings);

}  // namespace glisson::detail
