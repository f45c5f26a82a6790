// Segmented images: one whole number per voxel that says which organ it belongs to. Read from NIfTI and
// INRIMAGE files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glisson/core/tensor/tensor.hpp>
#include <span>
#include <string>
#include <vector>

namespace glisson {

struct LabelImage {
  std::array<int, 3> size{};  ///< voxels along i, j, k [-]
  std::array<std::array<double, 4>, 3>
      to_world{};                    ///< [mm]: x_a = sum_b to_world[a][b] index_b + to_world[a][3]
  std::vector<std::int32_t> labels;  ///< i fastest, 0 is background [-]  [size[2]][size[1]][size[0]]

  std::int32_t label(int i, int j, int k) const {
    const auto n0 = static_cast<std::size_t>(size[0]), n1 = static_cast<std::size_t>(size[1]);
    return labels[static_cast<std::size_t>(i) +
                  n0 * (static_cast<std::size_t>(j) + n1 * static_cast<std::size_t>(k))];
  }
  /// Of a position in voxel indices; a voxel's centre is at whole numbers [mm].
  Vec3<double> world(double i, double j, double k) const {
    const auto row = [&](int a) {
      const auto& r = to_world[static_cast<std::size_t>(a)];
      return r[0] * i + r[1] * j + r[2] * k + r[3];
    };
    return {row(0), row(1), row(2)};
  }
};

/// What is read at most: a small compressed file can announce any size.
struct ImageLimits {
  std::int64_t max_voxels = std::int64_t{1} << 29;  ///< 2 GiB of labels
};

/// NIfTI-1 and NIfTI-2 (.nii, one file), INRIMAGE-4 (.inr), each also gzipped; recognised by content. Throws
/// Error(input) with file and place for anything else, images with more than 3 dimensions, and values that
/// are not whole numbers.
LabelImage read_label_image(const std::filesystem::path& path, const ImageLimits& limits = {});

/// The same from memory; `name` stands for the file in messages.
LabelImage parse_label_image(std::span<const unsigned char> file, const std::string& name,
                             const ImageLimits& limits = {});

}  // namespace glisson
